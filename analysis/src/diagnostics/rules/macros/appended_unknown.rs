//! T1019.

use crate::diagnostics::{Rule, Severity};

/// T1019 appended-unknown.
pub static APPENDED_UNKNOWN: Rule = Rule {
    code: "T1019",
    name: "appended-unknown",
    severity: Severity::Error,
    fixed: true,
    explanation: "The second operand of APPEND_T_MACRO is not a macro of this project (manual 22.4). The first one \
        is the word that is written in the program, the second one the macro that it calls.",
    why: "The word would call nothing.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "APPEND_T_MACRO LIGHT_ON, SHOWN\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "APPEND_T_MACRO LIGHT_ON, SHOW, T_END\n",
        "MODULE_MAIN\n",
        "        LIGHT_ON START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
