//! Operands that do not fit their instruction.

use crate::diagnostics::{Rule, Severity};

/// T0401 operand-count.
pub static OPERAND_COUNT: Rule = Rule {
    code: "T0401",
    name: "operand-count",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction has too few or too many operands. The message shows how it is written.",
    ..Rule::BASE
};

/// T0402 operand-kind.
pub static OPERAND_KIND: Rule = Rule {
    code: "T0402",
    name: "operand-kind",
    severity: Severity::Error,
    fixed: true,
    explanation: "The operand has a form this instruction does not take. The message says what it needs.",
    ..Rule::BASE
};

/// T0403 untyped-area.
pub static UNTYPED_AREA: Rule = Rule {
    code: "T0403",
    name: "untyped-area",
    severity: Severity::Error,
    fixed: true,
    explanation: "The area has no type (its DS is not 1, 2 or 4), so the width of the access is unknown. Put \
        `BYTE.`, `WORD.`, `DWRD.`, `QWRD.` or `REAL.` before it (manual 3.9).",
    ..Rule::BASE
};

/// T0404 prefix-not-allowed.
pub static PREFIX_NOT_ALLOWED: Rule = Rule {
    code: "T0404",
    name: "prefix-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction does not take this type prefix or declared type (manual 3.9 lists them).",
    ..Rule::BASE
};

/// T0405 sign-not-allowed.
pub static SIGN_NOT_ALLOWED: Rule = Rule {
    code: "T0405",
    name: "sign-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "A `-` that negates is allowed only where the operand is read by LDR, LA, LO, LX and LOD (manual \
        3.5, 3.10) and before constants.",
    ..Rule::BASE
};

/// T0406 constant-too-large.
pub static CONSTANT_TOO_LARGE: Rule = Rule {
    code: "T0406",
    name: "constant-too-large",
    severity: Severity::Error,
    fixed: true,
    explanation: "The constant does not fit the width of the operation: BYTE -128..255, WORD -32768..65535, DWORD \
        and constants -2147483648..4294967295.",
    ..Rule::BASE
};

/// T0407 number-out-of-range.
pub static NUMBER_OUT_OF_RANGE: Rule = Rule {
    code: "T0407",
    name: "number-out-of-range",
    severity: Severity::Error,
    fixed: true,
    explanation: "The number is outside what the operand allows; the message gives the bounds.",
    ..Rule::BASE
};

/// T0408 division-by-zero.
pub static DIVISION_BY_ZERO: Rule = Rule {
    code: "T0408",
    name: "division-by-zero",
    severity: Severity::Error,
    fixed: true,
    explanation: "DIVB by a constant zero would stop the PLC with a fault each time (manual 3.12).",
    ..Rule::BASE
};

/// T0409 real-not-allowed.
pub static REAL_NOT_ALLOWED: Rule = Rule {
    code: "T0409",
    name: "real-not-allowed",
    severity: Severity::Error,
    fixed: true,
    explanation: "A real number or `REAL.` is used with an instruction that computes with integers only (manual 3.16 \
        lists the real ones). A real constant is written `CNST.1.5` and takes no other prefix.",
    ..Rule::BASE
};

/// T0410 access-past-cell.
pub static ACCESS_PAST_CELL: Rule = Rule {
    code: "T0410",
    name: "access-past-cell",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The access begins inside a symbol and reaches past its declared memory into what follows it, for instance \
        `WORD.` on a BYTE cell: the prefix wins (manual 3.9). Declare a larger cell or use another prefix. An access \
        that begins at a neighbour, written `name+n`, is taken as meant.",
    ..Rule::BASE
};

/// T0411 access-outside-data.
pub static ACCESS_OUTSIDE_DATA: Rule = Rule {
    code: "T0411",
    name: "access-outside-data",
    severity: Severity::Error,
    fixed: true,
    explanation: "The access leaves the data area of the program altogether. Correct the offset.",
    ..Rule::BASE
};

/// T0412 different-types.
pub static DIFFERENT_TYPES: Rule = Rule {
    code: "T0412",
    name: "different-types",
    severity: Severity::Error,
    fixed: true,
    explanation: "MOVE and MOVE1 copy between operands of one type (manual 3.10). Use LOD and STO to convert, or the \
        same prefix on both sides.",
    ..Rule::BASE
};

/// T0413 prefix-covers-time.
pub static PREFIX_COVERS_TIME: Rule = Rule {
    code: "T0413",
    name: "prefix-covers-time",
    severity: Severity::Error,
    fixed: true,
    explanation: "A type prefix on the counter of TEX0, TEX1 or TIM also covers the time, which then cannot be a \
        constant (manual 4.2). Remove the prefix or put the time into a cell.",
    ..Rule::BASE
};

/// T0414 constant-destination.
pub static CONSTANT_DESTINATION: Rule = Rule {
    code: "T0414",
    name: "constant-destination",
    severity: Severity::Error,
    fixed: true,
    explanation: "The instruction writes to this operand, and a constant cannot be written to. Name a cell.",
    ..Rule::BASE
};

/// T0415 never-equal.
pub static NEVER_EQUAL: Rule = Rule {
    code: "T0415",
    name: "never-equal",
    severity: Severity::Warning,
    fixed: false,
    explanation: "LOD extends the sign of what it loads (manual 3.10): a BYTE cell that holds 0FFh loads as -1, so a \
        comparison with a 32-bit constant of 128 to 255 is never true; the same holds for a WORD cell and 32768 to \
        65535. Compare at the width of the cell (`EQ BYTE.0FFh`) or mask DR first (`ANDB CNST.0FFh`).",
    ..Rule::BASE
};

/// T0416 stale-dividend.
pub static STALE_DIVIDEND: Rule = Rule {
    code: "T0416",
    name: "stale-dividend",
    severity: Severity::Hint,
    fixed: false,
    explanation: "DIVB by a DWORD or a constant divides all 64 bits of DR, but AD, SU, INR, DCR and INV change only as \
        many bits as their operand has and leave the upper ones (manual 3.12). After LOD of a positive value and a \
        small sum that makes no difference; when the result changes its sign or grows past its width, the quotient is \
        wrong. STO the value and LOD it again, or divide by a WORD or BYTE.",
    ..Rule::BASE
};
