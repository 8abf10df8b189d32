//! Modules, blocks and what may stand in them.

use crate::diagnostics::{Rule, Severity};

/// T0601 missing-module.
pub static MISSING_MODULE: Rule = Rule {
    code: "T0601",
    name: "missing-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module is mandatory: in the main file DATA, MODULE_INPUT, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE, \
        MODULE_MAIN, MODULE_INIT, MODULE_CLEAR and MODULE_HALT, in further files DATA and MODULE_MAIN \
        (manual 5.4). It may be empty.",
    ..Rule::BASE
};

/// T0602 forbidden-module.
pub static FORBIDDEN_MODULE: Rule = Rule {
    code: "T0602",
    name: "forbidden-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "MODULE_INPUT, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE, MODULE_HALT and MODULE_CONT stand in the main \
        file only (manual 5.2). Move its code there.",
    ..Rule::BASE
};

/// T0603 repeated-module.
pub static REPEATED_MODULE: Rule = Rule {
    code: "T0603",
    name: "repeated-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module stands once in a file; only DATA_LOCAL may be repeated (manual 5.2). Join the two.",
    ..Rule::BASE
};

/// T0604 data-not-first.
pub static DATA_NOT_FIRST: Rule = Rule {
    code: "T0604",
    name: "data-not-first",
    severity: Severity::Error,
    fixed: true,
    explanation: "DATA is the first module of every file; only comments, T_INCLUDE, macros, EQUI and DEBUG may stand \
        before it (manual 5.1).",
    ..Rule::BASE
};

/// T0605 stop-misplaced.
pub static STOP_MISPLACED: Rule = Rule {
    code: "T0605",
    name: "stop-misplaced",
    severity: Severity::Error,
    fixed: true,
    explanation: "The main file ends with STOP after its last module (manual 5.1); nothing but comments may follow \
        it.",
    ..Rule::BASE
};

/// T0606 unclosed-block.
pub static UNCLOSED_BLOCK: Rule = Rule {
    code: "T0606",
    name: "unclosed-block",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module, mechanism, procedure or data block has no closing line. It is taken to end where the \
        next one begins.",
    ..Rule::BASE
};

/// T0607 unexpected-end.
pub static UNEXPECTED_END: Rule = Rule {
    code: "T0607",
    name: "unexpected-end",
    severity: Severity::Error,
    fixed: true,
    explanation: "A closing line has no opening line of its kind, or names another mechanism or procedure than the \
        one that is open.",
    ..Rule::BASE
};

/// T0608 wrong-place.
pub static WRONG_PLACE: Rule = Rule {
    code: "T0608",
    name: "wrong-place",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction cannot stand here: code belongs into modules, DFM and DS into DATA or DATA_LOCAL, \
        PROC_BEGIN into MODULE_MAIN, MECH_BEGIN into MODULE_MAIN or MODULE_FAST (manual 5.2).",
    ..Rule::BASE
};

/// T0609 nested-block.
pub static NESTED_BLOCK: Rule = Rule {
    code: "T0609",
    name: "nested-block",
    severity: Severity::Error,
    fixed: true,
    explanation: "Modules, mechanisms and procedures do not stand inside each other, except mechanisms and \
        procedures in their module (manual 4.2, 5.2). Often the closing line of the outer one is missing.",
    ..Rule::BASE
};
