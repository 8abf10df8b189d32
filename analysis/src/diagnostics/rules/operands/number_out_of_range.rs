//! T0407 number-out-of-range.

use crate::diagnostics::{Rule, Severity};

/// T0407 number-out-of-range.
pub static NUMBER_OUT_OF_RANGE: Rule = Rule {
    code: "T0407",
    name: "number-out-of-range",
    severity: Severity::Error,
    fixed: true,
    explanation: "The number is outside what the operand allows; the message gives the bounds.",
    ..Rule::BASE
};
