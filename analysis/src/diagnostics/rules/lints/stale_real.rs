//! T1155 stale-real.

use crate::diagnostics::{Rule, Severity};

/// T1155 stale-real.
pub static STALE_REAL: Rule = Rule {
    code: "T1155",
    name: "stale-real",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The instruction computes with DR_REAL, but the one before it worked with integers and left \
        DR_REAL as it was. Put REAL between them: it converts DR.",
    why: "The result comes from a number that was computed long before.",
    wrong: "\
LOD MIDDLE
AD REAL.RATIO
STO REAL.RATIO
",
    right: "\
LOD MIDDLE
REAL
AD REAL.RATIO
STO REAL.RATIO
",
    ..Rule::BASE
};
