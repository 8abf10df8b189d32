//! T1149 timer-never-ends.

use crate::diagnostics::{Rule, Severity};

/// T1149 timer-never-ends.
pub static TIMER_NEVER_ENDS: Rule = Rule {
    code: "T1149",
    name: "timer-never-ends",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The limit that DR holds for TM is larger than its counter can count to. Declare the counter with \
        DS 2.",
    why: "A BYTE counts to 255 and begins again at 0, so the comparison never succeeds.",
    wrong: "\
DFTM01 TENTH
LDR START
LOD CNST.300
TM SMALL
WR LAMP
TENTH:
",
    right: "\
DFTM01 TENTH
LDR START
LOD CNST.300
TM MIDDLE
WR LAMP
TENTH:
",
    ..Rule::BASE
};
