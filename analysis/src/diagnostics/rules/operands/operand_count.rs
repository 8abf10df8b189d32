//! T0401 operand-count.

use crate::diagnostics::{Rule, Severity};

/// T0401 operand-count.
pub static OPERAND_COUNT: Rule = Rule {
    code: "T0401",
    name: "operand-count",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction has too few or too many operands. The message shows how it is written.",
    why: "A missing operand would be read from the next line's place, a further one would be ignored: \
        either way the instruction does something else than it says.",
    wrong: "\
EQ
LDR START
WR MOTOR
",
    right: "\
EQ CNST.1
LDR START
WR MOTOR
",
    chapter: "3.1",
    ..Rule::BASE
};
