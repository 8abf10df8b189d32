//! T1004.

use crate::diagnostics::{Rule, Severity};

/// T1004 macro-recursion.
pub static MACRO_RECURSION: Rule = Rule {
    code: "T1004",
    name: "macro-recursion",
    severity: Severity::Error,
    fixed: true,
    explanation: "The macro calls itself, directly or through other macros, so its expansion would never end (manual \
        22.2). Nesting is fine as long as there is no circle. The body of a macro that overloads an instruction may \
        use the instruction of that name.",
    why: "A call is replaced by the lines of the body; without an end to that there is no program.",
    wrong: concat!(
        "DEF_T_MACRO BLINK LIGHT\n",
        "        BLINK   TMAC.LIGHT\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO BLINK LIGHT\n",
        "        LDR     -TMAC.LIGHT\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        BLINK   MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.2",
    ..Rule::BASE
};
