//! T1103 jump-decided-by-wait.

use crate::diagnostics::{Rule, Severity};

/// T1103 jump-decided-by-wait.
pub static JUMP_DECIDED_BY_WAIT: Rule = Rule {
    code: "T1103",
    name: "jump-decided-by-wait",
    severity: Severity::Warning,
    explanation: "EX0 and TEX0 go on only when RLO is 1, EX1 and TEX1 only when it is 0. A JL0 or JL1 directly behind one of them \
        therefore always jumps or never does. Behind PLCT_ and ECAT_ instructions the error is in DR: test it by \
        `EQ CNST.0` first.",
    why: "One of the two ways is never taken, usually the one that handles the error.",
    wrong: "\
FL 1,READER
MECH_BEGIN READER
    PLCT_GET_SELLINE 0,MIDDLE
    EX0
    JL1  FAILED
    FL   1,LAMP
FAILED:
MECH_END READER
",
    right: "\
FL 1,READER
MECH_BEGIN READER
    PLCT_GET_SELLINE 0,MIDDLE
    EX0
    EQ   CNST.0
    JL0  FAILED
    FL   1,LAMP
FAILED:
MECH_END READER
",
    chapter: "4.3",
    ..Rule::BASE
};
