//! T1020.

use crate::diagnostics::{Rule, Severity};

/// T1020 macro-structure.
pub static MACRO_STRUCTURE: Rule = Rule {
    code: "T1020",
    name: "macro-structure",
    severity: Severity::Error,
    fixed: true,
    explanation: "The body of a macro consists of instructions, DATA_LOCAL and EQUI. Mechanisms and procedures, \
        STOP, DEBUG, T_INCLUDE and other directives cannot come out of a call (manual 22.2). Move the line out of \
        the definition.",
    why: "Where mechanisms and modules begin must be seen in the text itself; an expansion goes to where \
        instructions stand.",
    wrong: concat!(
        "DEF_T_MACRO CLAMP LIGHT\n",
        "        MECH_BEGIN HOLD\n",
        "        FL      1,TMAC.LIGHT\n",
        "        MECH_END HOLD\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO CLAMP LIGHT\n",
        "        FL      1,TMAC.LIGHT\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        MECH_BEGIN HOLD\n",
        "        CLAMP   MOTOR\n",
        "        EX\n",
        "        MECH_END HOLD\n",
        "        FL      1,HOLD\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.2",
    ..Rule::BASE
};
