//! T0420 bad-identifier.

use crate::diagnostics::{Rule, Severity};

/// T0420 bad-identifier.
pub static BAD_IDENTIFIER: Rule = Rule {
    code: "T0420",
    name: "bad-identifier",
    severity: Severity::Error,
    fixed: false,
    explanation: "The identifier of an element of the configuration is empty, or one of DEF_IN and DEF_OUT ends in an \
        index. Write the identifier without `PLC.Input.` or `PLC.Output.` and without the last index: the array is \
        declared by `name[n]`, and a connection names its elements.",
    why: "The control compares the whole identifier with its configuration, so such a one is never found and the cell \
        keeps its default value.",
    wrong: "MODULE_INIT\n        DEF_IN  SPEEDS[3],'Speed[3]',TYPE_WORD\nMODULE_INIT_END\n",
    right: "MODULE_INIT\n        DEF_IN  SPEEDS[3],'Speed',TYPE_WORD\nMODULE_INIT_END\n",
    chapter: "27.6",
    ..Rule::BASE
};
