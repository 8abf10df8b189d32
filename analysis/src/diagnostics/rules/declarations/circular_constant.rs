//! T0206 circular-constant.

use crate::diagnostics::{Rule, Severity};

/// T0206 circular-constant.
pub static CIRCULAR_CONSTANT: Rule = Rule {
    code: "T0206",
    name: "circular-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "The value of an EQUI constant depends on itself. Break the circle with a number.",
    ..Rule::BASE
};
