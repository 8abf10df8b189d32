//! T0408 division-by-zero.

use crate::diagnostics::{Rule, Severity};

/// T0408 division-by-zero.
pub static DIVISION_BY_ZERO: Rule = Rule {
    code: "T0408",
    name: "division-by-zero",
    severity: Severity::Error,
    fixed: true,
    explanation: "DIVB by a constant zero would stop the PLC with a fault each time (manual 3.12).",
    ..Rule::BASE
};
