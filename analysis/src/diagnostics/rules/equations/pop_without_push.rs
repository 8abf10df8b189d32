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
    ..Rule::BASE
};
