//! T0606 unclosed-block.

use crate::diagnostics::{Rule, Severity};

/// T0606 unclosed-block.
pub static UNCLOSED_BLOCK: Rule = Rule {
    code: "T0606",
    name: "unclosed-block",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module, mechanism, procedure or data block has no closing line. It is taken to end where the \
        next one begins.",
    why: "Everything that follows would belong to the block, with its labels and its equations.",
    wrong: "\
MODULE_MAIN
LDR START
WR MOTOR
",
    right: "\
MODULE_MAIN
LDR START
WR MOTOR
MODULE_MAIN_END
",
    chapter: "5.1",
    ..Rule::BASE
};
