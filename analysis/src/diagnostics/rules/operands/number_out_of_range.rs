//! T0407 number-out-of-range.

use crate::diagnostics::{Rule, Severity};

/// T0407 number-out-of-range.
pub static NUMBER_OUT_OF_RANGE: Rule = Rule {
    code: "T0407",
    name: "number-out-of-range",
    severity: Severity::Error,
    fixed: true,
    explanation: "The number is outside what the operand allows; the message gives the bounds.",
    why: "Numbers outside the range have no meaning for the instruction.",
    wrong: "\
FL 2,MOTOR
",
    right: "\
FL 1,MOTOR
",
    chapter: "3.9",
    ..Rule::BASE
};
