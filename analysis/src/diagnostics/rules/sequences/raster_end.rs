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
    ..Rule::BASE
};
