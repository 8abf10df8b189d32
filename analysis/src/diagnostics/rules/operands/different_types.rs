//! T0412 different-types.

use crate::diagnostics::{Rule, Severity};

/// T0412 different-types.
pub static DIFFERENT_TYPES: Rule = Rule {
    code: "T0412",
    name: "different-types",
    severity: Severity::Error,
    fixed: true,
    explanation: "MOVE and MOVE1 copy between operands of one type (manual 3.10). Use LOD and STO to convert, or the \
        same prefix on both sides.",
    why: "The copy would take too many bytes from the source or leave some of the destination as they \
        were.",
    wrong: "\
MOVE LARGE,MIDDLE
",
    right: "\
LOD MIDDLE
STO LARGE
",
    chapter: "3.10",
    ..Rule::BASE
};
