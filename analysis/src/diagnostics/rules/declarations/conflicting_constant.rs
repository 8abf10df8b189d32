//! T0204 conflicting-constant.

use crate::diagnostics::{Rule, Severity};

/// T0204 conflicting-constant.
pub static CONFLICTING_CONSTANT: Rule = Rule {
    code: "T0204",
    name: "conflicting-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "EQUI gives one name two different values; constants are known in the whole project. Remove one or \
        rename it.",
    why: "Which of the two values a line gets would depend on the order of the files.",
    wrong: "\
DATA
EQUI T_DOOR,50
EQUI T_DOOR,60
DATA_END
",
    right: "\
DATA
EQUI T_DOOR,50
EQUI T_DOOR_LONG,60
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
