//! T1111 positioning-incomplete.

use crate::diagnostics::{Rule, Severity};

/// T1111 positioning-incomplete.
pub static POSITIONING_INCOMPLETE: Rule = Rule {
    code: "T1111",
    name: "positioning-incomplete",
    severity: Severity::Warning,
    explanation: "A motion by the positioning unit takes four steps: POS_INIT takes the axis, POS_MODE prepares the way, POS_CONTROL \
        gives the speed in every cycle, POS_RESET returns the axis to the NC. The project has no instruction for one of them \
        and this axis. POS_CONTROL alone is fine: it only watches.",
    why: "Without POS_INIT nothing is programmed, without POS_CONTROL the axis does not move, and without POS_RESET the NC \
        never gets it back.",
    wrong: "\
POS_INIT 4
POS_MODE TABLE,LARGE,MIDDLE,4
POS_RESET 4
",
    right: "\
POS_INIT 4
POS_MODE TABLE,LARGE,MIDDLE,4
POS_CONTROL TABLE+2,LARGE,-,4
POS_RESET 4
",
    chapter: "19.1",
    ..Rule::BASE
};
