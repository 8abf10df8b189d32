//! T1131 never-written.

use crate::diagnostics::{Rule, Severity};

/// T1131 never-written.
pub static NEVER_WRITTEN: Rule = Rule {
    code: "T1131",
    name: "never-written",
    severity: Severity::Info,
    fixed: false,
    explanation: "A bit or cell of the program is read, and nothing writes it, neither by its name nor by that of \
        its byte, an offset or an index. It stays 0. Write it, or read what was meant. Cells \
        that only the debugger or a screen writes can be allowed with a comment.",
    why: "A condition that never changes is usually a bit that was renamed at one of its two ends.",
    wrong: "\
DATA
KEYS: DFM ASKED,ALLOWED
DATA_END
MODULE_MAIN
LDR ASKED
FL1 1,STOPPI
MODULE_MAIN_END
",
    right: "\
DATA
KEYS: DFM ASKED,ALLOWED
DATA_END
MODULE_INPUT
LOD P1IN
STO KEYS
MODULE_INPUT_END
MODULE_MAIN
LDR ASKED
FL1 1,STOPPI
MODULE_MAIN_END
",
    ..Rule::BASE
};
