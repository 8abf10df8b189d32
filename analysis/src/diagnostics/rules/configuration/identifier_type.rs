//! T0912 identifier-type.

use crate::diagnostics::{Rule, Severity};

/// T0912 identifier-type.
pub static IDENTIFIER_TYPE: Rule = Rule {
    code: "T0912",
    name: "identifier-type",
    severity: Severity::Error,
    explanation: "The configuration defines the identifier as something else than the instruction reads: MAP_IN of an \
        `Output`, CNF_GET_INT of a parameter whose `Type` is `String`. Use the instruction that belongs to \
        the element, or correct the element. CNF_GET_BIT reads a parameter of type `Int`.",
    why: "The instruction does not find the element, or gets bytes of another meaning.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        MAP_IN inDoor,'outLamp'\n",
        "MODULE_INIT_END\n",
        ";=== machine.ChannelConfig\n",
        "<Plc>\n",
        "  <Output ID=\"outLamp\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n",
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
    ..Rule::BASE
};
