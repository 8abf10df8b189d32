//! T0913 constant-too-wide.

use crate::diagnostics::{Rule, Severity};

/// T0913 constant-too-wide.
pub static CONSTANT_TOO_WIDE: Rule = Rule {
    code: "T0913",
    name: "constant-too-wide",
    severity: Severity::Warning,
    explanation: "CONST_GET puts a constant into a cell that is too narrow for its value: a BYTE holds 0 to 255, a \
        WORD 0 to 65535. Declare a wider cell.",
    why: "Only the low part of the value is stored.",
    wrong: concat!(
        "MODULE_INIT\n",
        "        CONST_GET SMALL,'SPEED_LIMIT'\n",
        "MODULE_INIT_END\n",
        ";=== commands.PlcConstants\n",
        "<PlcConstants>\n",
        "  <Constant ID=\"SPEED_LIMIT\" Value=\"3000\"/>\n",
        "</PlcConstants>\n",
    ),
    right: concat!(
        "MODULE_INIT\n",
        "        CONST_GET MIDDLE,'SPEED_LIMIT'\n",
        "MODULE_INIT_END\n",
        ";=== commands.PlcConstants\n",
        "<PlcConstants>\n",
        "  <Constant ID=\"SPEED_LIMIT\" Value=\"3000\"/>\n",
        "</PlcConstants>\n",
    ),
    chapter: "16.2",
    ..Rule::BASE
};
