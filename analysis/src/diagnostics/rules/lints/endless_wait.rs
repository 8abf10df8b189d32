//! T1135 endless-wait.

use crate::diagnostics::{Rule, Severity};

/// T1135 endless-wait.
pub static ENDLESS_WAIT: Rule = Rule {
    code: "T1135",
    name: "endless-wait",
    severity: Severity::Warning,
    fixed: false,
    explanation: "EX0 waits for a bit of the program to be 1, and nothing in the project sets it. Set it \
        somewhere, wait for another bit, or use TEX0 with a time after which the sequence goes \
        on.",
    why: "The sequence stays in this state until the PLC is restarted.",
    wrong: "\
DATA
STATES: DFM CLAMPED,RUNNING
DATA_END
MODULE_MAIN
FL 1,CLAMP
MECH_BEGIN CLAMP
LDR CLAMPED
EX0
MECH_END CLAMP
MODULE_MAIN_END
",
    right: "\
DATA
STATES: DFM CLAMPED,RUNNING
DATA_END
MODULE_INPUT
LOD P1IN
STO STATES
MODULE_INPUT_END
MODULE_MAIN
FL 1,CLAMP
MECH_BEGIN CLAMP
LDR CLAMPED
EX0
MECH_END CLAMP
MODULE_MAIN_END
",
    ..Rule::BASE
};
