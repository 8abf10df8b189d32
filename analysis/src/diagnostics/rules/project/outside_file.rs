//! T0006 outside-file.

use crate::diagnostics::{Rule, Severity};

/// T0006 outside-file.
pub static OUTSIDE_FILE: Rule = Rule {
    code: "T0006",
    name: "outside-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A program file lies outside the folder of `technol.toml`. A project is one folder, so that it can \
        be copied and built elsewhere. Move the file into it; shared text can be included from `include- \
        dirs`.",
    why: "A copy or an archive of the folder would lack that file, and the build on another machine would \
        fail or take another file of the same name.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
files = [\"../shared/doors.plc\"]
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
    ..Rule::BASE
};
