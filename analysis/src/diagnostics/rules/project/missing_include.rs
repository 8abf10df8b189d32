//! T0009 missing-include.

use crate::diagnostics::{Rule, Severity};

/// T0009 missing-include.
pub static MISSING_INCLUDE: Rule = Rule {
    code: "T0009",
    name: "missing-include",
    severity: Severity::Error,
    fixed: true,
    explanation: "The file named by T_INCLUDE is not found. Without apostrophes it is searched in the folder of the \
        main file, then in `include-dirs`; in apostrophes in `system-dir` (manual 22). Correct the name or \
        add the folder to `technol.toml`.",
    why: "The constants and macros of that file are unknown, so every use of them would be reported as \
        well.",
    wrong: "\
T_INCLUDE times.inc
DATA
DATA_END
;=== time.inc
EQUI T_CLAMP,50
",
    right: "\
T_INCLUDE times.inc
DATA
DATA_END
;=== times.inc
EQUI T_CLAMP,50
",
    chapter: "22",
    ..Rule::BASE
};
