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
    ..Rule::BASE
};
