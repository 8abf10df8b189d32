//! T1141 unused-constant.

use crate::diagnostics::{Rule, Severity};

/// T1141 unused-constant.
pub static UNUSED_CONSTANT: Rule = Rule {
    code: "T1141",
    name: "unused-constant",
    severity: Severity::Hint,
    fixed: false,
    explanation: "A constant that a program file declares with EQUI is not used anywhere in the project. Remove \
        it. Constants of included files are not looked at: they may serve other projects.",
    why: "Whoever changes its value expects that something changes.",
    wrong: "\
DATA
EQUI T_DOOR,50
DATA_END
",
    right: "\
DATA
DATA_END
",
    unnecessary: true,
    ..Rule::BASE
};
