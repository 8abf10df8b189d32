//! T0106 expected-operand.

use crate::diagnostics::{Rule, Severity};

/// T0106 expected-operand.
pub static EXPECTED_OPERAND: Rule = Rule {
    code: "T0106",
    name: "expected-operand",
    severity: Severity::Error,
    fixed: true,
    explanation: "Something is missing where an operand must stand, for instance after a sign or an opening bracket.",
    why: "A half-typed operand has no value to work with.",
    wrong: "\
LOD WORD.(TABLE+)
STO MIDDLE
",
    right: "\
LOD WORD.(TABLE+4)
STO MIDDLE
",
    chapter: "3.1",
    ..Rule::BASE
};
