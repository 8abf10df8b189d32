//! T0914 unused-identifier.

use crate::diagnostics::{Rule, Severity};

/// T0914 unused-identifier.
pub static UNUSED_IDENTIFIER: Rule = Rule {
    code: "T0914",
    name: "unused-identifier",
    severity: Severity::Hint,
    explanation: "A configuration file defines an identifier or a message that the program never uses. It may be left \
        over, or belong to a machine with other options. Nothing is said while the program has errors, or \
        when it takes identifiers or numbers from cells.",
    why: "What is not used is not kept up to date either.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n",
        "  <Input ID=\"inKey\" Port=\"1\" Bit=\"3\" Connected=\"1\"/>\n",
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
