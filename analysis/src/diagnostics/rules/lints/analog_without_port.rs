//! T1112 analog-without-port.

use crate::diagnostics::{Rule, Severity};

/// T1112 analog-without-port.
pub static ANALOG_WITHOUT_PORT: Rule = Rule {
    code: "T1112",
    name: "analog-without-port",
    severity: Severity::Warning,
    explanation: "ANALOG with at most one operand drives the output that ANALOG_PORT chose, and the project has no ANALOG_PORT. Put one \
        into MODULE_INIT, or name the axis as second operand.",
    why: "The value goes nowhere: before the first ANALOG_PORT no output is active.",
    wrong: "\
ANALOG MIDDLE
",
    right: "\
ANALOG_PORT 6
ANALOG MIDDLE
",
    chapter: "12.2",
    ..Rule::BASE
};
