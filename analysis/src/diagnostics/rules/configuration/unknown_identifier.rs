//! T0911 unknown-identifier.

use crate::diagnostics::{Rule, Severity};

/// T0911 unknown-identifier.
pub static UNKNOWN_IDENTIFIER: Rule = Rule {
    code: "T0911",
    name: "unknown-identifier",
    severity: Severity::Warning,
    explanation: "An instruction names an identifier that no configuration file of the project defines. Identifiers \
        count in upper and lower case. It is reported only when the project has files of that kind and all \
        of them can be read, and for an instruction with a default value only when a similar identifier \
        exists: then a default is meant for a configuration that lacks the element.",
    why: "Nothing fails at run time: MAP_IN leaves the bit at its default, CNF_GET_INT and CONST_GET leave the \
        cell as it is with RLO 0, and the machine does not do what its configuration says.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n",
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
    chapter: "10.4",
    fix: true,
    ..Rule::BASE
};
