//! T1014.

use crate::diagnostics::{Rule, Severity};

/// T1014 macro-flag-mismatch.
pub static MACRO_FLAG_MISMATCH: Rule = Rule {
    code: "T1014",
    name: "macro-flag-mismatch",
    severity: Severity::Warning,
    fixed: false,
    explanation: "What the flags of a macro say about the stack of logic instructions is not what its body does \
        (manual 22.4). Behind a call the compiler goes by the flags: T_PUSH when the body leaves an equation open, \
        T_POP when it takes a value back, T_END when it ends with a terminal instruction, T_NORMAL when it does \
        nothing of that.",
    why: "The next LDR would push or not push by the flags, while the stack holds what the body left on it.",
    wrong: concat!(
        "DEF_T_MACRO BOTH ONE, TWO\n",
        "        LDR     TMAC.ONE\n",
        "        LA      TMAC.TWO\n",
        "END_T_MACRO\n",
        "MODULE_MAIN\n",
        "        BOTH    START, DOOR\n",
        "        WR      MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO BOTH ONE, TWO\n",
        "        LDR     TMAC.ONE\n",
        "        LA      TMAC.TWO\n",
        "END_T_MACRO T_PUSH\n",
        "MODULE_MAIN\n",
        "        BOTH    START, DOOR\n",
        "        WR      MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
