//! T0202 long-name.

use crate::diagnostics::{Rule, Severity};

/// T0202 long-name.
pub static LONG_NAME: Rule = Rule {
    code: "T0202",
    name: "long-name",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Only the first 31 characters of a name are significant (manual 3.3): two names that differ later \
        are one name. Shorten it.",
    why: "Two names that differ only behind the 31st character are one and the same cell without anybody \
        noticing.",
    wrong: "\
DATA
HYDRAULIC_PRESSURE_OF_THE_MAIN_CHUCK: DS 2
DATA_END
",
    right: "\
DATA
HYDRAULIC_PRESSURE_CHUCK: DS 2
DATA_END
",
    chapter: "3.3",
    ..Rule::BASE
};
