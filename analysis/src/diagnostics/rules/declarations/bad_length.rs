//! T0208 bad-length.

use crate::diagnostics::{Rule, Severity};

/// T0208 bad-length.
pub static BAD_LENGTH: Rule = Rule {
    code: "T0208",
    name: "bad-length",
    severity: Severity::Error,
    fixed: true,
    explanation: "The length of DS or STR must be a positive constant: `DS 1`, `DS 2` and `DS 4` declare a BYTE, \
        WORD or DWORD, other lengths an area without type (manual 3.4).",
    why: "A cell without a byte has no place in memory.",
    wrong: "\
DATA
LEVEL: DS 0
DATA_END
",
    right: "\
DATA
LEVEL: DS 2
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
