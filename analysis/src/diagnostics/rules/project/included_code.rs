//! T0011 included-code.

use crate::diagnostics::{Rule, Severity};

/// T0011 included-code.
pub static INCLUDED_CODE: Rule = Rule {
    code: "T0011",
    name: "included-code",
    severity: Severity::Error,
    fixed: true,
    explanation: "An included file may hold constants (EQUI), macros, comments and further T_INCLUDE; DFM and DS \
        only when it is included inside DATA or DATA_LOCAL. Executable code and modules belong into a \
        program file (`files` in `technol.toml`).",
    why: "Code belongs to a module of a program file: only there its order of execution and its place for \
        break-points are known.",
    wrong: "\
T_INCLUDE lamp.inc
DATA
DFM START,LAMP
DATA_END
;=== lamp.inc
LDR START
WR LAMP
",
    right: "\
T_INCLUDE lamp.inc
DATA
DFM START,LAMP
DATA_END
;=== lamp.inc
EQUI T_LAMP,50
",
    chapter: "22",
    ..Rule::BASE
};
