//! T0603 repeated-module.

use crate::diagnostics::{Rule, Severity};

/// T0603 repeated-module.
pub static REPEATED_MODULE: Rule = Rule {
    code: "T0603",
    name: "repeated-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module stands once in a file; only DATA_LOCAL may be repeated (manual 5.2). Join the two.",
    why: "It is not known which of the two comes first; joined, the order is what the reader sees.",
    wrong: "\
MODULE_HALT
FL 0,MOTOR
MODULE_HALT_END
MODULE_HALT
FL 0,LAMP
MODULE_HALT_END
",
    right: "\
MODULE_HALT
FL 0,MOTOR
FL 0,LAMP
MODULE_HALT_END
",
    chapter: "5.2",
    ..Rule::BASE
};
