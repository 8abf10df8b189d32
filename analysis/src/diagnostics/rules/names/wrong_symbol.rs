//! T0304 wrong-symbol.

use crate::diagnostics::{Rule, Severity};

/// T0304 wrong-symbol.
pub static WRONG_SYMBOL: Rule = Rule {
    code: "T0304",
    name: "wrong-symbol",
    severity: Severity::Error,
    fixed: true,
    explanation: "The name is declared as something else than this operand needs, for instance a cell where a bit \
        belongs.",
    ..Rule::BASE
};
