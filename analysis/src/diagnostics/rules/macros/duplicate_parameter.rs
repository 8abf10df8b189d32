//! T1021.

use crate::diagnostics::{Rule, Severity};

/// T1021 duplicate-parameter.
pub static DUPLICATE_PARAMETER: Rule = Rule {
    code: "T1021",
    name: "duplicate-parameter",
    severity: Severity::Error,
    fixed: true,
    explanation: "A name stands twice among the parameters and T_LOCAL symbols of a macro (manual 22.2, 22.3). \
        Rename one of them.",
    why: "What the name means in the body would be a guess.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT, KEY\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
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
    chapter: "22.2",
    ..Rule::BASE
};
