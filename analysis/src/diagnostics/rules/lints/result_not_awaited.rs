//! T1102 result-not-awaited.

use crate::diagnostics::{Rule, Severity};

/// T1102 result-not-awaited.
pub static RESULT_NOT_AWAITED: Rule = Rule {
    code: "T1102",
    name: "result-not-awaited",
    severity: Severity::Warning,
    explanation: "PLCT_ and ECAT_ instructions take several cycles and give RLO 0 until they have finished. The line behind this one \
        neither waits for RLO 1 nor looks at it, so the program goes on before there is a result. Put EX0 or TEX0 \
        directly behind it; EX1 and TEX1 wait the other way round.",
    why: "The target still has its old content, and a second instruction is started over the first one.",
    wrong: "\
FL 1,READER
MECH_BEGIN READER
    PLCT_GET_SELLINE 0,MIDDLE
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
