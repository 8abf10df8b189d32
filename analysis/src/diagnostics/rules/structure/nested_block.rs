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
    ..Rule::BASE
};
