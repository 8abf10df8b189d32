//! T1015.

use crate::diagnostics::{Rule, Severity};

/// T1015 macro-brackets.
pub static MACRO_BRACKETS: Rule = Rule {
    code: "T1015",
    name: "macro-brackets",
    severity: Severity::Warning,
    fixed: false,
    explanation: "An operand with brackets, for instance `(TABLE+3).BIT`, can be handed to a macro only when its \
        flags say C_1 (manual 22.4). Add C_1 to END_T_MACRO, behind the flag of the stack. This implementation hands \
        brackets on in either case.",
    why: "The original compiler hands the operand to a macro assembler, which takes brackets for its own.",
    wrong: concat!(
        "DEF_T_MACRO TAKE CELL\n",
        "        LDR     TMAC.CELL.START\n",
        "        WR      MOTOR\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        TAKE    (TABLE+3)\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO TAKE CELL\n",
        "        LDR     TMAC.CELL.START\n",
        "        WR      MOTOR\n",
        "END_T_MACRO T_END, C_1\n",
        "MODULE_MAIN\n",
        "        TAKE    (TABLE+3)\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.4",
    ..Rule::BASE
};
