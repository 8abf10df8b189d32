//! T0409 real-not-allowed.

use crate::diagnostics::{Rule, Severity};

/// T0409 real-not-allowed.
pub static REAL_NOT_ALLOWED: Rule = Rule {
    code: "T0409",
    name: "real-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "A real number or `REAL.` is used with an instruction that computes with integers only (manual 3.16 \
        lists the real ones). A real constant is written `CNST.1.5` and takes no other prefix.",
    why: "Integers and reals live in different registers; the instruction knows the integer one only.",
    wrong: "\
LOD LARGE
ORB CNST.1.5
STO LARGE
",
    right: "\
LOD LARGE
ORB CNST.1
STO LARGE
",
    chapter: "3.16",
    ..Rule::BASE
};
