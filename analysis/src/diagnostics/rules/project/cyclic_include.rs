//! T0010 cyclic-include.

use crate::diagnostics::{Rule, Severity};

/// T0010 cyclic-include.
pub static CYCLIC_INCLUDE: Rule = Rule {
    code: "T0010",
    name: "cyclic-include",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file includes itself, directly or through other files. The inclusion that closes the circle is \
        ignored. Move what both files need into a third one.",
    ..Rule::BASE
};
