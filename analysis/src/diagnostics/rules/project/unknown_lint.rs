//! T0008 unknown-lint.

use crate::diagnostics::{Rule, Severity};

/// T0008 unknown-lint.
pub static UNKNOWN_LINT: Rule = Rule {
    code: "T0008",
    name: "unknown-lint",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`[lints]` names a code that no rule has, or tries to lower the severity of an error that makes a \
        program impossible to build. `technol explain T0301` shows a rule; a rule can be set to `off`, \
        `hint`, `warning` or `error`.",
    why: "The line has no effect, although it looks as if it silenced or raised something.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
[lints]
T9876 = \"off\"
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
[lints]
T0202 = \"off\"
",
    ..Rule::BASE
};
