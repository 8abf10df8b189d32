//! T1007.

use crate::diagnostics::{Rule, Severity};

/// T1007 unknown-parameter.
pub static UNKNOWN_PARAMETER: Rule = Rule {
    code: "T1007",
    name: "unknown-parameter",
    severity: Severity::Error,
    fixed: true,
    explanation: "TMAC. announces a parameter of the macro, but none of the names behind it is one (manual 22.3). \
        Write the name as DEF_T_MACRO has it; a name of the project stands without TMAC.",
    why: "Nothing would be put in its place: the call could not be translated.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEYS\n",
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
    chapter: "22.3",
    fix: true,
    ..Rule::BASE
};
