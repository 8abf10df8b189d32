//! T0415 never-equal.

use crate::diagnostics::{Rule, Severity};

/// T0415 never-equal.
pub static NEVER_EQUAL: Rule = Rule {
    code: "T0415",
    name: "never-equal",
    severity: Severity::Warning,
    fixed: false,
    explanation: "LOD extends the sign of what it loads (manual 3.10): a BYTE cell that holds 0FFh loads as -1, so a \
        comparison with a 32-bit constant of 128 to 255 is never true; the same holds for a WORD cell and 32768 to \
        65535. Compare at the width of the cell (`EQ BYTE.0FFh`) or mask DR first (`ANDB CNST.0FFh`).",
    why: "LOD extends the sign: the byte 0FFh arrives as -1. The comparison looks right and is never true.",
    wrong: "\
LOD SMALL
EQ CNST.255
WR MOTOR
",
    right: "\
LOD SMALL
EQ BYTE.255
WR MOTOR
",
    chapter: "3.15",
    ..Rule::BASE
};
