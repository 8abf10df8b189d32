//! T1139 unreachable-code.

use crate::diagnostics::{Rule, Severity};

/// T1139 unreachable-code.
pub static UNREACHABLE_CODE: Rule = Rule {
    code: "T1139",
    name: "unreachable-code",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The line before always jumps away, and no jump leads to a label between here and the next code \
        that is reached. Remove the lines, or put a label before them.",
    why: "The lines look as if they did something. Often a label is missing, or the jump before them has \
        lost its condition.",
    wrong: "\
LDR START
WR MOTOR
JUM OVER
FL 1,LAMP
OVER:
",
    right: "\
LDR START
WR MOTOR
LDR MOTOR
JL1 OVER
FL 1,LAMP
OVER:
",
    unnecessary: true,
    ..Rule::BASE
};
