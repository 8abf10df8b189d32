//! T0605 stop-misplaced.

use crate::diagnostics::{Rule, Severity};

/// T0605 stop-misplaced.
pub static STOP_MISPLACED: Rule = Rule {
    code: "T0605",
    name: "stop-misplaced",
    severity: Severity::Error,
    fixed: true,
    explanation: "The main file ends with STOP after its last module (manual 5.1); nothing but comments may follow \
        it.",
    ..Rule::BASE
};
