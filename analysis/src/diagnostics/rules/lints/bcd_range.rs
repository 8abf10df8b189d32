//! T1151 bcd-range.

use crate::diagnostics::{Rule, Severity};

/// T1151 bcd-range.
pub static BCD_RANGE: Rule = Rule {
    code: "T1151",
    name: "bcd-range",
    severity: Severity::Warning,
    fixed: false,
    explanation: "BCD converts numbers from 0 to 9999, with DWRD to 99999999, and BIN reads digits from 0 to 9 \
        only. The constant that is loaded before it is none of those.",
    why: "The result is no number anybody could read.",
    wrong: "\
LOD CNST.12000
BCD
STO MIDDLE
",
    right: "\
LOD CNST.9999
BCD
STO MIDDLE
",
    ..Rule::BASE
};
