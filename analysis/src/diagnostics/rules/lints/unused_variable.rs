//! T1133 unused-variable.

use crate::diagnostics::{Rule, Severity};

/// T1133 unused-variable.
pub static UNUSED_VARIABLE: Rule = Rule {
    code: "T1133",
    name: "unused-variable",
    severity: Severity::Hint,
    fixed: false,
    explanation: "A bit, cell, area or text is declared, and no instruction of the project uses it. Remove it, or \
        keep its place in the byte with an empty position: `DFM A,,C`.",
    why: "It takes memory, and readers look for what it is good for.",
    wrong: "\
DATA
OLD: DS 2
DATA_END
",
    right: "\
DATA
EQUI MAX,2
TEMP: DS MAX
DATA_END
MODULE_MAIN
LOD TEMP
INR
STO TEMP
MODULE_MAIN_END
",
    unnecessary: true,
    ..Rule::BASE
};
