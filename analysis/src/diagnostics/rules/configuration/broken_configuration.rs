//! T0901 broken-configuration.

use crate::diagnostics::{Rule, Severity};

/// T0901 broken-configuration.
pub static BROKEN_CONFIGURATION: Rule = Rule {
    code: "T0901",
    name: "broken-configuration",
    severity: Severity::Error,
    explanation: "The configuration file is no well-formed XML. The place shown is where reading ended: a tag that \
        closes nothing, a `<` or `&` in a text that must be written `&lt;` or `&amp;`, an attribute twice, \
        or a file larger than this implementation reads. Nothing that the program refers to in files of this \
        kind is judged until it is mended.",
    why: "The control does not read such a file at all, and the program runs with defaults.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\">\n",
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
