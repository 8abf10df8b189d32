//! T0604 data-not-first.

use crate::diagnostics::{Rule, Severity};

/// T0604 data-not-first.
pub static DATA_NOT_FIRST: Rule = Rule {
    code: "T0604",
    name: "data-not-first",
    severity: Severity::Error,
    fixed: true,
    explanation: "DATA is the first module of every file; only comments, T_INCLUDE, macros, EQUI and DEBUG may stand \
        before it (manual 5.1).",
    ..Rule::BASE
};
