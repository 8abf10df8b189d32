//! T0404 prefix-not-allowed.

use crate::diagnostics::{Rule, Severity};

/// T0404 prefix-not-allowed.
pub static PREFIX_NOT_ALLOWED: Rule = Rule {
    code: "T0404",
    name: "prefix-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction does not take this type prefix or declared type (manual 3.9 lists them).",
    ..Rule::BASE
};
