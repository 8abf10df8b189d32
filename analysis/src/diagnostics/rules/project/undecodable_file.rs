//! T0013 undecodable-file.

use crate::diagnostics::{Rule, Severity};

/// T0013 undecodable-file.
pub static UNDECODABLE: Rule = Rule {
    code: "T0013",
    name: "undecodable-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file holds bytes that are no text in the encoding the project declares. They were replaced by \
        U+FFFD for reading. Set `encoding` in `technol.toml` to `auto`, `utf-8`, `windows-1250` or \
        `cp852`, or save the file again.",
    ..Rule::BASE
};
