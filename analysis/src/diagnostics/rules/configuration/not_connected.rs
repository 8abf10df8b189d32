//! T0954 not-connected.

use crate::diagnostics::{Rule, Severity};

/// T0954 not-connected.
pub static NOT_CONNECTED: Rule = Rule {
    code: "T0954",
    name: "not-connected",
    severity: Severity::Hint,
    explanation: "The attribute `Connected` is left out, and its default is 0: the connection or mapping is described \
        but not made. Write `Connected=\"1\"`, or `Connected=\"0\"` where that is meant.",
    why: "Forgotten, it looks like a broken cable.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"CAN[1].INOUT08[1].IP0.Bit[2]\" Destination=\"PLC.Input.Door\"/>\n",
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
    chapter: "27.5",
    ..Rule::BASE
};
