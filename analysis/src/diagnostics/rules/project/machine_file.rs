//! T0014 machine-file.

use crate::diagnostics::{Rule, Severity};

/// T0014 machine-file.
pub static MACHINE_FILE: Rule = Rule {
    code: "T0014",
    name: "machine-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "The file that `[machine] file` of `technol.toml` names cannot be read, or describes a machine that \
        does not work: an unknown key, a signal that is no port bit, one input driven twice. `technol check` reports \
        it in that file; the program itself builds, but `technol run` and the embedded target need the machine.",
    why: "Inputs that no signal drives stay 0: the program would wait for a plant that is not there.",
    wrong: "\
; [machine] file names a file with an unknown key
",
    right: "\
; the machine file loads
",
    ..Rule::BASE
};
