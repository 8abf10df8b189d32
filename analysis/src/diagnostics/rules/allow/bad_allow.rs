//! T1054 bad-allow.

use crate::diagnostics::{Rule, Severity};

/// T1054 bad-allow.
pub static BAD_ALLOW: Rule = Rule {
    code: "T1054",
    name: "bad-allow",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A comment begins with `;technol:` but is none of `;technol: allow(T0123)` and `;technol: \
        allow-file(T0123)`, or the latter does not stand in the first comment block of its file. \
        Several codes or names are separated by commas; a reason may follow the bracket.",
    why: "The comment looks as if it allowed something, and it has no effect.",
    wrong: "\
LDR START
WR MOTOR ;technol: allow T0504
",
    right: "\
LDR START
WR MOTOR
",
    ..Rule::BASE
};
