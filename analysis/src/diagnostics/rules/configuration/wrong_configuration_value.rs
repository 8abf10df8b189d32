//! T0905 wrong-configuration-value.

use crate::diagnostics::{Rule, Severity};

/// T0905 wrong-configuration-value.
pub static WRONG_CONFIGURATION_VALUE: Rule = Rule {
    code: "T0905",
    name: "wrong-configuration-value",
    severity: Severity::Error,
    explanation: "The value of an attribute or element is not one it can have: a port above 128, a bit above 7, a word \
        that is none of those allowed, a text where a number is needed. The message says what is needed.",
    why: "What the control makes of such a value is not defined.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"8\" Connected=\"1\"/>\n",
        "</Plc>\n",
    ),
    right: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n",
        "</Plc>\n",
    ),
    chapter: "10.2",
    ..Rule::BASE
};
