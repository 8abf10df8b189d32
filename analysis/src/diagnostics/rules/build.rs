//! What the target cannot run.

use crate::diagnostics::{Rule, Severity};

/// T0801 not-executable.
pub static NOT_EXECUTABLE: Rule = Rule {
    code: "T0801",
    name: "not-executable",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction is known to the editor but this version's target cannot run it. `check` accepts \
        it, `build` refuses it.",
    ..Rule::BASE
};

/// T0802 too-large.
pub static TOO_LARGE: Rule = Rule {
    code: "T0802",
    name: "too-large",
    severity: Severity::Error,
    fixed: true,
    explanation: "The program or its data are larger than an image can hold. The message names what is too large; shorten \
        data areas, or leave out what is not needed.",
    ..Rule::BASE
};

/// T0803 not-translatable.
pub static NOT_TRANSLATABLE: Rule = Rule {
    code: "T0803",
    name: "not-translatable",
    severity: Severity::Error,
    fixed: true,
    explanation: "The line is well formed, but there is no code for it: CLEAR over two data areas, a symbol without \
        memory, a mechanism or procedure that stands in no module.",
    ..Rule::BASE
};
