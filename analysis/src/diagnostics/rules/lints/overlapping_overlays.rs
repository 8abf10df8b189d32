//! T1145 overlapping-overlays.

use crate::diagnostics::{Rule, Severity};

/// T1145 overlapping-overlays.
pub static OVERLAPPING_OVERLAYS: Rule = Rule {
    code: "T1145",
    name: "overlapping-overlays",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Two text buffers are declared over the same bytes of a variable. Give each of them bytes of its \
        own: `STR 4,AREA` and `STR 4,AREA+5`, since a buffer takes one byte more than its \
        characters.",
    why: "Writing one text changes the other, end mark included.",
    wrong: "\
DATA
AREA: DS 20
FIRST: STR 6,AREA
SECOND: STR 6,AREA+4
DATA_END
",
    right: "\
DATA
AREA: DS 20
FIRST: STR 6,AREA
SECOND: STR 6,AREA+7
DATA_END
",
    ..Rule::BASE
};
