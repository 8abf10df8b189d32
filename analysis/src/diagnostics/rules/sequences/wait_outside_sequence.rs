//! T0701 wait-outside-sequence.

use crate::diagnostics::{Rule, Severity};

/// T0701 wait-outside-sequence.
pub static WAIT_OUTSIDE_SEQUENCE: Rule = Rule {
    code: "T0701",
    name: "wait-outside-sequence",
    severity: Severity::Error,
    fixed: true,
    explanation: "EX, EX0, EX1, BEX, TEX0, TEX1 and TIM hold a sequence; they may stand only in a mechanism or \
        directly in MODULE_BLOCK_INIT and MODULE_BLOCK_DONE, not in a procedure (manual 4.3).",
    why: "To wait means to leave the sequence and to come back in the next cycle. Only mechanisms and the \
        block modules remember where to come back to.",
    wrong: "\
LDR DOOR
EX0
FL 1,MOTOR
",
    right: "\
MECH_BEGIN CLOSE
LDR DOOR
EX0
FL 1,MOTOR
MECH_END CLOSE
FL 1,CLOSE
",
    chapter: "4.3",
    ..Rule::BASE
};
