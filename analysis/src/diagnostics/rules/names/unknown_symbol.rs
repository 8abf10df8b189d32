//! T0301 unknown-symbol.

use crate::diagnostics::{Rule, Severity};

/// T0301 unknown-symbol.
pub static UNKNOWN_SYMBOL: Rule = Rule {
    code: "T0301",
    name: "unknown-symbol",
    severity: Severity::Error,
    fixed: true,
    explanation: "The name is not declared: not in DATA of any file, not in DATA_LOCAL of this file, and it is not \
        predefined. The message offers the nearest name. Declare it with DFM, DS or EQUI (manual 3.4).",
    why: "There is no memory behind the name; mostly a letter is wrong.",
    wrong: "\
LDR STRAT
WR MOTOR
",
    right: "\
LDR START
WR MOTOR
",
    chapter: "3.4",
    fix: true,
    ..Rule::BASE
};
