//! T0602 forbidden-module.

use crate::diagnostics::{Rule, Severity};

/// T0602 forbidden-module.
pub static FORBIDDEN_MODULE: Rule = Rule {
    code: "T0602",
    name: "forbidden-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "MODULE_INPUT, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE, MODULE_HALT and MODULE_CONT stand in the main \
        file only (manual 5.2). Move its code there.",
    ..Rule::BASE
};
