//! T0609 nested-block.

use crate::diagnostics::{Rule, Severity};

/// T0609 nested-block.
pub static NESTED_BLOCK: Rule = Rule {
    code: "T0609",
    name: "nested-block",
    severity: Severity::Error,
    fixed: true,
    explanation: "Modules, mechanisms and procedures do not stand inside each other, except mechanisms and \
        procedures in their module (manual 4.2, 5.2). Often the closing line of the outer one is missing.",
    why: "The inner block would be executed as a part of the outer one and would close it too early.",
    wrong: "\
MECH_BEGIN OUTER
MECH_BEGIN INNER
EX
MECH_END INNER
MECH_END OUTER
FL 1,OUTER,INNER
",
    right: "\
MECH_BEGIN OUTER
EX
MECH_END OUTER
MECH_BEGIN INNER
EX
MECH_END INNER
FL 1,OUTER,INNER
",
    chapter: "4.2",
    ..Rule::BASE
};
