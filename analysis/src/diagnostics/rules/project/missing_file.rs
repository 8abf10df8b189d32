//! T0004 missing-file.

use crate::diagnostics::{Rule, Severity};

/// T0004 missing-file.
pub static MISSING_FILE: Rule = Rule {
    code: "T0004",
    name: "missing-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file the project names cannot be read, so the program is incomplete. Correct the path (relative \
        to the folder of `technol.toml`, with `/`) or create the file.",
    ..Rule::BASE
};
