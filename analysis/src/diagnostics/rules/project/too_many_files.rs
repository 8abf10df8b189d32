//! T0005 too-many-files.

use crate::diagnostics::{Rule, Severity};

/// T0005 too-many-files.
pub static TOO_MANY_FILES: Rule = Rule {
    code: "T0005",
    name: "too-many-files",
    severity: Severity::Error,
    fixed: true,
    explanation: "A program has at most 64 source files: the main file and 63 further ones (manual 5.4). Join files, \
        or move constants into included files, which do not count.",
    ..Rule::BASE
};
