//! T0111 unknown-instruction.

use crate::diagnostics::{Rule, Severity};

/// T0111 unknown-instruction.
pub static UNKNOWN_INSTRUCTION: Rule = Rule {
    code: "T0111",
    name: "unknown-instruction",
    severity: Severity::Error,
    fixed: true,
    explanation: "The word is neither an instruction nor a macro of this project. The message offers the nearest \
        instruction; a label needs a colon.",
    why: "The line would do nothing; usually a letter is wrong, or the file with the macro is not \
        included.",
    wrong: "\
LDR START
WRR MOTOR
",
    right: "\
LDR START
WR MOTOR
",
    chapter: "3.1",
    fix: true,
    ..Rule::BASE
};
