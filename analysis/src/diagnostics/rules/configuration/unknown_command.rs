//! T0941 unknown-command.

use crate::diagnostics::{Rule, Severity};

/// T0941 unknown-command.
pub static UNKNOWN_COMMAND: Rule = Rule {
    code: "T0941",
    name: "unknown-command",
    severity: Severity::Warning,
    explanation: "A button sends a PLC command that no `*.PlcConstants` file of the project defines. Correct the name, \
        or add a constant with `Value=\"PLCCOMMAND\"`.",
    why: "The control cannot turn the name into the number that _ON_CMD gets, so the button does nothing.",
    wrong: concat!(
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
        "  <KeyConfig ScanCode=\"0x70\" PlcCommand=\"CMD_LAMPS\"/>\n",
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
    chapter: "11.3",
    fix: true,
    ..Rule::BASE
};
