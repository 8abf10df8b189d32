//! T1110 regulator-in-closed-loop.

use crate::diagnostics::{Rule, Severity};

/// T1110 regulator-in-closed-loop.
pub static REGULATOR_IN_CLOSED_LOOP: Rule = Rule {
    code: "T1110",
    name: "regulator-in-closed-loop",
    severity: Severity::Hint,
    explanation: "A set of regulator parameters should be changed only while the axis stands and its position loop is open. Nothing \
        before this line clears the VAZBA_ bit of the axis. Clear it, wait a cycle, change the set, and set the bit again; \
        in MODULE_INIT the loop does not run yet.",
    why: "The jump of the parameters is a jump of the output: the axis may jerk.",
    wrong: "\
REGUL_X 2
",
    right: "\
FL 1,SHIFTING
MECH_BEGIN SHIFTING
    FL   0,VAZBA_X
    EX
    REGUL_X 2
    FL   1,VAZBA_X
MECH_END SHIFTING
",
    chapter: "13.1",
    ..Rule::BASE
};
