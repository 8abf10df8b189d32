//! T0002 unknown-key.

use crate::diagnostics::{Rule, Severity};

/// T0002 unknown-key.
pub static UNKNOWN_KEY: Rule = Rule {
    code: "T0002",
    name: "unknown-key",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`technol.toml` holds a table or key this version does not know, usually a misspelling, so it has \
        no effect. Keys are written in kebab-case: `[project] name, main, files, include-dirs, system-dir, \
        configuration, encoding`, `[machine] file`, `[target] address`, `[debug] everywhere`, `[lints]`.",
    why: "A misspelled key looks as if it were set, and the default applies unnoticed.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
encodin = \"utf-8\"
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
encoding = \"utf-8\"
",
    ..Rule::BASE
};
