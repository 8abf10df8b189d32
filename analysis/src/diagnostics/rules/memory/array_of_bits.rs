//! T0320 array-of-bits.

use crate::diagnostics::{Rule, Severity};

/// T0320 array-of-bits.
pub static ARRAY_OF_BITS: Rule = Rule {
    code: "T0320",
    name: "array-of-bits",
    severity: Severity::Error,
    fixed: true,
    explanation: "DEF_IN or DEF_OUT declares an array of TYPE_BIT. No instruction could name one bit of it. Declare \
        single bits, or an array of TYPE_BYTE (this implementation).",
    why: "Bits are named by themselves or as a position behind a cell; neither form has an index.",
    wrong: "MODULE_INIT\n        DEF_IN  DOORS[4],'Doors',TYPE_BIT\nMODULE_INIT_END\n",
    right: "MODULE_INIT\n        DEF_IN  DOORS[4],'Doors',TYPE_BYTE\nMODULE_INIT_END\n",
    chapter: "27.6",
    ..Rule::BASE
};
