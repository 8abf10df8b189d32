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
    why: "The control has code segments for so many files and no more, so a larger program cannot be \
        loaded.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
;repeat files = [\"f1.plc\", …, \"f64.plc\"]
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
",
    chapter: "5.4",
    ..Rule::BASE
};
