//! T0006 outside-file.

use crate::diagnostics::{Rule, Severity};

/// T0006 outside-file.
pub static OUTSIDE_FILE: Rule = Rule {
    code: "T0006",
    name: "outside-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A program file lies outside the folder of `technol.toml`. A project is one folder, so that it can \
        be copied and built elsewhere. Move the file into it; shared text can be included from `include- \
        dirs`.",
    ..Rule::BASE
};
