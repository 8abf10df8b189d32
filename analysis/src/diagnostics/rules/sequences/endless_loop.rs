//! T0702 endless-loop.

use crate::diagnostics::{Rule, Severity};

/// T0702 endless-loop.
pub static ENDLESS_LOOP: Rule = Rule {
    code: "T0702",
    name: "endless-loop",
    severity: Severity::Error,
    fixed: true,
    explanation: "The loop has no way out and no EX, EX0, EX1, TEX0, TEX1 or TIM in which it would wait, so the \
        cycle never ends and the watchdog stops the PLC (manual 4.3). BEX does not wait. Put an EX-type \
        instruction into the loop.",
    why: "The cycle of 20 ms never ends: outputs are not written, and the control stops the PLC.",
    wrong: "\
MECH_BEGIN BLINK
AGAIN:
LDR -LAMP
WR LAMP
JUM AGAIN
MECH_END BLINK
FL 1,BLINK
",
    right: "\
MECH_BEGIN BLINK
AGAIN:
LDR -LAMP
WR LAMP
TIM -,25
JUM AGAIN
MECH_END BLINK
FL 1,BLINK
",
    chapter: "4.3",
    ..Rule::BASE
};
