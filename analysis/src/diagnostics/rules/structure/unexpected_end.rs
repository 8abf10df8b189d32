//! T0607 unexpected-end.

use crate::diagnostics::{Rule, Severity};

/// T0607 unexpected-end.
pub static UNEXPECTED_END: Rule = Rule {
    code: "T0607",
    name: "unexpected-end",
    severity: Severity::Error,
    fixed: true,
    explanation: "A closing line has no opening line of its kind, or names another mechanism or procedure than the \
        one that is open.",
    why: "One of the two names is wrong, and with it what belongs to which mechanism.",
    wrong: "\
MECH_BEGIN CLAMP
FL 1,MOTOR
EX
MECH_END CLAPM
FL 1,CLAMP
",
    right: "\
MECH_BEGIN CLAMP
FL 1,MOTOR
EX
MECH_END CLAMP
FL 1,CLAMP
",
    chapter: "4.2",
    fix: true,
    ..Rule::BASE
};
