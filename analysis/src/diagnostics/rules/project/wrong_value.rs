//! T0003 wrong-value.

use crate::diagnostics::{Rule, Severity};

/// T0003 wrong-value.
pub static WRONG_VALUE: Rule = Rule {
    code: "T0003",
    name: "wrong-value",
    severity: Severity::Error,
    fixed: true,
    explanation: "A value of `technol.toml` has the wrong type or is not one of the allowed words. The default is \
        used instead. The message names what is expected.",
    ..Rule::BASE
};
