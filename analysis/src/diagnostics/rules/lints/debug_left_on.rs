//! T1148 debug-left-on.

use crate::diagnostics::{Rule, Severity};

/// T1148 debug-left-on.
pub static DEBUG_LEFT_ON: Rule = Rule {
    code: "T1148",
    name: "debug-left-on",
    severity: Severity::Info,
    fixed: false,
    explanation: "DEBUG switches break-points on for the lines below it, and the file ends without DEBUG OFF. \
        Close the region, or remove DEBUG when the program goes to the machine.",
    why: "In the original control each line of such a region costs time and memory.",
    wrong: "\
DEBUG ON
MODULE_MAIN
MODULE_MAIN_END
",
    right: "\
MODULE_MAIN
MODULE_MAIN_END
",
    chapter: "5.5",
    ..Rule::BASE
};
