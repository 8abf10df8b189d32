//! T0505 open-equation.

use crate::diagnostics::{Rule, Severity};

/// T0505 open-equation.
pub static OPEN_EQUATION: Rule = Rule {
    code: "T0505",
    name: "open-equation",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The section ends while an equation is open: its result goes nowhere. Close it with a terminal \
        instruction such as WR or FL1 (manual 3.6).",
    why: "The next module's first LDR pushes the value that was left, and its stack is no longer balanced.",
    wrong: "\
LDR START
LA DOOR
",
    right: "\
LDR START
LA DOOR
WR MOTOR
",
    chapter: "3.6",
    ..Rule::BASE
};
