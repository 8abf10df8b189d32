//! T0605 stop-misplaced.

use crate::diagnostics::{Rule, Severity};

/// T0605 stop-misplaced.
pub static STOP_MISPLACED: Rule = Rule {
    code: "T0605",
    name: "stop-misplaced",
    severity: Severity::Error,
    fixed: true,
    explanation: "The main file ends with STOP after its last module (manual 5.1); nothing but comments may follow \
        it.",
    why: "The compiler reads the main file as far as STOP; what stands behind it would never be \
        translated.",
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
MODULE_HALT
MODULE_HALT_END
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
    chapter: "5.1",
    ..Rule::BASE
};
