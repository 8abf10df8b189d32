//! T0951 unknown-logical-element.

use crate::diagnostics::{Rule, Severity};

/// T0951 unknown-logical-element.
pub static UNKNOWN_LOGICAL_ELEMENT: Rule = Rule {
    code: "T0951",
    name: "unknown-logical-element",
    severity: Severity::Warning,
    explanation: "A connection names a logical element of the PLC program that no DEF_IN or DEF_OUT declares. Upper \
        and lower case, leading zeros of an index, an index 0, an index at the end and `.Bit[n]` make no \
        difference.",
    why: "The connection is not made; the input keeps its default.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"CAN[1].INOUT08[1].IP0.Bit[2]\" Destination=\"PLC.Input.Dor\" Connected=\"1\"/>\n",
        "</Connections>\n",
    ),
    right: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"CAN[1].INOUT08[1].IP0.Bit[2]\" Destination=\"PLC.Input.Door\" Connected=\"1\"/>\n",
        "</Connections>\n",
    ),
    chapter: "27.3",
    fix: true,
    ..Rule::BASE
};
