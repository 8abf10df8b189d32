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
    why: "The rest of the line, its comment included, would become part of the text.",
    wrong: "\
DATA
TITLE: STR 8,'READY
DATA_END
",
    right: "\
DATA
TITLE: STR 8,'READY'
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
