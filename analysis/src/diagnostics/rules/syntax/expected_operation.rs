//! T0108 expected-operation.

use crate::diagnostics::{Rule, Severity};

/// T0108 expected-operation.
pub static EXPECTED_OPERATION: Rule = Rule {
    code: "T0108",
    name: "expected-operation",
    severity: Severity::Error,
    fixed: true,
    explanation: "A line begins with a label and its colon, an instruction, or a comment after `;`.",
    ..Rule::BASE
};
