//! T0802 too-large.

use crate::diagnostics::{Rule, Severity};

/// T0802 too-large.
pub static TOO_LARGE: Rule = Rule {
    code: "T0802",
    name: "too-large",
    severity: Severity::Error,
    fixed: true,
    explanation: "The program or its data are larger than an image can hold. The message names what is too large; shorten \
        data areas, or leave out what is not needed.",
    why: "Addresses of the target have a fixed width.",
    wrong: "\
DATA
HUGE: DS 0FFFFFh
MORE: DS 2
DATA_END
MODULE_INPUT
MODULE_INPUT_END
",
    right: "\
DATA
HUGE: DS 0FFFh
MORE: DS 2
DATA_END
MODULE_INPUT
MODULE_INPUT_END
",
    chapter: "5.4",
    ..Rule::BASE
};
