//! Chapter 27: logical inputs and outputs, and the fastest modules.

use super::cell_type::CELL_TYPES;
use super::entry::{ConfigElement, Effect, Entry, NewCell, OperandKind, OperandSpec, Place};
use super::pattern::{UNMODELLED, UNMODELLED_STRUCTURE, form, operand, text};

const CELL: OperandSpec = operand(
    "cell",
    OperandKind::Declares(NewCell::Typed),
    "New name that the instruction declares; `name[n]` an array",
    "Nové jméno, které instrukce deklaruje; `jméno[n]` pole",
);
const fn identifier(element: ConfigElement) -> OperandSpec {
    operand(
        "ID",
        OperandKind::Identifier(element),
        "Identifier of the logical element",
        "Identifikátor logického prvku",
    )
}
const TYPE: OperandSpec =
    operand("type", OperandKind::Keyword(CELL_TYPES), "Type of the cell", "Typ buňky");
const DEFAULT: OperandSpec = operand(
    "default",
    OperandKind::Constant,
    "Value while the element is not connected",
    "Hodnota, dokud prvek není propojen",
)
.or_nothing()
.or_dash();
const PERIOD: OperandSpec = operand(
    "period",
    OperandKind::Keyword(&["SLOW", "FAST", "FASTEST", "ONDEMAND"]),
    "How often the connection is served",
    "Jak často se spoj obsluhuje",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DEF_IN",
        chapter: "27.2",
        forms: &[
            form("DEF_IN cell, 'ID', type [,default] [,period]"),
            form("DEF_IN cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: &[CELL, identifier(ConfigElement::LogicalInput), TYPE, DEFAULT, PERIOD],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical input that the configuration links to its source.",
            "Deklaruje logický vstup, který konfigurace propojí se zdrojem.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "DEF_OUT",
        chapter: "27.2",
        forms: &[
            form("DEF_OUT cell, 'ID', type [,default] [,period]"),
            form("DEF_OUT cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: &[CELL, identifier(ConfigElement::LogicalOutput), TYPE, DEFAULT, PERIOD],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical output that the configuration links to its targets.",
            "Deklaruje logický výstup, který konfigurace propojí s cíli.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "UPDATE_IN",
        chapter: "27.4",
        forms: &[form("UPDATE_IN cell"), form("UPDATE_IN cell[n]")],
        operands: &[operand(
            "cell",
            OperandKind::DeclaredElement,
            "Cell of DEF_IN, or one element of it",
            "Buňka z DEF_IN, nebo jeden její prvek",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Fetches a logical input at once.", "Okamžitě načte logický vstup."),
        ..UNMODELLED
    },
    Entry {
        name: "MODULE_CYCLICOPERATION",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION")],
        summary: text(
            "Begins the module run every millisecond before MODULE_FAST.",
            "Začátek modulu, který se provádí každou milisekundu před MODULE_FAST.",
        ),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_CYCLICOPERATION_END",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION_END")],
        summary: text("Ends MODULE_CYCLICOPERATION.", "Konec modulu MODULE_CYCLICOPERATION."),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST")],
        summary: text(
            "Begins the fastest module, run every 100 to 1000 µs by the configuration.",
            "Začátek nejrychlejšího modulu, který se podle konfigurace provádí každých 100 až 1000 µs.",
        ),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST_END",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST_END")],
        summary: text("Ends MODULE_FASTEST.", "Konec modulu MODULE_FASTEST."),
        ..UNMODELLED_STRUCTURE
    },
];
