//! T1052 unknown-allow.

use crate::diagnostics::{Rule, Severity};

/// T1052 unknown-allow.
pub static UNKNOWN_ALLOW: Rule = Rule {
    code: "T1052",
    name: "unknown-allow",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A comment `;technol: allow(…)` names a rule that does not exist. Codes are T and four digits; \
        the name of a rule, such as `lost-equation`, does as well. `technol explain` shows a \
        rule.",
    why: "The comment looks as if it allowed something, and it has no effect.",
    wrong: "\
LDR START
WR MOTOR ;technol: allow(T9999)
",
    right: "\
LDR START
WR MOTOR
",
    ..Rule::BASE
};
