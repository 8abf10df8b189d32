//! T0007 duplicate-file.

use crate::diagnostics::{Rule, Severity};

/// T0007 duplicate-file.
pub static DUPLICATE_FILE: Rule = Rule {
    code: "T0007",
    name: "duplicate-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file is listed twice in `main` and `files`. It would be compiled twice and all its names would \
        clash. Remove one entry.",
    ..Rule::BASE
};
