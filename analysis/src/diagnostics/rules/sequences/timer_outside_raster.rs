//! T0707 timer-outside-raster.

use crate::diagnostics::{Rule, Severity};

/// T0707 timer-outside-raster.
pub static TIMER_OUTSIDE_RASTER: Rule = Rule {
    code: "T0707",
    name: "timer-outside-raster",
    severity: Severity::Warning,
    fixed: false,
    explanation: "TM counts passes of the DFTM block around it (manual 3.11). Without such a block it counts passes of \
        its module, 20 ms or 1 ms each, which is seldom meant. Put it into a DFTM01, DFTM1, DFTM10 or DFTM100 block.",
    why: "The delay is a fiftieth of what the number suggests when somebody thought in seconds.",
    wrong: "\
LDR START
LOD CNST.30
TM MIDDLE
WR LAMP
",
    right: "\
DFTM01 TENTH
LDR START
LOD CNST.30
TM MIDDLE
WR LAMP
TENTH:
",
    chapter: "3.11",
    ..Rule::BASE
};
