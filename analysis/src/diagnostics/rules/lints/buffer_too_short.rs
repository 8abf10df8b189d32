//! T1109 buffer-too-short.

use crate::diagnostics::{Rule, Severity};

/// T1109 buffer-too-short.
pub static BUFFER_TOO_SHORT: Rule = Rule {
    code: "T1109",
    name: "buffer-too-short",
    severity: Severity::Warning,
    explanation: "The instruction needs more bytes than the cell or area has from the named place to its end: 8 for a real number of a \
        table, 12 for a CAN packet, as many as COM_SEND_STR, SA_READ, SA_WRITE or SHARE_VAR is told. Declare a longer one or give a smaller length.",
    why: "What lies behind is read or overwritten.",
    wrong: "\
COM_SEND_STR 1,TABLE+20,14
JL1 FULL
FULL:
",
    right: "\
COM_SEND_STR 1,TABLE,14
JL1 FULL
FULL:
",
    chapter: "",
    ..Rule::BASE
};
