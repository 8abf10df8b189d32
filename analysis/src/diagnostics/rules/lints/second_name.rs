//! T1156 second-name.

use crate::diagnostics::{Rule, Severity};

/// T1156 second-name.
pub static SECOND_NAME: Rule = Rule {
    code: "T1156",
    name: "second-name",
    severity: Severity::Info,
    fixed: false,
    explanation: "A text buffer is declared over exactly the bytes of another one: both are names of one text. Remove \
        one of them, or leave a comment that says what the second name is for.",
    why: "Whoever writes one of the texts writes the other, and the two names do not show it.",
    wrong: "\
DATA
AREA: DS 20
SHOWN: STR 6,AREA
TYPED: STR 6,AREA
DATA_END
",
    right: "\
DATA
AREA: DS 20
SHOWN: STR 6,AREA
TYPED: STR 6,AREA+7
DATA_END
",
    ..Rule::BASE
};
