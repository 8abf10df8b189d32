//! T0322 member-form.

use crate::diagnostics::{Rule, Severity};

/// T0322 member-form.
pub static MEMBER_FORM: Rule = Rule {
    code: "T0322",
    name: "member-form",
    severity: Severity::Error,
    fixed: true,
    explanation: "A member of a structure is `MEMBER DB ?`, with DB, DW, DD or DQ for 1, 2, 4 or 8 bytes, and `n DUP \
        (?)` for n elements. Such lines stand only between STRUC and ENDS; memory is declared by DFM, DS and STR.",
    why: "DB declares no memory in TECHNOL, so a cell declared by it would not exist.",
    wrong: "DATA\nSPEED   DW ?\nDATA_END\n",
    right: "DATA\nSPEED:  DS 2\nDATA_END\n",
    chapter: "18.1",
    ..Rule::BASE
};
