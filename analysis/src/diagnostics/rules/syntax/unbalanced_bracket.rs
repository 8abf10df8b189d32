//! T0105 unbalanced-bracket.

use crate::diagnostics::{Rule, Severity};

/// T0105 unbalanced-bracket.
pub static UNBALANCED_BRACKET: Rule = Rule {
    code: "T0105",
    name: "unbalanced-bracket",
    severity: Severity::Error,
    fixed: true,
    explanation: "A bracket has no partner. Expressions are written `(name+n)`, indexed cells `name[BX]` (manual \
        3.5).",
    why: "Without its partner it is not known how far the address reaches.",
    wrong: "\
LOD WORD.(TABLE+4
STO MIDDLE
",
    right: "\
LOD WORD.(TABLE+4)
STO MIDDLE
",
    chapter: "3.5",
    ..Rule::BASE
};
