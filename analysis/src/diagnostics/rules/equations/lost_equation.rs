//! T0504 lost-equation.

use crate::diagnostics::{Rule, Severity};

/// T0504 lost-equation.
pub static LOST_EQUATION: Rule = Rule {
    code: "T0504",
    name: "lost-equation",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The instruction overwrites RLO while an equation is open and does not use its result, so the \
        equation has no effect. Close it with a terminal instruction first, or remove it.",
    why: "The condition was written for a purpose, and it has no effect.",
    wrong: "\
LDR START
EDGE_H DOOR
WR MOTOR
",
    right: "\
LDR START
WR M0
EDGE_H DOOR
WR MOTOR
",
    chapter: "3.6",
    ..Rule::BASE
};
