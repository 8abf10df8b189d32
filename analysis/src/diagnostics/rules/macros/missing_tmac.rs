//! T1008.

use crate::diagnostics::{Rule, Severity};

/// T1008 missing-tmac.
pub static MISSING_TMAC: Rule = Rule {
    code: "T1008",
    name: "missing-tmac",
    severity: Severity::Error,
    fixed: true,
    explanation: "A TECHNOL instruction of the body takes a parameter only with the prefix TMAC.; without it the \
        name means a symbol of the project (manual 22.3). One TMAC. covers the whole operand and stands before other \
        prefixes, behind a minus sign. 80386 instructions and calls of other macros take parameters without it.",
    why: "Without the prefix the operand of the call is not put in: the body would work on a name that does not \
        exist.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     KEY\n",
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
