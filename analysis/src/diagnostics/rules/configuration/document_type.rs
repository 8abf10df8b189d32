//! T0902 document-type.

use crate::diagnostics::{Rule, Severity};

/// T0902 document-type.
pub static DOCUMENT_TYPE: Rule = Rule {
    code: "T0902",
    name: "document-type",
    severity: Severity::Error,
    explanation: "The configuration file begins with a document type (`<!DOCTYPE …>`). It is not read: entities it \
        declares are never expanded. Remove it; configuration files need none.",
    why: "Entities let a few lines grow into gigabytes or draw in other files, so no tool should expand those \
        of a file it was handed.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'inDoor'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<!DOCTYPE Plc>\n",
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
    chapter: "",
    ..Rule::BASE
};
