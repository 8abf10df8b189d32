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
    why: "The ninth bit would belong to another byte, and copying the byte to a port would lose it.",
    wrong: "\
DATA
DFM A0,A1,A2,A3,A4,A5,A6,A7,A8
DATA_END
",
    right: "\
DATA
DFM A0,A1,A2,A3,A4,A5,A6,A7
DFM A8
DATA_END
",
    chapter: "3.4",
    ..Rule::BASE
};
