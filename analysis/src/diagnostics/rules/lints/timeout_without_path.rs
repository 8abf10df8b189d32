//! T1137 timeout-without-path.

use crate::diagnostics::{Rule, Severity};

/// T1137 timeout-without-path.
pub static TIMEOUT_WITHOUT_PATH: Rule = Rule {
    code: "T1137",
    name: "timeout-without-path",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The label of TEX0 or TEX1 stands at the instruction that follows it, so the sequence goes on in \
        the same way whether the condition came or the time ran out. Lead the time-out to a \
        place of its own. When the pause alone is meant, TIM says so.",
    why: "A drive that does not answer is taken for one that does.",
    wrong: "\
FL 1,OPEN
MECH_BEGIN OPEN
FL 1,VALVE
BEX
LDR DOOR
TEX0 -,50,GO_ON
GO_ON:
FL 0,VALVE
MECH_END OPEN
",
    right: "\
FL 1,OPEN
MECH_BEGIN OPEN
FL 1,VALVE
BEX
LDR DOOR
TEX0 -,50,LATE
JUM GO_ON
LATE:
FL 1,LAMP
GO_ON:
FL 0,VALVE
MECH_END OPEN
",
    chapter: "4.3",
    ..Rule::BASE
};
