//! T1001.

use crate::diagnostics::{Rule, Severity};

/// T1001 macro-arguments.
pub static MACRO_ARGUMENTS: Rule = Rule {
    code: "T1001",
    name: "macro-arguments",
    severity: Severity::Error,
    fixed: true,
    explanation: "A macro takes exactly as many operands as its DEF_T_MACRO names parameters, in that order (manual \
        22.2). There are no default values, so none may be left out or empty. Count the operands of the call against \
        the header that is shown beside it.",
    why: "The first operand goes to the first parameter and so on: with one too few the body would work on names \
        that nobody gave it.",
    wrong: concat!(
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SHOW    START\n",
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
