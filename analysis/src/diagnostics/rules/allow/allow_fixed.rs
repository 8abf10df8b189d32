//! T1053 allow-fixed.

use crate::diagnostics::{Rule, Severity};

/// T1053 allow-fixed.
pub static ALLOW_FIXED: Rule = Rule {
    code: "T1053",
    name: "allow-fixed",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A comment `;technol: allow(…)` names a rule that cannot be allowed: its mistake keeps the \
        program from being built, or it watches over these comments. Correct the mistake and \
        remove the code.",
    why: "An error that stays an error should not look as if somebody had accepted it.",
    wrong: "\
LDR START
WR MOTOR ;technol: allow(T0301)
",
    right: "\
LDR START
WR MOTOR
",
    fix: true,
    ..Rule::BASE
};
