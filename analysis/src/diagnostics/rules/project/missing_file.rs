//! T0004 missing-file.

use crate::diagnostics::{Rule, Severity};

/// T0004 missing-file.
pub static MISSING_FILE: Rule = Rule {
    code: "T0004",
    name: "missing-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file the project names cannot be read, so the program is incomplete. Correct the path (relative \
        to the folder of `technol.toml`, with `/`) or create the file.",
    why: "Everything that file declares would be reported as unknown in the others; this is the one \
        mistake to correct first.",
    wrong: "\
;=== technol.toml
[project]
name = \"lathe\"
files = [\"spindel.plc\"]
;=== spindle.plc
DATA
DATA_END
MODULE_MAIN
MODULE_MAIN_END
",
    right: "\
;=== technol.toml
[project]
name = \"lathe\"
files = [\"spindle.plc\"]
;=== spindle.plc
DATA
DATA_END
MODULE_MAIN
MODULE_MAIN_END
",
    ..Rule::BASE
};
