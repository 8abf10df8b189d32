//! T0703 busy-loop.

use crate::diagnostics::{Rule, Severity};

/// T0703 busy-loop.
pub static BUSY_LOOP: Rule = Rule {
    code: "T0703",
    name: "busy-loop",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The loop waits for a condition without an EX-type instruction: while it turns, nothing else in the \
        PLC runs, so the condition usually cannot change. Use EX0 or EX1 to wait (manual 4.3).",
    ..Rule::BASE
};
