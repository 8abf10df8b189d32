//! T1012.

use crate::diagnostics::{Rule, Severity};

/// T1012 macro-flags.
pub static MACRO_FLAGS: Rule = Rule {
    code: "T1012",
    name: "macro-flags",
    severity: Severity::Error,
    fixed: true,
    explanation: "END_T_MACRO and APPEND_T_MACRO take at most one flag of each kind: T_NORMAL, T_BEGIN, T_END, \
        T_PUSH or T_POP for the stack, C_0 or C_1 for the conversion of operands, D_OFF or D_ON for break-points \
        (manual 22.4).",
    why: "The flags tell the compiler what a call does; a word that it does not know cannot tell it anything.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_FINAL\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
