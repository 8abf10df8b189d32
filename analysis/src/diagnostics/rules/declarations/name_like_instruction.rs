//! T0203 name-like-instruction.

use crate::diagnostics::{Rule, Severity};

/// T0203 name-like-instruction.
pub static NAME_LIKE_INSTRUCTION: Rule = Rule {
    code: "T0203",
    name: "name-like-instruction",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The name is also an instruction or keyword. It is read as a name where the place leaves no doubt, \
        but it confuses readers and other tools. Rename it.",
    why: "A reader takes the name for the instruction, and a colon that is forgotten later makes it one.",
    wrong: "\
DATA
DFM CHECK
DATA_END
",
    right: "\
DATA
DFM CHECKED
DATA_END
",
    chapter: "3.3",
    ..Rule::BASE
};
