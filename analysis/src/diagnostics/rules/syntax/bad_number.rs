//! T0104 bad-number.

use crate::diagnostics::{Rule, Severity};

/// T0104 bad-number.
pub static BAD_NUMBER: Rule = Rule {
    code: "T0104",
    name: "bad-number",
    severity: Severity::Error,
    fixed: true,
    explanation: "The number cannot be read. Forms: `123`, `0F8h` (a hexadecimal number begins with a digit), \
        `0001b`, `'A'`, and with a decimal point `1.5` (manual 3.4).",
    why: "A number that is read in another base than it was meant in is a mistake nobody sees.",
    wrong: "\
LOD CNST.0F8
STO SMALL
",
    right: "\
LOD CNST.0F8h
STO SMALL
",
    chapter: "3.4",
    ..Rule::BASE
};
