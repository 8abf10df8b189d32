//! T0012 included-twice.

use crate::diagnostics::{Rule, Severity};

/// T0012 included-twice.
pub static INCLUDED_TWICE: Rule = Rule {
    code: "T0012",
    name: "included-twice",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file that declares memory is included more than once, so each of its names would be declared \
        twice. Include it in one DATA only: its names are known in all files.",
    why: "Memory would be reserved twice under the same names. Constants may be included as often as \
        needed: they reserve nothing.",
    wrong: "\
DATA
T_INCLUDE cells.inc
DATA_END
DATA_LOCAL
T_INCLUDE cells.inc
DATA_LOCAL_END
;=== cells.inc
LEVEL: DS 2
",
    right: "\
DATA
T_INCLUDE cells.inc
DATA_END
DATA_LOCAL
DATA_LOCAL_END
;=== cells.inc
LEVEL: DS 2
",
    chapter: "22",
    ..Rule::BASE
};
