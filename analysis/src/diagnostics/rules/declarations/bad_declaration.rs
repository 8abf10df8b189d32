//! T0211 bad-declaration.

use crate::diagnostics::{Rule, Severity};

/// T0211 bad-declaration.
pub static BAD_DECLARATION: Rule = Rule {
    code: "T0211",
    name: "bad-declaration",
    severity: Severity::Error,
    fixed: true,
    explanation: "The declaration does not have the form its instruction needs; the message shows it.",
    ..Rule::BASE
};
