//! T0108 expected-operation.

use crate::diagnostics::{Rule, Severity};

/// T0108 expected-operation.
pub static EXPECTED_OPERATION: Rule = Rule {
    code: "T0108",
    name: "expected-operation",
    severity: Severity::Error,
    fixed: true,
    explanation: "A line begins with a label and its colon, an instruction, or a comment after `;`.",
    why: "A line without an operation does nothing, so something was left out.",
    wrong: "\
5,START
LDR START
WR MOTOR
",
    right: "\
LDR START
WR MOTOR
",
    chapter: "3.1",
    ..Rule::BASE
};
