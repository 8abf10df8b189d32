//! T1009.

use crate::diagnostics::{Rule, Severity};

/// T1009 macro-data.
pub static MACRO_DATA: Rule = Rule {
    code: "T1009",
    name: "macro-data",
    severity: Severity::Error,
    fixed: true,
    explanation: "Data and bits of a macro are local: they stand in DATA_LOCAL … DATA_LOCAL_END in its body, \
        declared with DS or DFM (manual 22.3). DATA cannot stand in a macro.",
    why: "Global data are declared once for the whole project, an expansion as often as the macro is called.",
    wrong: concat!(
        "DEF_T_MACRO COUNTER KEY\n",
        "        T_LOCAL PASSES\n",
        "        DATA\n",
        "PASSES: DS      1\n",
        "        DATA_END\n",
        "        LOD     PASSES\n",
        "        INR\n",
        "        LDR     TMAC.KEY\n",
        "        STO1    PASSES\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        FL      0,MOTOR\n",
        "MODULE_MAIN_END\n",
    ),
    right: concat!(
        "DEF_T_MACRO COUNTER KEY\n",
        "        T_LOCAL PASSES\n",
        "        DATA_LOCAL\n",
        "PASSES: DS      1\n",
        "        DATA_LOCAL_END\n",
        "        LOD     PASSES\n",
        "        INR\n",
        "        LDR     TMAC.KEY\n",
        "        STO1    PASSES\n",
        "END_T_MACRO T_END\n",
        "MODULE_MAIN\n",
        "        COUNTER START\n",
        "MODULE_MAIN_END\n",
    ),
    chapter: "22.3",
    fix: true,
    ..Rule::BASE
};
