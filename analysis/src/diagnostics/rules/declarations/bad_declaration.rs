//! T0211 bad-declaration.

use crate::diagnostics::{Rule, Severity};

/// T0211 bad-declaration.
pub static BAD_DECLARATION: Rule = Rule {
    code: "T0211",
    name: "bad-declaration",
    severity: Severity::Error,
    fixed: true,
    explanation: "The declaration does not have the form its instruction needs; the message shows it.",
    why: "A name whose declaration is not understood cannot be used, so every use of it would be wrong \
        too.",
    wrong: "\
DATA
EQUI LENGTH
DATA_END
",
    right: "\
DATA
EQUI LENGTH,5
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
