//! T0704 recursion.

use crate::diagnostics::{Rule, Severity};

/// T0704 recursion.
pub static RECURSION: Rule = Rule {
    code: "T0704",
    name: "recursion",
    severity: Severity::Error,
    fixed: true,
    explanation: "A procedure calls itself, directly or through others. Procedures have no stack of their own, so a \
        call inside itself never returns properly.",
    why: "There is one place for a procedure's way back; the second call overwrites it.",
    wrong: "\
PROC_BEGIN DOWN
PROC_CALL UP
PROC_END DOWN
PROC_BEGIN UP
PROC_CALL DOWN
PROC_END UP
PROC_CALL UP
",
    right: "\
PROC_BEGIN DOWN
FL 0,MOTOR
PROC_END DOWN
PROC_BEGIN UP
PROC_CALL DOWN
PROC_END UP
PROC_CALL UP
",
    chapter: "3.17",
    ..Rule::BASE
};
