//! T0931 unknown-table.

use crate::diagnostics::{Rule, Severity};

/// T0931 unknown-table.
pub static UNKNOWN_TABLE: Rule = Rule {
    code: "T0931",
    name: "unknown-table",
    severity: Severity::Warning,
    explanation: "A `*.PlcT` file names a table that no `*.PlcTDef` of the project defines; or an instruction uses a \
        table index above the number of definitions. Indexes follow the order of the definitions under \
        `configuration` in technol.toml, without it the order of their file names (this implementation).",
    why: "Values without columns cannot be read, and PLCT_ instructions end with an error.",
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
        "  <Definition><DefinitionID>Tolls</DefinitionID><LinesCount>1</LinesCount></Definition>\n",
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
    chapter: "17.2",
    fix: true,
    ..Rule::BASE
};
