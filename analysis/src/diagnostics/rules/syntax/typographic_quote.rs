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
    why: "Word processors and web pages change apostrophes without asking; the compiler knows only the \
        plain one.",
    wrong: "\
DATA
TITLE: STR 8,‘READY’
DATA_END
",
    right: "\
DATA
TITLE: STR 8,'READY'
DATA_END
",
    chapter: "3.4",
    fix: true,
    ..Rule::BASE
};
