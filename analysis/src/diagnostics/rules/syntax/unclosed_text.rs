//! T0103 unclosed-text.

use crate::diagnostics::{Rule, Severity};

/// T0103 unclosed-text.
pub static UNCLOSED_TEXT: Rule = Rule {
    code: "T0103",
    name: "unclosed-text",
    severity: Severity::Error,
    fixed: true,
    explanation: "A text begins with an apostrophe and never ends on its line. Close it; an apostrophe inside a text \
        is written twice.",
    ..Rule::BASE
};
