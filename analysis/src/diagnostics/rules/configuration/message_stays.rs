//! T0924 message-stays.

use crate::diagnostics::{Rule, Severity};

/// T0924 message-stays.
pub static MESSAGE_STAYS: Rule = Rule {
    code: "T0924",
    name: "message-stays",
    severity: Severity::Hint,
    explanation: "The program reports a persistent message and never removes it: there is no ESET of its number with \
        `set` 0, and no EDEF. Nothing is said when a message is reported by a number that is known at run \
        time only.",
    why: "The message stays in the window until the control is switched off.",
    wrong: concat!(
        "        ESET 7,-,1\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Persistent\"><Text>Pressure lost</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    right: concat!(
        "        ESET 7,-,1\n",
        "        ESET 7,-,0\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Persistent\"><Text>Pressure lost</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.3",
    ..Rule::BASE
};
