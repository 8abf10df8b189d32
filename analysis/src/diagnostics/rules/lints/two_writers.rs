//! T1130 two-writers.

use crate::diagnostics::{Rule, Severity};

/// T1130 two-writers.
pub static TWO_WRITERS: Rule = Rule {
    code: "T1130",
    name: "two-writers",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A bit is written with WR or MOVR by a section that runs in every cycle, and another such section \
        writes it too: two sections with WR, or a mechanism with WR and another mechanism with \
        any write. Let one place write the bit and hand it requests in bits of their own. FL and \
        FL1 in several mechanisms are fine: they change the bit only when they are passed.",
    why: "WR writes in every pass, also a 0. What the other one wrote lasts until the next WR, so the bit \
        flickers or one of the two has no effect, depending on the order of the sections.",
    wrong: "\
LDR DOOR
WR LAMP
MECH_BEGIN ALARM
LDR FAULT
WR LAMP
TIM -,25
MECH_END ALARM
LDR FAULT
FL1 1,ALARM
",
    right: "\
LDR DOOR
LO M0
WR LAMP
MECH_BEGIN ALARM
LDR FAULT
WR M0
TIM -,25
MECH_END ALARM
LDR FAULT
FL1 1,ALARM
",
    ..Rule::BASE
};
