//! T0602 forbidden-module.

use crate::diagnostics::{Rule, Severity};

/// T0602 forbidden-module.
pub static FORBIDDEN_MODULE: Rule = Rule {
    code: "T0602",
    name: "forbidden-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "MODULE_INPUT, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE, MODULE_HALT and MODULE_CONT stand in the main \
        file only (manual 5.2). Move its code there.",
    why: "The control has one place for this module, and the main file fills it.",
    wrong: "\
MODULE_MAIN
MODULE_MAIN_END
;=== doors.plc
DATA
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_MAIN
MODULE_MAIN_END
",
    right: "\
MODULE_MAIN
MODULE_MAIN_END
;=== doors.plc
DATA
DATA_END
MODULE_MAIN
MODULE_MAIN_END
",
    chapter: "5.2",
    ..Rule::BASE
};
