//! T1018.

use crate::diagnostics::{Rule, Severity};

/// T1018 macro-hidden.
pub static MACRO_HIDDEN: Rule = Rule {
    code: "T1018",
    name: "macro-hidden",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The macro, or the word of an APPEND_T_MACRO, is called like an instruction. Instructions are \
        decoded first, so it is never used, unless CONTROL_T_MACRO PRE stands before its calls (manual 22.4). Rename \
        it, or switch to PRE.",
    why: "The program does not do what the definition says, without a word about it.",
    wrong: concat!(
        "DEF_T_MACRO FL1 STATE, LIGHT\n",
        "        LDR     START\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "CONTROL_T_MACRO PRE\n",
        "DEF_T_MACRO FL1 STATE, LIGHT\n",
        "        LDR     START\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL1     1,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
