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
    why: "Characters with diacritics in texts for the operator would be shown wrongly, and saving the file \
        would lose the bytes.",
    wrong: "\
; a byte 0x81 in a file declared as windows-1250
",
    right: "\
; the same comment in the declared encoding
",
    ..Rule::BASE
};
