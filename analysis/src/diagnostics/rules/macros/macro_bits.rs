//! T1010.

use crate::diagnostics::{Rule, Severity};

/// T1010 macro-bits.
pub static MACRO_BITS: Rule = Rule {
    code: "T1010",
    name: "macro-bits",
    severity: Severity::Error,
    fixed: true,
    explanation: "DFM in a macro must name all eight bits; the short list and empty places that are allowed \
        elsewhere are not (manual 22.3). Name the spare bits too, and put every name into T_LOCAL.",
    why: "The original compiler decodes a body once, before it knows the calls, and needs the full list for that.",
    wrong: concat!(
        "DEF_T_MACRO EDGE KEY\n",
        "        T_LOCAL B0\n",
        "        DATA_LOCAL\n",
        "        DFM     B0\n",
        "        DATA_LOCAL_END\n",
        "        LDR     TMAC.KEY\n",
        "        WR      B0\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO EDGE KEY\n",
        "        T_LOCAL B0,B1,B2,B3,B4,B5,B6,B7\n",
        "        DATA_LOCAL\n",
        "        DFM     B0,B1,B2,B3,B4,B5,B6,B7\n",
        "        DATA_LOCAL_END\n",
        "        LDR     TMAC.KEY\n",
        "        WR      B0\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        EDGE    START\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.3",
    ..Rule::BASE
};
