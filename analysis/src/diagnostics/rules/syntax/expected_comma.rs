//! T0107 expected-comma.

use crate::diagnostics::{Rule, Severity};

/// T0107 expected-comma.
pub static EXPECTED_COMMA: Rule = Rule {
    code: "T0107",
    name: "expected-comma",
    severity: Severity::Error,
    fixed: true,
    explanation: "Operands are separated by commas; a blank between two of them is not enough (manual 3.1).",
    why: "Two names beside each other may be two operands or one that was typed wrongly; the comma tells.",
    wrong: "\
FL 1,MOTOR LAMP
",
    right: "\
FL 1,MOTOR,LAMP
",
    chapter: "3.1",
    fix: true,
    ..Rule::BASE
};
