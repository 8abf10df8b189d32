//! T0423 block-access.

use crate::diagnostics::{Rule, Severity};

/// T0423 block-access.
pub static BLOCK_ACCESS: Rule = Rule {
    code: "T0423",
    name: "block-access",
    severity: Severity::Error,
    fixed: true,
    explanation: "`BLK[n].` gives access to the blocks prepared for execution. They are read only: bits by LDR, LA, LO \
        and LX, cells by LOD, AD, SU, ORB, ANDB, XORB, MULB, DIVB and the comparisons. Load the member by LOD and \
        store it in a cell of the program for anything else.",
    why: "The control owns the blocks and goes on preparing them while the program runs.",
    wrong: "        LOD  CNST.5\n        STO  BLK[0].T\n",
    right: "        LOD  BLK[0].T\n        STO  LARGE\n",
    chapter: "8.3",
    ..Rule::BASE
};
