//! T1002.

use crate::diagnostics::{Rule, Severity};

/// T1002 macro-redefined.
pub static MACRO_REDEFINED: Rule = Rule {
    code: "T1002",
    name: "macro-redefined",
    severity: Severity::Error,
    fixed: true,
    explanation: "Two DEF_T_MACRO of the project have the same name, so a call could mean either (manual 22.2). \
        Rename one of them or remove it. A definition file may be included by several program files: that is one \
        definition.",
    why: "Which body a call gets would depend on where it stands, which nobody sees when reading it.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     -TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "DEF_T_MACRO SHOW_NOT KEY, LIGHT\n",
        "        LDR     -TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "        SHOW_NOT DOOR, M0\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.2",
    ..Rule::BASE
};
