//! T0801 not-executable.

use crate::diagnostics::{Rule, Severity};

/// T0801 not-executable.
pub static NOT_EXECUTABLE: Rule = Rule {
    code: "T0801",
    name: "not-executable",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction is known to the editor but this version's target cannot run it. `check` accepts \
        it, `build` refuses it.",
    why: "The editor knows every instruction of the language; the target that comes with it executes a \
        part of them, and silence would hide the difference.",
    wrong: "\
IMUL BX
",
    right: "\
NOP
",
    ..Rule::BASE
};
