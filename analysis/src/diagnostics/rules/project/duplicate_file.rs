//! T0007 duplicate-file.

use crate::diagnostics::{Rule, Severity};

/// T0007 duplicate-file.
pub static DUPLICATE_FILE: Rule = Rule {
    code: "T0007",
    name: "duplicate-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file is listed twice in `main` and `files`. It would be compiled twice and all its names would \
        clash. Remove one entry.",
    why: "Each module of the file would run twice in a cycle, and each of its names would be declared \
        twice.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
files = [\"doors.plc\", \"doors.plc\"]
;=== doors.plc
DATA
DATA_END
MODULE_MAIN
MODULE_MAIN_END
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
files = [\"doors.plc\"]
;=== doors.plc
DATA
DATA_END
MODULE_MAIN
MODULE_MAIN_END
",
    chapter: "5.4",
    ..Rule::BASE
};
