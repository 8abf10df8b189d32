//! T0953 conversion-without-effect.

use crate::diagnostics::{Rule, Severity};

/// T0953 conversion-without-effect.
pub static CONVERSION_WITHOUT_EFFECT: Rule = Rule {
    code: "T0953",
    name: "conversion-without-effect",
    severity: Severity::Warning,
    explanation: "`Invert` acts on bits only, `Scale` and `Offset` act on numbers only. The logical element of the PLC \
        program that this connection names has a type for which the attribute does nothing. Remove it.",
    why: "The value arrives unconverted.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"CAN[1].INOUT08[1].IP0.Bit[2]\" Destination=\"PLC.Input.Door\" Scale=\"2.0\" Connected=\"1\"/>\n",
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
