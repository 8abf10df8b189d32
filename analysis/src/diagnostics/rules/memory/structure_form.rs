//! T0321 structure-form.

use crate::diagnostics::{Rule, Severity};

/// T0321 structure-form.
pub static STRUCTURE_FORM: Rule = Rule {
    code: "T0321",
    name: "structure-form",
    severity: Severity::Error,
    fixed: true,
    explanation: "A structure begins with `NAME STRUC` and ends with `NAME ENDS`, both with the same name and without a \
        colon. It holds members only, no other structure.",
    why: "Without its end the lines that follow would count as members.",
    wrong: "DATA\nRECORD  STRUC\nR_KIND  DB ?\nR_SPEED DW ?\nDATA_END\n",
    right: "DATA\nRECORD  STRUC\nR_KIND  DB ?\nR_SPEED DW ?\nRECORD  ENDS\nDATA_END\n",
    chapter: "18.1",
    ..Rule::BASE
};
