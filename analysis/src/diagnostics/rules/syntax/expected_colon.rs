//! T0109 expected-colon.

use crate::diagnostics::{Rule, Severity};

/// T0109 expected-colon.
pub static EXPECTED_COLON: Rule = Rule {
    code: "T0109",
    name: "expected-colon",
    severity: Severity::Error,
    fixed: true,
    explanation: "A name before DFM, DS or STR ends with a colon (manual 3.3). The fix adds it.",
    why: "Only the colon tells a name from an instruction.",
    wrong: "\
DATA
LEVEL DS 2
DATA_END
",
    right: "\
DATA
LEVEL: DS 2
DATA_END
",
    chapter: "3.3",
    fix: true,
    ..Rule::BASE
};
