//! T0401 operand-count.

use crate::diagnostics::{Rule, Severity};

/// T0401 operand-count.
pub static OPERAND_COUNT: Rule = Rule {
    code: "T0401",
    name: "operand-count",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction has too few or too many operands. The message shows how it is written.",
    ..Rule::BASE
};
