//! T0952 connection-direction.

use crate::diagnostics::{Rule, Severity};

/// T0952 connection-direction.
pub static CONNECTION_DIRECTION: Rule = Rule {
    code: "T0952",
    name: "connection-direction",
    severity: Severity::Error,
    explanation: "The source of a connection must be a logical output, its destination a logical input: `PLC.Output.…` \
        or a unit's inputs (`CAN[1].INOUT08[n].IP0`, `ECAT.….Inputs.…`) as source; `PLC.Input.…`, \
        `VKeyboard.VKey[n]`, a unit's outputs as destination. `RTM.…` may be either. Anything without one of \
        these groups is nobody's element.",
    why: "The connection is not made.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"PLC.Input.Door\" Destination=\"PLC.Input.Door\" Connected=\"1\"/>\n",
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
    ..Rule::BASE
};
