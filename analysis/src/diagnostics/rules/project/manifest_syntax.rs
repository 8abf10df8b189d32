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
    why: "Without a readable manifest nothing is known of the project: which files belong to it, where \
        included files lie, how texts are encoded. The defaults that step in seldom fit.",
    wrong: "\
;=== technol.toml
[project]
name = lathe
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
",
    ..Rule::BASE
};
