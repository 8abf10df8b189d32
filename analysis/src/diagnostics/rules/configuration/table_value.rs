//! T0933 table-value.

use crate::diagnostics::{Rule, Severity};

/// T0933 table-value.
pub static TABLE_VALUE: Rule = Rule {
    code: "T0933",
    name: "table-value",
    severity: Severity::Error,
    explanation: "A value of a PLC table does not fit the type of its column: `INT` takes whole numbers of 32 bits, \
        `REAL` numbers with a decimal point.",
    why: "The control cannot convert it.",
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
        "  <Line No=\"0\"><Col ColID=\"Length\">12,5</Col></Line>\n",
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
    ..Rule::BASE
};
