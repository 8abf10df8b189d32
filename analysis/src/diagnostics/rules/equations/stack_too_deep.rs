//! T0503 stack-too-deep.

use crate::diagnostics::{Rule, Severity};

/// T0503 stack-too-deep.
pub static STACK_TOO_DEEP: Rule = Rule {
    code: "T0503",
    name: "stack-too-deep",
    severity: Severity::Error,
    fixed: true,
    explanation: "The equation stack has 8 cells (manual 3.2). Store a partial result in a bit.",
    ..Rule::BASE
};
