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
    ..Rule::BASE
};
