//! T1104 error-not-tested.

use crate::diagnostics::{Rule, Severity};

/// T1104 error-not-tested.
pub static ERROR_NOT_TESTED: Rule = Rule {
    code: "T1104",
    name: "error-not-tested",
    severity: Severity::Info,
    explanation: "A PLCT_ or ECAT_ instruction ends with RLO 1 whether it succeeded or not; DR is 0 or the number of the error. \
        The line behind the wait does not look at DR. Compare it by `EQ CNST.0` and jump by JL0, or keep it by STO.",
    why: "A table that is not there, or a slave that does not answer, then looks like a result.",
    wrong: "\
FL 1,READER
MECH_BEGIN READER
    PLCT_GET_SELLINE 0,MIDDLE
    EX0
    LOD  MIDDLE
    STO  LARGE
MECH_END READER
",
    right: "\
FL 1,READER
MECH_BEGIN READER
    PLCT_GET_SELLINE 0,MIDDLE
    EX0
    EQ   CNST.0
    JL0  FAILED
    LOD  MIDDLE
    STO  LARGE
FAILED:
MECH_END READER
",
    chapter: "17.4",
    ..Rule::BASE
};
