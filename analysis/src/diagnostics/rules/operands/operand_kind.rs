//! T0402 operand-kind.

use crate::diagnostics::{Rule, Severity};

/// T0402 operand-kind.
pub static OPERAND_KIND: Rule = Rule {
    code: "T0402",
    name: "operand-kind",
    severity: Severity::Error,
    fixed: true,
    explanation: "The operand has a form this instruction does not take. The message says what it needs.",
    why: "The instruction has no machine code for this form of operand.",
    wrong: "\
FL 1,5
",
    right: "\
FL 1,MOTOR
",
    chapter: "3.9",
    ..Rule::BASE
};
