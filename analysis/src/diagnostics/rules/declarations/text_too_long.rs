//! T0209 text-too-long.

use crate::diagnostics::{Rule, Severity};

/// T0209 text-too-long.
pub static TEXT_TOO_LONG: Rule = Rule {
    code: "T0209",
    name: "text-too-long",
    severity: Severity::Error,
    fixed: true,
    explanation: "The initial text is longer than its STR (manual 3.18). Declare a larger one or shorten the text.",
    ..Rule::BASE
};
