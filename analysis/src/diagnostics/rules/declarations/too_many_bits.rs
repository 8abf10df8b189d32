//! T0207 too-many-bits.

use crate::diagnostics::{Rule, Severity};

/// T0207 too-many-bits.
pub static TOO_MANY_BITS: Rule = Rule {
    code: "T0207",
    name: "too-many-bits",
    severity: Severity::Error,
    fixed: true,
    explanation: "One DFM declares one byte with at most 8 bits, d0 first (manual 3.4). Put the further bits into \
        another DFM.",
    ..Rule::BASE
};
