//! T0961 unknown-port.

use crate::diagnostics::{Rule, Severity};

/// T0961 unknown-port.
pub static UNKNOWN_PORT: Rule = Rule {
    code: "T0961",
    name: "unknown-port",
    severity: Severity::Warning,
    explanation: "COM_SEND, COM_SEND_STR, COM_RECV or COM_CONTROL uses a logical serial port that no `ComChannel` of \
        the project defines, or one that is not active. The operand is the attribute `No`, not the number of \
        the port in Windows.",
    why: "Nothing is sent or received.",
    wrong: concat!(
        "        COM_SEND 1\n",
        ";=== machine.ChannelConfig\n",
        "<Channel>\n",
        "  <ComChannel No=\"0\" Active=\"1\" PhysicalComNo=\"2\"/>\n",
        "</Channel>\n",
    ),
    right: concat!(
        "        COM_SEND 0\n",
        ";=== machine.ChannelConfig\n",
        "<Channel>\n",
        "  <ComChannel No=\"0\" Active=\"1\" PhysicalComNo=\"2\"/>\n",
        "</Channel>\n",
    ),
    chapter: "23.3",
    ..Rule::BASE
};
