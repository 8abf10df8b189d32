//! T0410 access-past-cell.

use crate::diagnostics::{Rule, Severity};

/// T0410 access-past-cell.
pub static ACCESS_PAST_CELL: Rule = Rule {
    code: "T0410",
    name: "access-past-cell",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The access begins inside a symbol and reaches past its declared memory into what follows it, for instance \
        `WORD.` on a BYTE cell: the prefix wins (manual 3.9). Declare a larger cell or use another prefix. An access \
        that begins at a neighbour, written `name+n`, is taken as meant.",
    why: "The access also reads or overwrites the cells that follow, and moves with every declaration that \
        is added between them.",
    wrong: "\
LOD DWRD.MIDDLE
STO LARGE
",
    right: "\
LOD MIDDLE
STO LARGE
",
    chapter: "3.9",
    ..Rule::BASE
};
