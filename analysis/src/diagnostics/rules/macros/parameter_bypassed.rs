//! T1022.

use crate::diagnostics::{Rule, Severity};

/// T1022 parameter-bypassed.
pub static PARAMETER_BYPASSED: Rule = Rule {
    code: "T1022",
    name: "parameter-bypassed",
    severity: Severity::Warning,
    fixed: false,
    explanation: "A TECHNOL instruction of the body uses a name without TMAC. that is a parameter of the macro and a \
        symbol of the project as well. Without the prefix it means the symbol (manual 22.3). Write TMAC. when the \
        parameter is meant, otherwise rename the parameter.",
    why: "Every call silently works on the same symbol, whatever operand it hands over.",
    wrong: concat!(
        "DEF_T_MACRO SHOW DOOR, LIGHT\n",
        "        LDR     DOOR\n",
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
    fix: true,
    ..Rule::BASE
};
