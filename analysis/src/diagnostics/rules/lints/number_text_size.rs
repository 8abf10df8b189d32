//! T1153 number-text-size.

use crate::diagnostics::{Rule, Severity};

/// T1153 number-text-size.
pub static NUMBER_TEXT_SIZE: Rule = Rule {
    code: "T1153",
    name: "number-text-size",
    severity: Severity::Error,
    fixed: false,
    explanation: "BINSTR and BCDSTR write a number into a text buffer of 1 to 10 characters; this one is longer. \
        Declare a buffer of its own for the number and copy it with STRCPY.",
    why: "The instruction fills the whole buffer with digits, and no number has so many.",
    wrong: "\
DATA
SHOWN: STR 12
VALUE: DS 2
DATA_END
MODULE_MAIN
LOD VALUE
BINSTR SHOWN
MODULE_MAIN_END
",
    right: "\
DATA
SHOWN: STR 5
VALUE: DS 2
DATA_END
MODULE_MAIN
LOD VALUE
BINSTR SHOWN
MODULE_MAIN_END
",
    chapter: "3.18",
    ..Rule::BASE
};
