//! T1147 read-only-cell.

use crate::diagnostics::{Rule, Severity};

/// T1147 read-only-cell.
pub static READ_ONLY_CELL: Rule = Rule {
    code: "T1147",
    name: "read-only-cell",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The instruction writes a cell or bit that the control writes and the program only reads. Write \
        the cell that belongs to the program; `technol explain NAME` tells the direction of \
        each.",
    why: "The control overwrites it in the next cycle or takes the value for its own: the write has no \
        effect or a wrong one.",
    wrong: "\
LDR START
WR CAPI
",
    right: "\
LDR START
WR STOPPI
",
    chapter: "8",
    ..Rule::BASE
};
