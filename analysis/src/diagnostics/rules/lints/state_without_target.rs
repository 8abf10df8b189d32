//! T1107 state-without-target.

use crate::diagnostics::{Rule, Severity};

/// T1107 state-without-target.
pub static STATE_WITHOUT_TARGET: Rule = Rule {
    code: "T1107",
    name: "state-without-target",
    severity: Severity::Error,
    explanation: "ECATCMD_MASTER_STATE and ECATCMD_SLAVE_STATE bring a state: ECAT_COMMAND then needs a cell for it and a DWORD cell \
        with the length, both. The other commands need neither.",
    why: "Without them the answer has nowhere to go and the command ends with an error each time.",
    wrong: "\
FL 1,ASKING
MECH_BEGIN ASKING
    ECAT_COMMAND 0,1,ECATCMD_SLAVE_STATE
    EX0
    EQ   CNST.0
    WR   LAMP
MECH_END ASKING
",
    right: "\
FL 1,ASKING
MECH_BEGIN ASKING
    ECAT_COMMAND 0,1,ECATCMD_SLAVE_STATE,SMALL,LARGE
    EX0
    EQ   CNST.0
    WR   LAMP
MECH_END ASKING
",
    chapter: "26.4",
    ..Rule::BASE
};
