//! T0003 wrong-value.

use crate::diagnostics::{Rule, Severity};

/// T0003 wrong-value.
pub static WRONG_VALUE: Rule = Rule {
    code: "T0003",
    name: "wrong-value",
    severity: Severity::Error,
    fixed: true,
    explanation: "A value of `technol.toml` has the wrong type or is not one of the allowed words. The default is \
        used instead. The message names what is expected.",
    why: "The default that replaces the value may change what the program does, for instance how its texts \
        are decoded.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
encoding = \"latin2\"
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
encoding = \"windows-1250\"
",
    ..Rule::BASE
};
