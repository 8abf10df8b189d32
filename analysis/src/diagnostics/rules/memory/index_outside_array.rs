//! T0421 index-outside-array.

use crate::diagnostics::{Rule, Severity};

/// T0421 index-outside-array.
pub static INDEX_OUTSIDE_ARRAY: Rule = Rule {
    code: "T0421",
    name: "index-outside-array",
    severity: Severity::Error,
    fixed: false,
    explanation: "`name[n]` is the element n of an array, counted from 0, and the array has no such element. For a \
        distance in bytes write `name+n`.",
    why: "The access would reach another cell behind the array.",
    wrong: "MODULE_INIT\n        DEF_OUT SPEEDS[3],'Speed',TYPE_WORD\nMODULE_INIT_END\nMODULE_CLEAR\n        \
            LOD  CNST.0\n        STO  SPEEDS[3]\nMODULE_CLEAR_END\n",
    right: "MODULE_INIT\n        DEF_OUT SPEEDS[3],'Speed',TYPE_WORD\nMODULE_INIT_END\nMODULE_CLEAR\n        \
            LOD  CNST.0\n        STO  SPEEDS[2]\nMODULE_CLEAR_END\n",
    chapter: "27.6",
    ..Rule::BASE
};
