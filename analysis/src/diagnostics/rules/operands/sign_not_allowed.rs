//! T0405 sign-not-allowed.

use crate::diagnostics::{Rule, Severity};

/// T0405 sign-not-allowed.
pub static SIGN_NOT_ALLOWED: Rule = Rule {
    code: "T0405",
    name: "sign-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "A `-` that negates is allowed only where the operand is read by LDR, LA, LO, LX and LOD (manual \
        3.5, 3.10) and before constants.",
    why: "A destination has no sign: the negation would be lost.",
    wrong: "\
LDR START
WR -MOTOR
",
    right: "\
LDR -START
WR MOTOR
",
    chapter: "3.5",
    ..Rule::BASE
};
