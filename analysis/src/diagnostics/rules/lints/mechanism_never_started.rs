//! T1134 mechanism-never-started.

use crate::diagnostics::{Rule, Severity};

/// T1134 mechanism-never-started.
pub static MECHANISM_NEVER_STARTED: Rule = Rule {
    code: "T1134",
    name: "mechanism-never-started",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Nothing sets the activation bit of the mechanism: no FL 1, FL1 1, WR or other write names it in \
        any file of the project. Start it, for instance `FL 1,NAME`, or remove it.",
    why: "The mechanism never runs, and whoever waits for its end goes on at once.",
    wrong: "\
MECH_BEGIN CLAMP
FL 1,VALVE
EX
MECH_END CLAMP
",
    right: "\
LDR START
FL1 1,CLAMP
MECH_BEGIN CLAMP
FL 1,VALVE
EX
MECH_END CLAMP
",
    ..Rule::BASE
};
