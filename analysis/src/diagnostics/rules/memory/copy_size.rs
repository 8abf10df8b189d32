//! T0425 copy-size.

use crate::diagnostics::{Rule, Severity};

/// T0425 copy-size.
pub static COPY_SIZE: Rule = Rule {
    code: "T0425",
    name: "copy-size",
    severity: Severity::Warning,
    explanation: "MEMCPY or MEMCMP takes more bytes than one of the buffers has from the given place, or gives no number \
        although the buffers have different sizes. Give the number of bytes that both hold.",
    why: "Binary data have no end of their own: the bytes behind the shorter buffer would be copied or compared.",
    wrong: "DATA\nSENT:   STR 12\nSHORT:  STR 4\nDATA_END\nMODULE_MAIN\n        MEMCPY SENT,SHORT,12\nMODULE_MAIN_END\n",
    right: "DATA\nSENT:   STR 12\nSHORT:  STR 4\nDATA_END\nMODULE_MAIN\n        MEMCPY SENT,SHORT,4\nMODULE_MAIN_END\n",
    chapter: "3.18",
    ..Rule::BASE
};
