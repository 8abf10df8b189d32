//! T0601 missing-module.

use crate::diagnostics::{Rule, Severity};

/// T0601 missing-module.
pub static MISSING_MODULE: Rule = Rule {
    code: "T0601",
    name: "missing-module",
    severity: Severity::Error,
    fixed: true,
    explanation: "A module is mandatory: in the main file DATA, MODULE_INPUT, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE, \
        MODULE_MAIN, MODULE_INIT, MODULE_CLEAR and MODULE_HALT, in further files DATA and MODULE_MAIN \
        (manual 5.4). It may be empty.",
    ..Rule::BASE
};
