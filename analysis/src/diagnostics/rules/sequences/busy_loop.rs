//! T0703 busy-loop.

use crate::diagnostics::{Rule, Severity};

/// T0703 busy-loop.
pub static BUSY_LOOP: Rule = Rule {
    code: "T0703",
    name: "busy-loop",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The loop waits for a condition without an EX-type instruction: while it turns, nothing else in the \
        PLC runs, so the condition usually cannot change. Use EX0 or EX1 to wait (manual 4.3).",
    why: "Inputs are copied once in a cycle. Inside the loop they cannot change, so the cycle never ends.",
    wrong: "\
MECH_BEGIN CLOSE
AGAIN:
LDR DOOR
JL0 AGAIN
FL 1,MOTOR
MECH_END CLOSE
FL 1,CLOSE
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
