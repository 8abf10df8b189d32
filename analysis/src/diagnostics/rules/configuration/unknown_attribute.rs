//! T0904 unknown-attribute.

use crate::diagnostics::{Rule, Severity};

/// T0904 unknown-attribute.
pub static UNKNOWN_ATTRIBUTE: Rule = Rule {
    code: "T0904",
    name: "unknown-attribute",
    severity: Severity::Warning,
    explanation: "An element of a configuration file has an attribute it does not know, usually a misspelling. Names \
        count in upper and lower case. Elements whose attributes the manual does not list completely take \
        anything that is not close to a known name.",
    why: "The control skips what it does not know and takes the default instead.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bitt=\"2\" Connected=\"1\"/>\n",
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
    fix: true,
    ..Rule::BASE
};
