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
    why: "Such an operand is generated or damaged, and no reader can check it.",
    wrong: "\
DATA
EQUI BIG,1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1
DATA_END
",
    right: "\
DATA
EQUI BIG,80
DATA_END
",
    ..Rule::BASE
};
