//! T0201 duplicate-name.

use crate::diagnostics::{Rule, Severity};

/// T0201 duplicate-name.
pub static DUPLICATE_NAME: Rule = Rule {
    code: "T0201",
    name: "duplicate-name",
    severity: Severity::Error,
    fixed: true,
    explanation: "A name is declared twice where both can be seen: twice in DATA of any files, twice in the \
        DATA_LOCAL of one file, or both in DATA and in DATA_LOCAL of a file. A mechanism declares a bit of \
        its name, so a cell and a mechanism cannot share one (manual 3.3, 4.2). Only the first 31 \
        characters count. Rename one of them.",
    why: "Two cells of one name would be two memories, and no instruction could tell which is meant.",
    wrong: "\
DATA
LEVEL: DS 1
LEVEL: DS 2
DATA_END
",
    right: "\
DATA
LEVEL: DS 1
LEVEL_MAX: DS 2
DATA_END
",
    chapter: "3.3",
    ..Rule::BASE
};
