//! T1143 unused-macro.

use crate::diagnostics::{Rule, Severity};

/// T1143 unused-macro.
pub static UNUSED_MACRO: Rule = Rule {
    code: "T1143",
    name: "unused-macro",
    severity: Severity::Hint,
    fixed: false,
    explanation: "A macro that a program file defines is not used anywhere in the project. Remove it. Macros of \
        included files are not looked at.",
    why: "Readers look for where it is used.",
    wrong: "\
DEF_T_MACRO AT_REST
FL 0,MOTOR
END_T_MACRO
MODULE_MAIN
MODULE_MAIN_END
",
    right: "\
MODULE_MAIN
FL 0,MOTOR
MODULE_MAIN_END
",
    chapter: "22",
    unnecessary: true,
    ..Rule::BASE
};
