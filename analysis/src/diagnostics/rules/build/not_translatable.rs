//! T0803 not-translatable.

use crate::diagnostics::{Rule, Severity};

/// T0803 not-translatable.
pub static NOT_TRANSLATABLE: Rule = Rule {
    code: "T0803",
    name: "not-translatable",
    severity: Severity::Error,
    fixed: true,
    explanation: "The line is well formed, but there is no code for it: CLEAR over two data areas, a symbol without \
        memory, a mechanism or procedure that stands in no module.",
    why: "The mistake shows only when code is made of it.",
    wrong: "\
CLEAR LARGE,SMALL
",
    right: "\
CLEAR SMALL,LARGE
",
    ..Rule::BASE
};
