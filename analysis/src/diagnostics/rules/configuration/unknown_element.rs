//! T0903 unknown-element.

use crate::diagnostics::{Rule, Severity};

/// T0903 unknown-element.
pub static UNKNOWN_ELEMENT: Rule = Rule {
    code: "T0903",
    name: "unknown-element",
    severity: Severity::Warning,
    explanation: "An element of a configuration file is not one of those that may stand there, usually a misspelling; \
        or text stands where only elements may. Names count in upper and lower case. Elements whose content \
        the manual does not list completely take anything.",
    why: "The control skips what it does not know, so the setting has no effect.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n",
        "  <Imput ID=\"inKey\" Port=\"1\" Bit=\"3\" Connected=\"1\"/>\n",
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
