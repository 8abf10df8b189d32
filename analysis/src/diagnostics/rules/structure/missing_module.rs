//! T0601 missing-module.

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
    why: "The control calls these modules at fixed moments; a program without one of them cannot be \
        linked.",
    wrong: "\
;=== main.plc
DATA
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
STOP
",
    right: "\
;=== main.plc
DATA
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
",
    chapter: "5.4",
    ..Rule::BASE
};
