//! T0426 jump-with-open-equation.

use crate::diagnostics::{Rule, Severity};

/// T0426 jump-with-open-equation.
pub static JUMP_WITH_OPEN_EQUATION: Rule = Rule {
    code: "T0426",
    name: "jump-with-open-equation",
    severity: Severity::Warning,
    explanation: "JUM or PROC_CALL stands while an equation is open. Neither closes it, so the next LDR pushes its value, \
        wherever the jump leads. Close the equation before, for instance by WR, JL0 or JL1.",
    why: "Which LDR pushes is decided from top to bottom in the text, not along the jump, so the stack and the program \
        no longer agree.",
    wrong: "        LDR  START\n        JUM  NEXT\nNEXT:   WR   MOTOR\n",
    right: "        LDR  START\n        WR   MOTOR\n        JUM  NEXT\nNEXT:   LDR  DOOR\n        WR   M0\n",
    chapter: "3.6",
    ..Rule::BASE
};
