//! T0932 unknown-column.

use crate::diagnostics::{Rule, Severity};

/// T0932 unknown-column.
pub static UNKNOWN_COLUMN: Rule = Rule {
    code: "T0932",
    name: "unknown-column",
    severity: Severity::Warning,
    explanation: "A value or an instruction names a column that the definition of the table does not have, or a column \
        number above its last one. Names count in upper and lower case, numbers begin at 0.",
    why: "PLCT_COL_INDEX ends with an error, and a value without column is lost.",
    wrong: concat!(
        ";=== tools.PlcTDef\n",
        "<PLCTableDef>\n",
        "  <Definition>\n",
        "    <DefinitionID>Tools</DefinitionID>\n",
        "    <ColsCount>1</ColsCount>\n",
        "    <Col No=\"0\"><ColID>Length</ColID><ColType>REAL</ColType></Col>\n",
        "  </Definition>\n",
        "</PLCTableDef>\n",
        ";=== tools.PlcT\n",
        "<PLCTable>\n",
        "  <Definition><DefinitionID>Tools</DefinitionID><LinesCount>1</LinesCount></Definition>\n",
        "  <Line No=\"0\"><Col ColID=\"Lenght\">12.5</Col></Line>\n",
        "</PLCTable>\n",
    ),
    right: concat!(
        ";=== tools.PlcTDef\n",
        "<PLCTableDef>\n",
        "  <Definition>\n",
        "    <DefinitionID>Tools</DefinitionID>\n",
        "    <ColsCount>1</ColsCount>\n",
        "    <Col No=\"0\"><ColID>Length</ColID><ColType>REAL</ColType></Col>\n",
        "  </Definition>\n",
        "</PLCTableDef>\n",
        ";=== tools.PlcT\n",
        "<PLCTable>\n",
        "  <Definition><DefinitionID>Tools</DefinitionID><LinesCount>1</LinesCount></Definition>\n",
        "  <Line No=\"0\"><Col ColID=\"Length\">12.5</Col></Line>\n",
        "</PLCTable>\n",
    ),
    chapter: "17.2",
    fix: true,
    ..Rule::BASE
};
