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
    why: "A bit is one position in a byte, a cell is whole bytes: what one instruction does with them \
        makes no sense for the other.",
    wrong: "\
LDR SMALL
WR MOTOR
",
    right: "\
LDR START
WR MOTOR
",
    chapter: "3.9",
    ..Rule::BASE
};
