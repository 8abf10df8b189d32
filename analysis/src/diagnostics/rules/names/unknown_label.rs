//! T0302 unknown-label.

use crate::diagnostics::{Rule, Severity};

/// T0302 unknown-label.
pub static UNKNOWN_LABEL: Rule = Rule {
    code: "T0302",
    name: "unknown-label",
    severity: Severity::Error,
    fixed: true,
    explanation: "The jump leads to a label that does not stand in the same module, mechanism or procedure. Jumps do \
        not cross their borders. Put `NAME:` before the target.",
    ..Rule::BASE
};
