//! T1152 overlay-elsewhere.

use crate::diagnostics::{Rule, Severity};

/// T1152 overlay-elsewhere.
pub static OVERLAY_ELSEWHERE: Rule = Rule {
    code: "T1152",
    name: "overlay-elsewhere",
    severity: Severity::Error,
    fixed: false,
    explanation: "A text buffer is declared over a variable that another file declares. Declare the buffer in that \
        file: its name is known in all files.",
    why: "The original compiler translates file by file and knows the place of a variable in its own file \
        only.",
    wrong: "\
DATA
TITLE: STR 6,AREA
DATA_END
;=== texts.plc
DATA
AREA: DS 20
DATA_END
",
    right: "\
DATA
DATA_END
;=== texts.plc
DATA
AREA: DS 20
TITLE: STR 6,AREA
DATA_END
",
    chapter: "3.18",
    ..Rule::BASE
};
