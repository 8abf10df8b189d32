//! T1006.

use crate::diagnostics::{Rule, Severity};

/// T1006 macro-nested.
pub static MACRO_NESTED: Rule = Rule {
    code: "T1006",
    name: "macro-nested",
    severity: Severity::Error,
    fixed: true,
    explanation: "Another DEF_T_MACRO, a module or DATA begins before END_T_MACRO. A macro may call others, but it \
        cannot hold their definitions (manual 22.2). Close the first definition before the next one begins.",
    why: "Where the first definition ends would be a guess.",
    wrong: concat!(
        "DEF_T_MACRO OUTER LIGHT\n",
        "        LDR     TMAC.LIGHT\n",
        "        WR      TMAC.LIGHT\n",
        "DEF_T_MACRO INNER LIGHT\n",
        "        FL      0,TMAC.LIGHT\n",
        "END_T_MACRO\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO INNER LIGHT\n",
        "        FL      0,TMAC.LIGHT\n",
        "END_T_MACRO\n",
        "DEF_T_MACRO OUTER LIGHT\n",
        "        INNER   TMAC.LIGHT\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        OUTER   MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.2",
    ..Rule::BASE
};
