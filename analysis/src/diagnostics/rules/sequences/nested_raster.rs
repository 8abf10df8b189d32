//! T0706 nested-raster.

use crate::diagnostics::{Rule, Severity};

/// T0706 nested-raster.
pub static NESTED_RASTER: Rule = Rule {
    code: "T0706",
    name: "nested-raster",
    severity: Severity::Error,
    fixed: true,
    explanation: "DFTM blocks do not stand inside each other: the inner one would be reached only now and then. End \
        the first block before the second begins.",
    why: "The inner block only runs when both periods happen to end in the same cycle.",
    wrong: "\
DFTM1 SECOND
DFTM10 TENTH
LOD MIDDLE
INR
STO MIDDLE
TENTH:
SECOND:
",
    right: "\
DFTM1 SECOND
FL 1,LAMP
SECOND:
DFTM10 TENTH
LOD MIDDLE
INR
STO MIDDLE
TENTH:
",
    chapter: "3.11",
    ..Rule::BASE
};
