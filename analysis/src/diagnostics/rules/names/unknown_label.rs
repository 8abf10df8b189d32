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
    why: "The jump has no target.",
    wrong: "\
LDR START
JL0 REDAY
FL 1,MOTOR
READY:
",
    right: "\
LDR START
JL0 READY
FL 1,MOTOR
READY:
",
    chapter: "3.12",
    fix: true,
    ..Rule::BASE
};
