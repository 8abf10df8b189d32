//! T0411 access-outside-data.

use crate::diagnostics::{Rule, Severity};

/// T0411 access-outside-data.
pub static ACCESS_OUTSIDE_DATA: Rule = Rule {
    code: "T0411",
    name: "access-outside-data",
    severity: Severity::Error,
    fixed: true,
    explanation: "The access leaves the data area of the program altogether. Correct the offset.",
    why: "Behind the data area lies memory of the control: what happens is not foreseeable.",
    wrong: "\
LOD WORD.(TABLE+60000)
STO MIDDLE
",
    right: "\
LOD WORD.(TABLE+6)
STO MIDDLE
",
    chapter: "3.9",
    ..Rule::BASE
};
