//! T0705 raster-end.

use crate::diagnostics::{Rule, Severity};

/// T0705 raster-end.
pub static RASTER_END: Rule = Rule {
    code: "T0705",
    name: "raster-end",
    severity: Severity::Error,
    fixed: true,
    explanation: "The end label of a DFTM block stands after it in the same module, mechanism or procedure (manual \
        3.11).",
    why: "The block is skipped by a jump to its end; an end before the beginning would make a loop.",
    wrong: "\
SECOND:
DFTM1 SECOND
LOD MIDDLE
INR
STO MIDDLE
",
    right: "\
DFTM1 SECOND
LOD MIDDLE
INR
STO MIDDLE
SECOND:
",
    chapter: "3.11",
    ..Rule::BASE
};
