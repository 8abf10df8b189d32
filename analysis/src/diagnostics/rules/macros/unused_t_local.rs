//! T1017.

use crate::diagnostics::{Rule, Severity};

/// T1017 unused-t-local.
pub static UNUSED_T_LOCAL: Rule = Rule {
    code: "T1017",
    name: "unused-t-local",
    severity: Severity::Warning,
    fixed: false,
    explanation: "T_LOCAL names a symbol that the body does not define (manual 22.3). It is a left-over or \
        misspelled; remove it, or correct the name.",
    why: "If the body uses the name, it means something that no call declares.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        T_LOCAL NEXT\n",
        "        LDR     TMAC.KEY\n",
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
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.3",
    ..Rule::BASE
};
