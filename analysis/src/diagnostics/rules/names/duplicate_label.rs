//! T0303 duplicate-label.

use crate::diagnostics::{Rule, Severity};

/// T0303 duplicate-label.
pub static DUPLICATE_LABEL: Rule = Rule {
    code: "T0303",
    name: "duplicate-label",
    severity: Severity::Error,
    fixed: true,
    explanation: "A label stands twice in one module, mechanism or procedure, so a jump to it is ambiguous. Rename \
        one.",
    why: "A jump could lead to either of the two places.",
    wrong: "\
LDR START
JL0 OVER
FL 1,MOTOR
OVER:
LDR DOOR
JL0 OVER2
FL 1,LAMP
OVER:
OVER2:
",
    right: "\
LDR START
JL0 OVER
FL 1,MOTOR
OVER:
LDR DOOR
JL0 OVER2
FL 1,LAMP
OVER2:
",
    chapter: "3.3",
    ..Rule::BASE
};
