//! T0943 unknown-command-code.

use crate::diagnostics::{Rule, Severity};

/// T0943 unknown-command-code.
pub static UNKNOWN_COMMAND_CODE: Rule = Rule {
    code: "T0943",
    name: "unknown-command-code",
    severity: Severity::Warning,
    explanation: "The procedure _ON_CMD compares DR with a number that is the value of no constant of the project. \
        Numbers of constants with `Value=\"PLCCOMMAND\"` are given by the control: take them with CONST_GET \
        into a cell and compare with the cell.",
    why: "The comparison is never true.",
    wrong: concat!(
        "MODULE_MAIN\n",
        "PROC_BEGIN _ON_CMD\n",
        "        EQ   CNST.13\n",
        "        FL1  1,M0\n",
        "        EQ   CNST.12\n",
        "        FL1  1,M1\n",
        "PROC_END _ON_CMD\n",
        "MODULE_MAIN_END\n",
        ";=== commands.PlcConstants\n",
        "<PlcConstants>\n",
        "  <Constant ID=\"CMD_LAMP\" Value=\"12\"/>\n",
        "</PlcConstants>\n",
        ";=== panel.KbdConfig\n",
        "<KeyboardConfig>\n",
        "  <KeyConfig ScanCode=\"0x6F\" PlcCommand=\"CMD_LAMP\"/>\n",
        "</KeyboardConfig>\n",
    ),
    right: concat!(
        "MODULE_MAIN\n",
        "PROC_BEGIN _ON_CMD\n",
        "        EQ   CNST.12\n",
        "        FL1  1,M0\n",
        "PROC_END _ON_CMD\n",
        "MODULE_MAIN_END\n",
        ";=== commands.PlcConstants\n",
        "<PlcConstants>\n",
        "  <Constant ID=\"CMD_LAMP\" Value=\"12\"/>\n",
        "</PlcConstants>\n",
        ";=== panel.KbdConfig\n",
        "<KeyboardConfig>\n",
        "  <KeyConfig ScanCode=\"0x6F\" PlcCommand=\"CMD_LAMP\"/>\n",
        "</KeyboardConfig>\n",
    ),
    chapter: "16.2",
    ..Rule::BASE
};
