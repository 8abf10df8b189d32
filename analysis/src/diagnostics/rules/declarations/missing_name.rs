//! T0210 missing-name.

use crate::diagnostics::{Rule, Severity};

/// T0210 missing-name.
pub static MISSING_NAME: Rule = Rule {
    code: "T0210",
    name: "missing-name",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Memory is reserved without a name, so nothing can use it. Put `NAME:` before DS or STR, or delete \
        the line.",
    why: "The bytes are lost, and all that follows lies further than the reader counts.",
    wrong: "\
DATA
DS 2
DATA_END
",
    right: "\
DATA
RESERVE: DS 2
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
