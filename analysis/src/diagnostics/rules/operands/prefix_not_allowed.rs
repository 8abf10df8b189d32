//! T0404 prefix-not-allowed.

use crate::diagnostics::{Rule, Severity};

/// T0404 prefix-not-allowed.
pub static PREFIX_NOT_ALLOWED: Rule = Rule {
    code: "T0404",
    name: "prefix-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction does not take this type prefix or declared type (manual 3.9 lists them).",
    why: "Each instruction is built for certain widths only; the control would execute another width than \
        written.",
    wrong: "\
LOD LARGE
MULB QWRD.RATIO
STO LARGE
",
    right: "\
LOD LARGE
MULB MIDDLE
STO LARGE
",
    chapter: "3.9",
    ..Rule::BASE
};
