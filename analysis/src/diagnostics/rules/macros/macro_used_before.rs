//! T1003.

use crate::diagnostics::{Rule, Severity};

/// T1003 macro-used-before.
pub static MACRO_USED_BEFORE: Rule = Rule {
    code: "T1003",
    name: "macro-used-before",
    severity: Severity::Error,
    fixed: true,
    explanation: "The macro is defined further down in the text than it is called: in a later line, in a program \
        file that comes later, or in a definition file that is included later (manual 22.1, 22.2). Move the \
        definition up; usually definitions stand before DATA, or in a file that T_INCLUDE joins there.",
    why: "Definitions act from their place on; before it the word means nothing.",
    wrong: concat!(
        "MODULE_MAIN\n",
        "        SHOW    START, MOTOR\n",
        "DEF_T_MACRO SHOW KEY, LIGHT\n",
        "        LDR     TMAC.KEY\n",
        "        WR      TMAC.LIGHT\n",
        "END_T_MACRO T_END\n",
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
