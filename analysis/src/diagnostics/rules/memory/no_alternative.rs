//! T0422 no-such-operand.

use crate::diagnostics::{Rule, Severity};

/// T0422 no-such-operand.
pub static NO_ALTERNATIVE: Rule = Rule {
    code: "T0422",
    name: "no-such-operand",
    severity: Severity::Error,
    fixed: true,
    explanation: "The place takes operands of several kinds and this one is none of them; the message lists what may \
        stand there.",
    why: "The instruction would work with something else than it expects.",
    wrong: "MODULE_INIT\n        SHARE_VAR MIDDLE,'Speed',TYPE_WORD,START\nMODULE_INIT_END\n",
    right: "MODULE_INIT\n        SHARE_VAR MIDDLE,'Speed',TYPE_WORD,RATIO\nMODULE_INIT_END\n",
    chapter: "3.1",
    ..Rule::BASE
};
