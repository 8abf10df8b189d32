//! T1142 unused-procedure.

use crate::diagnostics::{Rule, Severity};

/// T1142 unused-procedure.
pub static UNUSED_PROCEDURE: Rule = Rule {
    code: "T1142",
    name: "unused-procedure",
    severity: Severity::Hint,
    fixed: false,
    explanation: "Nothing in the project calls the procedure. Remove it. The procedures that the control calls, \
        `_ON_ESET`, `_ON_CMD` and `_ON_EVENT`, need no call.",
    why: "It takes memory, and readers look for where it is called.",
    wrong: "\
PROC_BEGIN AT_REST
FL 0,MOTOR
PROC_END AT_REST
",
    right: "\
PROC_CALL AT_REST
PROC_BEGIN AT_REST
FL 0,MOTOR
PROC_END AT_REST
",
    unnecessary: true,
    ..Rule::BASE
};
