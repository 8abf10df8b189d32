//! T0202 long-name.

use crate::diagnostics::{Rule, Severity};

/// T0202 long-name.
pub static LONG_NAME: Rule = Rule {
    code: "T0202",
    name: "long-name",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Only the first 31 characters of a name are significant (manual 3.3): two names that differ later \
        are one name. Shorten it.",
    ..Rule::BASE
};
