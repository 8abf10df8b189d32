//! T0502 value-left-on-stack.

use crate::diagnostics::{Rule, Severity};

/// T0502 value-left-on-stack.
pub static VALUE_LEFT_ON_STACK: Rule = Rule {
    code: "T0502",
    name: "value-left-on-stack",
    severity: Severity::Error,
    fixed: true,
    explanation: "An LDR inside an open equation pushes the old RLO, and nothing takes it back before the end of the \
        module, mechanism or procedure, or before CHECK (manual 3.6). Either LA, LO or LX without operand \
        is missing, or the equation before the LDR was not closed by a terminal instruction (WR, FL1, JL0, \
        JL1, STO1, EX0 …).",
    why: "The stack fills up from cycle to cycle, and later equations take values that are not theirs.",
    wrong: "\
LDR START
LA DOOR
LDR M0
WR MOTOR
",
    right: "\
LDR START
LA DOOR
LDR M0
LO
WR MOTOR
",
    chapter: "3.6",
    ..Rule::BASE
};
