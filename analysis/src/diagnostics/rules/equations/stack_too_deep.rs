//! T0503 stack-too-deep.

use crate::diagnostics::{Rule, Severity};

/// T0503 stack-too-deep.
pub static STACK_TOO_DEEP: Rule = Rule {
    code: "T0503",
    name: "stack-too-deep",
    severity: Severity::Error,
    fixed: true,
    explanation: "The equation stack has 8 cells (manual 3.2). Store a partial result in a bit.",
    why: "The ninth value would overwrite the first.",
    wrong: "\
LDR M0
LDR M1
LDR M2
LDR M3
LDR M4
LDR M5
LDR M6
LDR M7
LDR M0
LDR M1
LO
LO
LO
LO
LO
LO
LO
LO
LO
WR MOTOR
",
    right: "\
LDR M0
LDR M1
LDR M2
LDR M3
LDR M4
LDR M5
LDR M6
LDR M7
LDR M0
LO
LO
LO
LO
LO
LO
LO
LO
WR MOTOR
",
    chapter: "3.2",
    ..Rule::BASE
};
