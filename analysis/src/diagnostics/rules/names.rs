//! Names that mean nothing, or something else than the place needs.

use crate::diagnostics::{Rule, Severity};

/// T0301 unknown-symbol.
pub static UNKNOWN_SYMBOL: Rule = Rule {
    code: "T0301",
    name: "unknown-symbol",
    severity: Severity::Error,
    fixed: true,
    explanation: "The name is not declared: not in DATA of any file, not in DATA_LOCAL of this file, and it is not \
        predefined. The message offers the nearest name. Declare it with DFM, DS or EQUI (manual 3.4).",
    ..Rule::BASE
};

/// T0302 unknown-label.
pub static UNKNOWN_LABEL: Rule = Rule {
    code: "T0302",
    name: "unknown-label",
    severity: Severity::Error,
    fixed: true,
    explanation: "The jump leads to a label that does not stand in the same module, mechanism or procedure. Jumps do \
        not cross their borders. Put `NAME:` before the target.",
    ..Rule::BASE
};

/// T0303 duplicate-label.
pub static DUPLICATE_LABEL: Rule = Rule {
    code: "T0303",
    name: "duplicate-label",
    severity: Severity::Error,
    fixed: true,
    explanation: "A label stands twice in one module, mechanism or procedure, so a jump to it is ambiguous. Rename \
        one.",
    ..Rule::BASE
};

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
