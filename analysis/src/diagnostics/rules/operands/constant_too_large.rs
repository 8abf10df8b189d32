//! T0406 constant-too-large.

use crate::diagnostics::{Rule, Severity};

/// T0406 constant-too-large.
pub static CONSTANT_TOO_LARGE: Rule = Rule {
    code: "T0406",
    name: "constant-too-large",
    severity: Severity::Error,
    fixed: true,
    explanation: "The constant does not fit the width of the operation: BYTE -128..255, WORD -32768..65535, DWORD \
        and constants -2147483648..4294967295.",
    why: "The upper bits would be cut off and another number would remain.",
    wrong: "\
LOD BYTE.300
STO SMALL
",
    right: "\
LOD BYTE.200
STO SMALL
",
    chapter: "3.4",
    ..Rule::BASE
};
