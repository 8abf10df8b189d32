//! T0704 recursion.

use crate::diagnostics::{Rule, Severity};

/// T0704 recursion.
pub static RECURSION: Rule = Rule {
    code: "T0704",
    name: "recursion",
    severity: Severity::Error,
    fixed: true,
    explanation: "A procedure calls itself, directly or through others. Procedures have no stack of their own, so a \
        call inside itself never returns properly.",
    ..Rule::BASE
};
