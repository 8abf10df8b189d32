//! T0907 duplicate-identifier.

use crate::diagnostics::{Rule, Severity};

/// T0907 duplicate-identifier.
pub static DUPLICATE_IDENTIFIER: Rule = Rule {
    code: "T0907",
    name: "duplicate-identifier",
    severity: Severity::Error,
    explanation: "Two elements of one kind have the same identifier or number: two inputs `inDoor`, two messages 12, \
        two buttons with one scan code. In one file both places are shown; two files of the project are \
        compared as well. Give one of them another name, or remove it.",
    why: "Only one of the two can be found, and which one is not defined.",
    wrong: concat!(
        "        ESET 7\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Pressure lost</Text></PlcError>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Oil low</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    right: concat!(
        "        ESET 7\n",
        "        ESET 8\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Pressure lost</Text></PlcError>\n",
        "  <PlcError No=\"8\" Type=\"Err\" Validity=\"Transient\"><Text>Oil low</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.4",
    ..Rule::BASE
};
