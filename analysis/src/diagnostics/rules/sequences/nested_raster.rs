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
    ..Rule::BASE
};
