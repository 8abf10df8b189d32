//! T0501 pop-without-push.

use crate::diagnostics::{Rule, Severity};

/// T0501 pop-without-push.
pub static POP_WITHOUT_PUSH: Rule = Rule {
    code: "T0501",
    name: "pop-without-push",
    severity: Severity::Error,
    fixed: true,
    explanation: "LA, LO or LX without operand combines RLO with the value that a second LDR pushed, but nothing is \
        on the stack (manual 3.6). Give it an operand, or begin the part with LDR.",
    why: "The stack would deliver what an earlier equation left there, or nothing at all.",
    wrong: "\
LDR START
LA
WR MOTOR
",
    right: "\
LDR START
LA DOOR
WR MOTOR
",
    chapter: "3.6",
    ..Rule::BASE
};
