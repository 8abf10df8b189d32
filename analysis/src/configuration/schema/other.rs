//! `*.PlcErrors` (manual 14.4), `*.PlcConstants` (16.2), `*.PlcTDef` and `*.PlcT` (17.1, 17.2).

use super::{COUNT, ElementSpec, ValueKind, closed, needed};

/// Kinds of a message.
pub(crate) const MESSAGE_TYPES: &[&str] = &["ErrCritical", "Err", "Wrn1", "Wrn2", "Wrn3", "Info", "Event"];

/// `*.PlcErrors`. The manual does not name the root.
pub(super) const ERRORS: &[ElementSpec] = &[
    ElementSpec {
        attributes: &[
            needed(
                "No",
                ValueKind::Integer(0, 0xFFFF),
                "Number of the message, as ESET names it",
                "Číslo hlášení, které uvádí ESET",
            ),
            needed("Type", ValueKind::Words(MESSAGE_TYPES), "Kind of the message", "Typ hlášení"),
            needed(
                "Validity",
                ValueKind::Words(&["Transient", "Persistent"]),
                "`Transient`: acknowledged by the operator; `Persistent`: stays until the program removes it",
                "`Transient`: potvrdí ho obsluha; `Persistent`: platí, dokud ho program nesmaže",
            ),
        ],
        ..closed("PlcError", "14.4", "One message of the PLC program", "Jedno hlášení PLC programu")
    },
    ElementSpec {
        parents: &["PlcError"],
        content: Some(ValueKind::Text),
        ..closed(
            "Text",
            "14.4",
            "Text of the message; `%d` and `%X` show par1 to par3 in order, decimal and hexadecimal",
            "Text hlášení; `%d` a `%X` zobrazí par1 až par3 v pořadí, dekadicky a hexadecimálně",
        )
    },
];

/// Words for automatic numbers.
pub(crate) const AUTOMATIC: &[&str] = &["SA0INT", "SA0REAL", "PLCCOMMAND"];

/// `*.PlcConstants`.
pub(super) const CONSTANTS: &[ElementSpec] = &[
    closed("PlcConstants", "16.2", "Constants of the PLC", "Konstanty pro PLC"),
    ElementSpec {
        parents: &["PlcConstants"],
        attributes: &[
            needed(
                "ID",
                ValueKind::Text,
                "Identifier, as CONST_GET names it",
                "Identifikátor, který uvádí CONST_GET",
            ),
            needed(
                "Value",
                ValueKind::IntegerOr(AUTOMATIC),
                "Number, or its automatic numbering: `SA0INT`, `SA0REAL` offset in the shared memory, `PLCCOMMAND` command",
                "Číslo, nebo automatické číslování: `SA0INT`, `SA0REAL` offset ve sdílené paměti, `PLCCOMMAND` příkaz",
            ),
        ],
        ..closed("Constant", "16.2", "One constant", "Jedna konstanta")
    },
];

/// Kinds of a column.
pub(crate) const COLUMN_TYPES: &[&str] = &["REAL", "INT", "STRING", "BINARY"];

/// `*.PlcTDef`.
pub(super) const TABLE_DEFINITION: &[ElementSpec] = &[
    closed("PLCTableDef", "17.1", "Structure of a PLC table", "Struktura PLC tabulky"),
    ElementSpec {
        parents: &["PLCTableDef"],
        ..closed("Definition", "17.1", "Structure of a PLC table", "Struktura PLC tabulky")
    },
    ElementSpec {
        parents: &["Definition"],
        content: Some(ValueKind::Text),
        ..closed("DefinitionID", "17.1", "Name of the table", "Název tabulky")
    },
    ElementSpec {
        parents: &["Definition"],
        content: Some(ValueKind::Integer(1, i64::MAX)),
        ..closed("ColsCount", "17.1", "Number of columns", "Počet sloupců")
    },
    ElementSpec {
        parents: &["Definition"],
        attributes: &[needed("No", COUNT, "Number of the column, from 0", "Pořadové číslo sloupce, od 0")],
        ..closed("Col", "17.1", "A column", "Sloupec")
    },
    ElementSpec {
        parents: &["Col"],
        content: Some(ValueKind::Text),
        ..closed("ColID", "17.1", "Name of the column", "Název sloupce")
    },
    ElementSpec {
        parents: &["Col"],
        content: Some(ValueKind::Words(COLUMN_TYPES)),
        ..closed("ColType", "17.1", "Type of its values", "Typ hodnot")
    },
];

/// `*.PlcT`.
pub(super) const TABLE: &[ElementSpec] = &[
    closed("PLCTable", "17.2", "Values of a PLC table", "Hodnoty PLC tabulky"),
    ElementSpec {
        parents: &["PLCTable"],
        ..closed("Definition", "17.2", "Which table it is", "Která tabulka to je")
    },
    ElementSpec {
        parents: &["Definition"],
        content: Some(ValueKind::Text),
        ..closed(
            "DefinitionID",
            "17.2",
            "Name of the table, as its definition says",
            "Název tabulky podle její definice",
        )
    },
    ElementSpec {
        parents: &["Definition"],
        content: Some(COUNT),
        ..closed("LinesCount", "17.2", "Number of rows", "Počet řádků")
    },
    ElementSpec {
        parents: &["PLCTable"],
        attributes: &[needed("No", COUNT, "Number of the row, from 0", "Pořadové číslo řádku, od 0")],
        ..closed("Line", "17.2", "A row", "Řádek")
    },
    ElementSpec {
        parents: &["Line"],
        attributes: &[needed("ColID", ValueKind::Text, "Name of the column", "Název sloupce")],
        content: Some(ValueKind::Any),
        ..closed("Col", "17.2", "A value", "Hodnota")
    },
];
