//! Mechanisms, procedures, jumps in time.

use crate::diagnostics::{Rule, Severity};

/// T0701 wait-outside-sequence.
pub static WAIT_OUTSIDE_SEQUENCE: Rule = Rule {
    code: "T0701",
    name: "wait-outside-sequence",
    severity: Severity::Error,
    fixed: true,
    explanation: "EX, EX0, EX1, BEX, TEX0, TEX1 and TIM hold a sequence; they may stand only in a mechanism or \
        directly in MODULE_BLOCK_INIT and MODULE_BLOCK_DONE, not in a procedure (manual 4.3).",
    ..Rule::BASE
};

/// T0702 endless-loop.
pub static ENDLESS_LOOP: Rule = Rule {
    code: "T0702",
    name: "endless-loop",
    severity: Severity::Error,
    fixed: true,
    explanation: "The loop has no way out and no EX, EX0, EX1, TEX0, TEX1 or TIM in which it would wait, so the \
        cycle never ends and the watchdog stops the PLC (manual 4.3). BEX does not wait. Put an EX-type \
        instruction into the loop.",
    ..Rule::BASE
};

/// T0703 busy-loop.
pub static BUSY_LOOP: Rule = Rule {
    code: "T0703",
    name: "busy-loop",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The loop waits for a condition without an EX-type instruction: while it turns, nothing else in the \
        PLC runs, so the condition usually cannot change. Use EX0 or EX1 to wait (manual 4.3).",
    ..Rule::BASE
};

/// T0704 recursion.
pub static RECURSION: Rule = Rule {
    code: "T0704",
    name: "recursion",
    severity: Severity::Error,
    fixed: true,
    explanation: "A procedure calls itself, directly or through others. Procedures have no stack of their own, so a \
        call inside itself never returns properly.",
    ..Rule::BASE
};

/// T0705 raster-end.
pub static RASTER_END: Rule = Rule {
    code: "T0705",
    name: "raster-end",
    severity: Severity::Error,
    fixed: true,
    explanation: "The end label of a DFTM block stands after it in the same module, mechanism or procedure (manual \
        3.11).",
    ..Rule::BASE
};

/// T0706 nested-raster.
pub static NESTED_RASTER: Rule = Rule {
    code: "T0706",
    name: "nested-raster",
    severity: Severity::Error,
    fixed: true,
    explanation: "DFTM blocks do not stand inside each other: the inner one would be reached only now and then. End \
        the first block before the second begins.",
    ..Rule::BASE
};

/// T0707 timer-outside-raster.
pub static TIMER_OUTSIDE_RASTER: Rule = Rule {
    code: "T0707",
    name: "timer-outside-raster",
    severity: Severity::Warning,
    fixed: false,
    explanation: "TM counts passes of the DFTM block around it (manual 3.11). Without such a block it counts passes of \
        its module, 20 ms or 1 ms each, which is seldom meant. Put it into a DFTM01, DFTM1, DFTM10 or DFTM100 block.",
    ..Rule::BASE
};
