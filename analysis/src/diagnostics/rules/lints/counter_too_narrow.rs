//! T1146 counter-too-narrow.

use crate::diagnostics::{Rule, Severity};

/// T1146 counter-too-narrow.
pub static COUNTER_TOO_NARROW: Rule = Rule {
    code: "T1146",
    name: "counter-too-narrow",
    severity: Severity::Error,
    fixed: true,
    explanation: "The counter of TIM, TEX0 or TEX1 is a BYTE, which counts to 255, and the time is longer. Declare \
        the counter with DS 2, or write `-` and leave it to the compiler.",
    why: "The counter can never reach the time, so the wait would never end.",
    wrong: "\
FL 1,PAUSE
MECH_BEGIN PAUSE
TIM SMALL,300
MECH_END PAUSE
",
    right: "\
FL 1,PAUSE
MECH_BEGIN PAUSE
TIM MIDDLE,300
MECH_END PAUSE
",
    chapter: "3.11",
    ..Rule::BASE
};
