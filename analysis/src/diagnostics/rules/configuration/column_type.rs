//! T0934 column-type.

use crate::diagnostics::{Rule, Severity};

/// T0934 column-type.
pub static COLUMN_TYPE: Rule = Rule {
    code: "T0934",
    name: "column-type",
    severity: Severity::Error,
    explanation: "An instruction for one type of value works on a column of another: PLCT_GET_INT on a `REAL` column. \
        Use the instruction for the type of the column. The column is known when it is a number, or when the \
        cell was filled by a PLCT_COL_INDEX just before.",
    why: "The instruction ends with an error, or the cell gets bytes of another meaning.",
    wrong: concat!(
        "MODULE_MAIN\n",
        "MECH_BEGIN READ_TOOL\n",
        "        PLCT_GET_INT 0,0,0,LARGE\n",
        "        EX0\n",
        "        EQ   CNST.0\n",
        "        JL1  DONE\n",
        "DONE:\n",
        "MECH_END READ_TOOL\n",
        "MODULE_MAIN_END\n",
        ";=== tools.PlcTDef\n",
        "<PLCTableDef>\n",
        "  <Definition>\n",
        "    <DefinitionID>Tools</DefinitionID>\n",
        "    <ColsCount>1</ColsCount>\n",
        "    <Col No=\"0\"><ColID>Length</ColID><ColType>REAL</ColType></Col>\n",
        "  </Definition>\n",
        "</PLCTableDef>\n",
    ),
    right: concat!(
        "MODULE_MAIN\n",
        "MECH_BEGIN READ_TOOL\n",
        "        PLCT_GET_REAL 0,0,0,RATIO\n",
        "        EX0\n",
        "        EQ   CNST.0\n",
        "        JL1  DONE\n",
        "DONE:\n",
        "MECH_END READ_TOOL\n",
        "MODULE_MAIN_END\n",
        ";=== tools.PlcTDef\n",
        "<PLCTableDef>\n",
        "  <Definition>\n",
        "    <DefinitionID>Tools</DefinitionID>\n",
        "    <ColsCount>1</ColsCount>\n",
        "    <Col No=\"0\"><ColID>Length</ColID><ColType>REAL</ColType></Col>\n",
        "  </Definition>\n",
        "</PLCTableDef>\n",
    ),
    chapter: "17.4",
    ..Rule::BASE
};
