//! T0411 access-outside-data.

use crate::diagnostics::{Rule, Severity};

/// T0411 access-outside-data.
pub static ACCESS_OUTSIDE_DATA: Rule = Rule {
    code: "T0411",
    name: "access-outside-data",
    severity: Severity::Error,
    fixed: true,
    explanation: "The access leaves the data area of the program altogether. Correct the offset.",
    ..Rule::BASE
};
