//! T0416 stale-dividend.

use crate::diagnostics::{Rule, Severity};

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
    why: "DIVB by a DWORD or a constant divides all 64 bits. Instructions of 8, 16 or 32 bits leave the \
        upper ones as they were, so a negative result is divided as if it were a huge positive \
        number.",
    wrong: "\
LOD LARGE
SU CNST.100
DIVB CNST.10
STO LARGE
",
    right: "\
LOD LARGE
SU CNST.100
STO LARGE
LOD LARGE
DIVB CNST.10
STO LARGE
",
    chapter: "3.14",
    ..Rule::BASE
};
