//! T0607 unexpected-end.

use crate::diagnostics::{Rule, Severity};

/// T0607 unexpected-end.
pub static UNEXPECTED_END: Rule = Rule {
    code: "T0607",
    name: "unexpected-end",
    severity: Severity::Error,
    fixed: true,
    explanation: "A closing line has no opening line of its kind, or names another mechanism or procedure than the \
        one that is open.",
    ..Rule::BASE
};
