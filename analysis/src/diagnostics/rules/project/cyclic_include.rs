//! T0010 cyclic-include.

use crate::diagnostics::{Rule, Severity};

/// T0010 cyclic-include.
pub static CYCLIC_INCLUDE: Rule = Rule {
    code: "T0010",
    name: "cyclic-include",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file includes itself, directly or through other files. The inclusion that closes the circle is \
        ignored. Move what both files need into a third one.",
    why: "A compiler that pasted the files into each other would never finish.",
    wrong: "\
T_INCLUDE a.inc
DATA
DATA_END
;=== a.inc
EQUI FIRST,1
T_INCLUDE b.inc
;=== b.inc
EQUI SECOND,2
T_INCLUDE a.inc
",
    right: "\
T_INCLUDE a.inc
DATA
DATA_END
;=== a.inc
EQUI FIRST,1
T_INCLUDE b.inc
;=== b.inc
EQUI SECOND,2
",
    chapter: "22",
    ..Rule::BASE
};
