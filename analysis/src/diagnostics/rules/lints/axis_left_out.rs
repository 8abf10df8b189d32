//! T1105 axis-left-out.

use crate::diagnostics::{Rule, Severity};

/// T1105 axis-left-out.
pub static AXIS_LEFT_OUT: Rule = Rule {
    code: "T1105",
    name: "axis-left-out",
    severity: Severity::Warning,
    explanation: "SPI_AX without its fifth operand positions the axis of the last AX_SPI. Name the axis, so that it does not depend on \
        what ran before.",
    why: "On a machine with two rotary axes the wrong one may turn.",
    wrong: "\
SPI_AX -,-,LARGE,-
",
    right: "\
SPI_AX -,-,LARGE,-,4
",
    chapter: "12.4",
    ..Rule::BASE
};
