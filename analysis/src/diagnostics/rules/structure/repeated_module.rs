//! T0603 repeated-module.

use crate::diagnostics::{Rule, Severity};

/// T0603 repeated-module.
pub static REPEATED_MODULE: Rule = Rule {
    code: "T0603",
    name: "repeated-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module stands once in a file; only DATA_LOCAL may be repeated (manual 5.2). Join the two.",
    ..Rule::BASE
};
