//! T0608 wrong-place.

use crate::diagnostics::{Rule, Severity};

/// T0608 wrong-place.
pub static WRONG_PLACE: Rule = Rule {
    code: "T0608",
    name: "wrong-place",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction cannot stand here: code belongs into modules, DFM and DS into DATA or DATA_LOCAL, \
        PROC_BEGIN into MODULE_MAIN, MECH_BEGIN into MODULE_MAIN or MODULE_FAST (manual 5.2).",
    why: "Each module has its moment in the cycle; code outside of them has none, and memory that is \
        declared among code has no place.",
    wrong: "\
MODULE_INIT
PROC_BEGIN AT_REST
FL 0,MOTOR
PROC_END AT_REST
PROC_CALL AT_REST
MODULE_INIT_END
",
    right: "\
MODULE_MAIN
PROC_BEGIN AT_REST
FL 0,MOTOR
PROC_END AT_REST
PROC_CALL AT_REST
MODULE_MAIN_END
",
    chapter: "5.2",
    ..Rule::BASE
};
