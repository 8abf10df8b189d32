//! T1136 motion-block-wait.

use crate::diagnostics::{Rule, Severity};

/// T1136 motion-block-wait.
pub static MOTION_BLOCK_WAIT: Rule = Rule {
    code: "T1136",
    name: "motion-block-wait",
    severity: Severity::Warning,
    fixed: false,
    explanation: "An EX-type instruction stands in MODULE_BLOCK_INIT or MODULE_BLOCK_DONE, and no conditional jump \
        can pass it by, so that every block of the part program waits there. Test first whether \
        the block asks for the function, and jump over the wait when it does not.",
    why: "Blocks that only move must pass both modules in one go. Each wait between two of them interrupts \
        the continuous motion: the machine jerks and leaves marks on the workpiece.",
    wrong: "\
MODULE_BLOCK_INIT
FL 1,MOTOR
EX
LDR READY
EX0
MODULE_BLOCK_INIT_END
",
    right: "\
MODULE_BLOCK_INIT
LDR M0
JL0 NO_MOTOR
FL 1,MOTOR
EX
LDR READY
EX0
NO_MOTOR:
MODULE_BLOCK_INIT_END
",
    chapter: "5.3",
    ..Rule::BASE
};
