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
    ..Rule::BASE
};
