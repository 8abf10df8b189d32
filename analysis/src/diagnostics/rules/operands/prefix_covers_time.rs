//! T0413 prefix-covers-time.

use crate::diagnostics::{Rule, Severity};

/// T0413 prefix-covers-time.
pub static PREFIX_COVERS_TIME: Rule = Rule {
    code: "T0413",
    name: "prefix-covers-time",
    severity: Severity::Error,
    fixed: true,
    explanation: "A type prefix on the counter of TEX0, TEX1 or TIM also covers the time, which then cannot be a \
        constant (manual 4.2). Remove the prefix or put the time into a cell.",
    ..Rule::BASE
};
