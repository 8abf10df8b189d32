//! Column types and changes of the PLC tables (manual 17.4).
//!
//! Of the values of the types the manual shows only that of `PlcTabType_Bin`; the others are its order.

use super::Direction::CncToPlc;
use super::space::{Row, Shape};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "PlcTabType_Int",
        Shape::Constant(1),
        CncToPlc,
        "17.4.3",
        text(
            "Type of a table column: whole number, DWORD (this implementation).",
            "Typ sloupce tabulky: celé číslo, DWORD (tato implementace).",
        ),
    ),
    (
        "PlcTabType_Real",
        Shape::Constant(2),
        CncToPlc,
        "17.4.3",
        text(
            "Type of a table column: real number (this implementation).",
            "Typ sloupce tabulky: reálné číslo (tato implementace).",
        ),
    ),
    (
        "PlcTabType_Str",
        Shape::Constant(3),
        CncToPlc,
        "17.4.3",
        text(
            "Type of a table column: text (this implementation).",
            "Typ sloupce tabulky: textový řetězec (tato implementace).",
        ),
    ),
    (
        "PlcTabType_Bin",
        Shape::Constant(4),
        CncToPlc,
        "17.4.3",
        text("Type of a table column: binary string.", "Typ sloupce tabulky: binární řetězec."),
    ),
    (
        "PlctItemChanged",
        Shape::Constant(1),
        CncToPlc,
        "17.4.5",
        text("Change of a table: an item has another value.", "Změna v tabulce: jiná hodnota položky."),
    ),
    (
        "PlctSellLineChanged",
        Shape::Constant(2),
        CncToPlc,
        "17.4.5",
        text("Change of a table: another row is selected.", "Změna v tabulce: je vybrán jiný řádek."),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn types_and_changes_have_their_values() {
        assert_eq!(ROWS.len(), 6);
        for (name, value) in [
            ("PlcTabType_Int", 1),
            ("PlcTabType_Real", 2),
            ("PlcTabType_Str", 3),
            ("PlcTabType_Bin", 4),
            ("PlctItemChanged", 1),
            ("PlctSellLineChanged", 2),
        ] {
            assert_eq!(symbol(name).map(|symbol| symbol.kind), Some(SystemKind::Constant(value)), "{name}");
        }
    }
}
