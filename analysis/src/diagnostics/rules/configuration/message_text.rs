//! T0908 message-text.

use crate::diagnostics::{Rule, Severity};

/// T0908 message-text.
pub static MESSAGE_TEXT: Rule = Rule {
    code: "T0908",
    name: "message-text",
    severity: Severity::Warning,
    explanation: "The text of a message holds a `%` with a letter that shows no value, or more values than a message \
        carries. Only `%d` (decimal) and `%X` (hexadecimal) show values, at most three: par1 to par3 of \
        ESET, in this order.",
    why: "The operator reads the letters instead of the value.",
    wrong: concat!(
        "        ESET 7,-,-,LARGE\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Tool %d is worn, %s</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    right: concat!(
        "        ESET 7,-,-,LARGE\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Tool %d is worn</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.4",
    ..Rule::BASE
};
