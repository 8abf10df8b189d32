//! T1140 unused-label.

use crate::diagnostics::{Rule, Severity};

/// T1140 unused-label.
pub static UNUSED_LABEL: Rule = Rule {
    code: "T1140",
    name: "unused-label",
    severity: Severity::Hint,
    fixed: false,
    explanation: "No instruction of the module, mechanism or procedure names the label, so no jump leads to it. \
        Remove it.",
    why: "A reader who finds a label looks for the jump that leads to it.",
    wrong: "\
LDR START
WR MOTOR
READY:
",
    right: "\
LDR START
WR MOTOR
",
    unnecessary: true,
    ..Rule::BASE
};
