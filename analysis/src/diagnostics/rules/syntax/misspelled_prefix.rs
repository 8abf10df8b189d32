//! T0112 misspelled-prefix.

use crate::diagnostics::{Rule, Severity};

/// T0112 misspelled-prefix.
pub static MISSPELLED_PREFIX: Rule = Rule {
    code: "T0112",
    name: "misspelled-prefix",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`CNTS.` is a common misspelling of `CNST.`. It is read as `CNST.`; the fix corrects it.",
    why: "Other tools do not know this spelling.",
    wrong: "\
LOD CNTS.5
STO SMALL
",
    right: "\
LOD CNST.5
STO SMALL
",
    chapter: "3.9",
    fix: true,
    ..Rule::BASE
};
