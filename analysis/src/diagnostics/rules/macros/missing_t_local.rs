//! T1016.

use crate::diagnostics::{Rule, Severity};

/// T1016 missing-t-local.
pub static MISSING_T_LOCAL: Rule = Rule {
    code: "T1016",
    name: "missing-t-local",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The body defines a label, cell or bit that is not in T_LOCAL, so each call defines it again and \
        the second one is an error (manual 22.3). Add the name to a T_LOCAL line directly behind DEF_T_MACRO.",
    why: "Such a macro can be called once in the whole project, which nobody expects of it.",
    wrong: concat!(
        "DEF_T_MACRO SKIP KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        JL0     NEXT\n",
        "        FL      0,TMAC.LIGHT\n",
        "NEXT:\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SKIP    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO SKIP KEY, LIGHT\n",
        "        T_LOCAL NEXT\n",
        "        LDR     TMAC.KEY\n",
        "        JL0     NEXT\n",
        "        FL      0,TMAC.LIGHT\n",
        "NEXT:\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        SKIP    START, MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.3",
    ..Rule::BASE
};
