//! T0209 text-too-long.

use crate::diagnostics::{Rule, Severity};

/// T0209 text-too-long.
pub static TEXT_TOO_LONG: Rule = Rule {
    code: "T0209",
    name: "text-too-long",
    severity: Severity::Error,
    fixed: true,
    explanation: "The initial text is longer than its STR (manual 3.18). Declare a larger one or shorten the text.",
    why: "The text would run into the cells behind the buffer.",
    wrong: "\
DATA
TITLE: STR 4,'SPINDLE'
DATA_END
",
    right: "\
DATA
TITLE: STR 8,'SPINDLE'
DATA_END
",
    chapter: "3.18",
    ..Rule::BASE
};
