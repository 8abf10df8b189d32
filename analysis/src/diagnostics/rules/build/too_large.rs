//! T0802 too-large.

use crate::diagnostics::{Rule, Severity};

/// T0802 too-large.
pub static TOO_LARGE: Rule = Rule {
    code: "T0802",
    name: "too-large",
    severity: Severity::Error,
    fixed: true,
    explanation: "The program or its data are larger than an image can hold. The message names what is too large; shorten \
        data areas, or leave out what is not needed.",
    ..Rule::BASE
};
