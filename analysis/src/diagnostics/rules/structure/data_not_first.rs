//! T0604 data-not-first.

use crate::diagnostics::{Rule, Severity};

/// T0604 data-not-first.
pub static DATA_NOT_FIRST: Rule = Rule {
    code: "T0604",
    name: "data-not-first",
    severity: Severity::Error,
    fixed: true,
    explanation: "DATA is the first module of every file; only comments, T_INCLUDE, macros, EQUI and DEBUG may stand \
        before it (manual 5.1).",
    why: "Names are laid out before the code that uses them is translated.",
    wrong: "\
;=== main.plc
MODULE_INPUT
MODULE_INPUT_END
DATA
DATA_END
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
