//! T1106 port-in-a-cell.

use crate::diagnostics::{Rule, Severity};

/// T1106 port-in-a-cell.
pub static PORT_IN_A_CELL: Rule = Rule {
    code: "T1106",
    name: "port-in-a-cell",
    severity: Severity::Warning,
    explanation: "The manual knows ANALOG_PORT with a number only. A cell is accepted, but its value is not checked before the program \
        runs, and a value outside 1 to 16 chooses no port. Write the number, or an EQUI constant.",
    why: "An output that follows a cell may end at another drive.",
    wrong: "\
ANALOG_PORT SMALL
ANALOG MIDDLE
",
    right: "\
ANALOG_PORT 5
ANALOG MIDDLE
",
    chapter: "12.2",
    ..Rule::BASE
};
