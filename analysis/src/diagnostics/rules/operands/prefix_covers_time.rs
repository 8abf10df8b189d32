//! T0413 prefix-covers-time.

use crate::diagnostics::{Rule, Severity};

/// T0413 prefix-covers-time.
pub static PREFIX_COVERS_TIME: Rule = Rule {
    code: "T0413",
    name: "prefix-covers-time",
    severity: Severity::Error,
    fixed: true,
    explanation: "A type prefix on the counter of TEX0, TEX1 or TIM also covers the time, which then cannot be a \
        constant (manual 4.2). Remove the prefix or put the time into a cell.",
    why: "A constant has no address, and the prefix makes the instruction fetch the time from one.",
    wrong: "\
MECH_BEGIN WAIT_DOOR
TIM WORD.TABLE,50
MECH_END WAIT_DOOR
FL 1,WAIT_DOOR
",
    right: "\
MECH_BEGIN WAIT_DOOR
TIM MIDDLE,50
MECH_END WAIT_DOOR
FL 1,WAIT_DOOR
",
    chapter: "3.11",
    ..Rule::BASE
};
