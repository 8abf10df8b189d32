//! T0909 table-count.

use crate::diagnostics::{Rule, Severity};

/// T0909 table-count.
pub static TABLE_COUNT: Rule = Rule {
    code: "T0909",
    name: "table-count",
    severity: Severity::Warning,
    explanation: "`ColsCount` or `LinesCount` of a PLC table does not agree with the columns or rows that stand in the \
        file, or the numbers of its columns have a gap. Write the number that is there.",
    why: "The control reads as many as are stated.",
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
        "  <Definition><DefinitionID>Tools</DefinitionID><LinesCount>2</LinesCount></Definition>\n",
        "  <Line No=\"0\"><Col ColID=\"Length\">12.5</Col></Line>\n",
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
    chapter: "17.1",
    fix: true,
    ..Rule::BASE
};
