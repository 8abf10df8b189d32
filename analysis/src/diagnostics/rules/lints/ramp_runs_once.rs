//! T1108 ramp-runs-once.

use crate::diagnostics::{Rule, Severity};

/// T1108 ramp-runs-once.
pub static RAMP_RUNS_ONCE: Rule = Rule {
    code: "T1108",
    name: "ramp-runs-once",
    severity: Severity::Warning,
    explanation: "RAMP makes one step each time it runs, so it belongs where it runs in every cycle: MODULE_MAIN or MODULE_FAST. This \
        module runs only once, or now and then.",
    why: "The output makes a single step towards the demand and stays there.",
    wrong: "\
MODULE_INIT
    LOD  CNST.500
    RAMP MIDDLE,TEN
MODULE_INIT_END
",
    right: "\
MODULE_MAIN
    LOD  CNST.500
    RAMP MIDDLE,TEN
MODULE_MAIN_END
",
    chapter: "12.8",
    ..Rule::BASE
};
