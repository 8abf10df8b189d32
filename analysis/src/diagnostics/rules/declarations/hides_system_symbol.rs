//! T0212 hides-system-symbol.

use crate::diagnostics::{Rule, Severity};

/// T0212 hides-system-symbol.
pub static HIDES_SYSTEM_SYMBOL: Rule = Rule {
    code: "T0212",
    name: "hides-system-symbol",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The name is also a predefined cell or bit of the control. The declaration hides it, so the program \
        reads and writes its own memory instead. Rename it unless this is meant.",
    why: "The rest of the program and its readers take the name for the control's own cell, and the \
        control never sees what is written here.",
    wrong: "\
DATA
P1IN: DS 1
DATA_END
",
    right: "\
DATA
IMAGE_P1: DS 1
DATA_END
",
    chapter: "8",
    ..Rule::BASE
};
