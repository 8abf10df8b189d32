//! T0206 circular-constant.

use crate::diagnostics::{Rule, Severity};

/// T0206 circular-constant.
pub static CIRCULAR_CONSTANT: Rule = Rule {
    code: "T0206",
    name: "circular-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "The value of an EQUI constant depends on itself. Break the circle with a number.",
    why: "There is no number that fits.",
    wrong: "\
DATA
EQUI FIRST,SECOND+1
EQUI SECOND,FIRST+1
DATA_END
",
    right: "\
DATA
EQUI FIRST,1
EQUI SECOND,FIRST+1
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
