//! T1013.

use crate::diagnostics::{Rule, Severity};

/// T1013 macro-flag-order.
pub static MACRO_FLAG_ORDER: Rule = Rule {
    code: "T1013",
    name: "macro-flag-order",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The flags of END_T_MACRO and APPEND_T_MACRO stand in the order stack, conversion, debugging \
        (manual 22.4). They are understood all the same, but the original compiler reads them by their places.",
    why: "A flag in another place is silently taken for its default there.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO D_ON, T_END\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END, C_0, D_ON\n",
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
