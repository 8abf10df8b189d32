//! T0102 typographic-quote.

use crate::diagnostics::{Rule, Severity};

/// T0102 typographic-quote.
pub static TYPOGRAPHIC_QUOTE: Rule = Rule {
    code: "T0102",
    name: "typographic-quote",
    severity: Severity::Error,
    fixed: true,
    explanation: "Texts stand in apostrophes `'…'`. Quotes that a word processor put in their place are not read. \
        The fix replaces them.",
    ..Rule::BASE
};
