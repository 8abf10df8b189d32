//! T0204 conflicting-constant.

use crate::diagnostics::{Rule, Severity};

/// T0204 conflicting-constant.
pub static CONFLICTING_CONSTANT: Rule = Rule {
    code: "T0204",
    name: "conflicting-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "EQUI gives one name two different values; constants are known in the whole project. Remove one or \
        rename it.",
    ..Rule::BASE
};
