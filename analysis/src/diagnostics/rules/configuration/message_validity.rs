//! T0923 message-validity.

use crate::diagnostics::{Rule, Severity};

/// T0923 message-validity.
pub static MESSAGE_VALIDITY: Rule = Rule {
    code: "T0923",
    name: "message-validity",
    severity: Severity::Warning,
    explanation: "The instruction treats a message as persistent (`set` of ESET, a condition for the end in the mode \
        of EDEF) that its file calls `Transient`; or EDEF gives a persistent message no condition for its \
        end. Change `Validity`, or the operand.",
    why: "A transient message is acknowledged by the operator, and nothing removes it; a persistent one stays \
        until the program removes it.",
    wrong: concat!(
        "        ESET 7,-,1\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Pressure lost</Text></PlcError>\n",
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
    chapter: "14.4",
    ..Rule::BASE
};
