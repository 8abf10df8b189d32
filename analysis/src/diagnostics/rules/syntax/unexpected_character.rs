//! T0101 unexpected-character.

use crate::diagnostics::{Rule, Severity};

/// T0101 unexpected-character.
pub static UNEXPECTED_CHARACTER: Rule = Rule {
    code: "T0101",
    name: "unexpected-character",
    severity: Severity::Error,
    fixed: true,
    explanation: "The character has no meaning at this place. A line is `[label:] [operation [operand {, operand}]] \
        [;comment]` (manual 3.1).",
    why: "What follows the character cannot be read reliably, so the line is not translated.",
    wrong: "\
LDR START!
WR MOTOR
",
    right: "\
LDR START
WR MOTOR
",
    chapter: "3.1",
    ..Rule::BASE
};
