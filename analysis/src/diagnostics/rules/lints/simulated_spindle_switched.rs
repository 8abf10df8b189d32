//! T1113 simulated-spindle-switched.

use crate::diagnostics::{Rule, Severity};

/// T1113 simulated-spindle-switched.
pub static SIMULATED_SPINDLE_SWITCHED: Rule = Rule {
    code: "T1113",
    name: "simulated-spindle-switched",
    severity: Severity::Warning,
    explanation: "A spindle without encoder gets its measured speed from the program, through SIM_SPEED_PT. In such a program AX_SPI must \
        not be used. Remove the one or the other.",
    why: "The control would count the speed of the switched axis and the simulated one at once.",
    wrong: "\
LOD REQ_SPEED_PT
STO SIM_SPEED_PT
AX_SPI 4
",
    right: "\
LOD REQ_SPEED_PT
STO SIM_SPEED_PT
",
    chapter: "12.9",
    ..Rule::BASE
};
