//! T1011.

use crate::diagnostics::{Rule, Severity};

/// T1011 t-local-place.
pub static T_LOCAL_PLACE: Rule = Rule {
    code: "T1011",
    name: "t-local-place",
    severity: Severity::Error,
    fixed: true,
    explanation: "T_LOCAL stands directly behind DEF_T_MACRO, before the first line of the body; several T_LOCAL \
        lines may follow each other (manual 22.3). Outside of macros it means nothing.",
    why: "The names must be known as local before the body uses them.",
    wrong: concat!(
        "DEF_T_MACRO SKIP KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        T_LOCAL NEXT\n",
        "        JL0     NEXT\n",
        "        FL      0,TMAC.LIGHT\n",
        "NEXT:\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SKIP KEY, LIGHT\n",
        "        T_LOCAL NEXT\n",
        "        LDR     TMAC.KEY\n",
        "        JL0     NEXT\n",
        "        FL      0,TMAC.LIGHT\n",
        "NEXT:\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SKIP    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.3",
    ..Rule::BASE
};
