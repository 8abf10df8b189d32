//! T0942 command-ignored.

use crate::diagnostics::{Rule, Severity};

/// T0942 command-ignored.
pub static COMMAND_IGNORED: Rule = Rule {
    code: "T0942",
    name: "command-ignored",
    severity: Severity::Warning,
    explanation: "A button sends a PLC command that the program does not take: no CONST_GET asks for its number, and \
        the procedure _ON_CMD does not compare with it, or is missing. Take the command in _ON_CMD, or \
        remove it from the button.",
    why: "Pressing the button has no effect.",
    wrong: concat!(
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
    chapter: "11.3",
    ..Rule::BASE
};
