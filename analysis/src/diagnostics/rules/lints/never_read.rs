//! T1132 never-read.

use crate::diagnostics::{Rule, Severity};

/// T1132 never-read.
pub static NEVER_READ: Rule = Rule {
    code: "T1132",
    name: "never-read",
    severity: Severity::Hint,
    fixed: false,
    explanation: "A bit or cell of the program is written and never read, neither by its name nor by that of its \
        byte, an offset or an index. Remove it, or use it. Cells that are there for the debugger \
        or a screen can be allowed with a comment.",
    why: "The work is for nothing, or the place that should react to it is missing.",
    wrong: "\
DATA
STROKES: DS 2
DATA_END
MODULE_MAIN
LOD CNST.5
STO STROKES
MODULE_MAIN_END
",
    right: "\
DATA
STROKES: DS 2
DATA_END
MODULE_MAIN
LOD STROKES
INR
STO STROKES
MODULE_MAIN_END
",
    unnecessary: true,
    ..Rule::BASE
};
