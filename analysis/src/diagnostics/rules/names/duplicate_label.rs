//! T0303 duplicate-label.

use crate::diagnostics::{Rule, Severity};

/// T0303 duplicate-label.
pub static DUPLICATE_LABEL: Rule = Rule {
    code: "T0303",
    name: "duplicate-label",
    severity: Severity::Error,
    fixed: true,
    explanation: "A label stands twice in one module, mechanism or procedure, so a jump to it is ambiguous. Rename \
        one.",
    ..Rule::BASE
};
