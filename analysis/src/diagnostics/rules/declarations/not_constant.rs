//! T0205 not-constant.

use crate::diagnostics::{Rule, Severity};

/// T0205 not-constant.
pub static NOT_CONSTANT: Rule = Rule {
    code: "T0205",
    name: "not-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "A constant is needed here: a number, a character, the name of an EQUI constant, or a sum of those \
        (manual 3.4). A number with a decimal point is no integer constant.",
    why: "Memory is laid out before the program runs, so nothing that changes at run time can decide about \
        it.",
    wrong: "\
DATA
EQUI LENGTH,2.5
DATA_END
",
    right: "\
DATA
EQUI LENGTH,2
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
