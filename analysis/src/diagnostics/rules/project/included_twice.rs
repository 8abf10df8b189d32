//! T0012 included-twice.

use crate::diagnostics::{Rule, Severity};

/// T0012 included-twice.
pub static INCLUDED_TWICE: Rule = Rule {
    code: "T0012",
    name: "included-twice",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file that declares memory is included more than once, so each of its names would be declared \
        twice. Include it in one DATA only: its names are known in all files.",
    ..Rule::BASE
};
