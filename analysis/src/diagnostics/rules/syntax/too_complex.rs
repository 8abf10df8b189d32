//! T0110 too-complex.

use crate::diagnostics::{Rule, Severity};

/// T0110 too-complex.
pub static TOO_COMPLEX: Rule = Rule {
    code: "T0110",
    name: "too-complex",
    severity: Severity::Error,
    fixed: true,
    explanation: "The operand has more operators and brackets than any program needs. Give a part of it a name with \
        EQUI.",
    ..Rule::BASE
};
