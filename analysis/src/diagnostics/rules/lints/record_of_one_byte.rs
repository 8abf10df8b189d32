//! T1101 record-of-one-byte.

use crate::diagnostics::{Rule, Severity};

/// T1101 record-of-one-byte.
pub static RECORD_OF_ONE_BYTE: Rule = Rule {
    code: "T1101",
    name: "record-of-one-byte",
    severity: Severity::Warning,
    explanation: "The control record of POS_MODE and the status record of POS_CONTROL are two bytes one behind the other, and the \
        instruction names the first. Here the byte behind it is no byte of the record: nothing, or a longer cell, follows \
        in the declaration. Declare two DFM, or DS 1, directly one after the other.",
    why: "The unit writes both bytes whenever the instruction runs. What lies behind a single byte changes without a \
        visible reason.",
    wrong: "\
POS_INIT 1
POS_MODE SMALL,LARGE,MIDDLE,1   ;SMALL is one BYTE, MIDDLE follows
POS_CONTROL TABLE,LARGE,-,1
POS_RESET 1
",
    right: "\
POS_INIT 1
POS_MODE TABLE+2,LARGE,MIDDLE,1
POS_CONTROL TABLE,LARGE,-,1
POS_RESET 1
",
    chapter: "19.2",
    ..Rule::BASE
};
