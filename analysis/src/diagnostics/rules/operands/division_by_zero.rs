//! T0408 division-by-zero.

use crate::diagnostics::{Rule, Severity};

/// T0408 division-by-zero.
pub static DIVISION_BY_ZERO: Rule = Rule {
    code: "T0408",
    name: "division-by-zero",
    severity: Severity::Error,
    fixed: true,
    explanation: "DIVB by a constant zero would stop the PLC with a fault each time (manual 3.12).",
    why: "The control stops with a fatal error when it divides by zero.",
    wrong: "\
LOD LARGE
DIVB CNST.0
STO LARGE
",
    right: "\
LOD LARGE
DIVB CNST.10
STO LARGE
",
    chapter: "3.14",
    ..Rule::BASE
};
