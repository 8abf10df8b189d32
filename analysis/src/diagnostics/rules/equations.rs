//! Logic equations and their stack.

use crate::diagnostics::{Rule, Severity};

/// T0501 pop-without-push.
pub static POP_WITHOUT_PUSH: Rule = Rule {
    code: "T0501",
    name: "pop-without-push",
    severity: Severity::Error,
    fixed: true,
    explanation: "LA, LO or LX without operand combines RLO with the value that a second LDR pushed, but nothing is \
        on the stack (manual 3.6). Give it an operand, or begin the part with LDR.",
    ..Rule::BASE
};

/// T0502 value-left-on-stack.
pub static VALUE_LEFT_ON_STACK: Rule = Rule {
    code: "T0502",
    name: "value-left-on-stack",
    severity: Severity::Error,
    fixed: true,
    explanation: "An LDR inside an open equation pushes the old RLO, and nothing takes it back before the end of the \
        module, mechanism or procedure, or before CHECK (manual 3.6). Either LA, LO or LX without operand \
        is missing, or the equation before the LDR was not closed by a terminal instruction (WR, FL1, JL0, \
        JL1, STO1, EX0 …).",
    ..Rule::BASE
};

/// T0503 stack-too-deep.
pub static STACK_TOO_DEEP: Rule = Rule {
    code: "T0503",
    name: "stack-too-deep",
    severity: Severity::Error,
    fixed: true,
    explanation: "The equation stack has 8 cells (manual 3.2). Store a partial result in a bit.",
    ..Rule::BASE
};

/// T0504 lost-equation.
pub static LOST_EQUATION: Rule = Rule {
    code: "T0504",
    name: "lost-equation",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The instruction overwrites RLO while an equation is open and does not use its result, so the \
        equation has no effect. Close it with a terminal instruction first, or remove it.",
    ..Rule::BASE
};

/// T0505 open-equation.
pub static OPEN_EQUATION: Rule = Rule {
    code: "T0505",
    name: "open-equation",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The section ends while an equation is open: its result goes nowhere. Close it with a terminal \
        instruction such as WR or FL1 (manual 3.6).",
    ..Rule::BASE
};
