//! T0915 identifier-form.

use crate::diagnostics::{Rule, Severity};

/// T0915 identifier-form.
pub static IDENTIFIER_FORM: Rule = Rule {
    code: "T0915",
    name: "identifier-form",
    severity: Severity::Warning,
    explanation: "The identifier that DEF_IN or DEF_OUT gives a logical element has a form no connection can meet: the \
        name of a group in front (`PLC.Input.`), or an index at its end, which would be that of an element \
        of the array. Write the name alone; connections add group and index.",
    why: "The connection looks for the name without them and finds nothing.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        DEF_IN liDoor,'PLC.Input.Door',TYPE_BIT\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Connections>\n",
        "  <Connection Source=\"CAN[1].INOUT08[1].IP0.Bit[2]\" Destination=\"PLC.Input.Door\" Connected=\"1\"/>\n",
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
