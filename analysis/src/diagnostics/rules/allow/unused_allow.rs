//! T1051 unused-allow.

use crate::diagnostics::{Rule, Severity};

/// T1051 unused-allow.
pub static UNUSED_ALLOW: Rule = Rule {
    code: "T1051",
    name: "unused-allow",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A comment `;technol: allow(…)` names a rule that reports nothing there. Remove the code, or move \
        the comment to the line, section or file it is meant for.",
    why: "The mistake was corrected, or the comment slipped away from its line. If it stayed, it would \
        hide the next mistake of its kind.",
    wrong: "\
LDR START
WR MOTOR ;technol: allow(T0504)
",
    right: "\
LDR START
WR MOTOR
",
    fix: true,
    ..Rule::BASE
};
