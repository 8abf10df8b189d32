//! T0403 untyped-area.

use crate::diagnostics::{Rule, Severity};

/// T0403 untyped-area.
pub static UNTYPED_AREA: Rule = Rule {
    code: "T0403",
    name: "untyped-area",
    severity: Severity::Error,
    fixed: true,
    explanation: "The area has no type (its DS is not 1, 2 or 4), so the width of the access is unknown. Put \
        `BYTE.`, `WORD.`, `DWRD.`, `QWRD.` or `REAL.` before it (manual 3.9).",
    why: "One byte, two or four can be meant, and the wrong choice reads or destroys neighbours.",
    wrong: "\
LOD TABLE
STO SMALL
",
    right: "\
LOD BYTE.TABLE
STO SMALL
",
    chapter: "3.9",
    ..Rule::BASE
};
