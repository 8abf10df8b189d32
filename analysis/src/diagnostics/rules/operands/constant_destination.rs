//! T0414 constant-destination.

use crate::diagnostics::{Rule, Severity};

/// T0414 constant-destination.
pub static CONSTANT_DESTINATION: Rule = Rule {
    code: "T0414",
    name: "constant-destination",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction writes to this operand, and a constant cannot be written to. Name a cell.",
    why: "A constant is no memory, so there is nothing to write to.",
    wrong: "\
LOD SMALL
STO TEN
",
    right: "\
LOD SMALL
STO MIDDLE
",
    chapter: "3.9",
    ..Rule::BASE
};
