//! T1150 always-the-same.

use crate::diagnostics::{Rule, Severity};

/// T1150 always-the-same.
pub static ALWAYS_THE_SAME: Rule = Rule {
    code: "T1150",
    name: "always-the-same",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The comparison always gives the same result: a BYTE or WORD cell loads with its sign, -128 to \
        127 or -32768 to 32767, and the constant lies outside. Compare at the width of the cell: \
        `LT BYTE.200` for values above 127, or load the cell into a DR that was cleared and \
        extended by hand.",
    why: "The condition looks as if it decided something.",
    wrong: "\
LOD SMALL
LT CNST.200
WR LAMP
",
    right: "\
LOD MIDDLE
LT CNST.200
WR LAMP
",
    ..Rule::BASE
};
