//! T0921 unknown-message.

use crate::diagnostics::{Rule, Severity};

/// T0921 unknown-message.
pub static UNKNOWN_MESSAGE: Rule = Rule {
    code: "T0921",
    name: "unknown-message",
    severity: Severity::Warning,
    explanation: "ESET, ESET1 or EDEF reports a message that no `*.PlcErrors` file of the project has; or TEX leaves \
        such a number in DR while the same section reports the number that is in DR. Add a `PlcError` with \
        this number.",
    why: "Type, validity and text come from that file alone: the operator would see a bare number.",
    wrong: concat!("        ESET 8\n", ";=== machine.PlcErrors\n", "<PlcErrors>\n", "\n", "</PlcErrors>\n",),
    right: concat!(
        "        ESET 8\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"8\" Type=\"Err\" Validity=\"Transient\"><Text>Oil low</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.4",
    ..Rule::BASE
};
