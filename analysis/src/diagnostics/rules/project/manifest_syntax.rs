//! T0001 manifest-syntax.

use crate::diagnostics::{Rule, Severity};

/// T0001 manifest-syntax.
pub static MANIFEST_SYNTAX: Rule = Rule {
    code: "T0001",
    name: "manifest-syntax",
    severity: Severity::Error,
    fixed: true,
    explanation: "`technol.toml` is not valid TOML. Nothing after the mistake can be trusted, so the project may \
        look incomplete until it is mended. Correct the line shown; strings stand in double quotes, lists \
        in square brackets.",
    ..Rule::BASE
};
