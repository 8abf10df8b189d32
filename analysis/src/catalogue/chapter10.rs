//! Chapter 10: mapping of inputs and outputs.

use super::entry::{ConfigElement, Effect, Entry, NewCell, OperandKind, OperandSpec, Place};
use super::pattern::{UNMODELLED, form, operand, text};

const fn new_name(cell: NewCell) -> OperandSpec {
    operand(
        "name",
        OperandKind::Declares(cell),
        "New name that the instruction declares",
        "Nové jméno, které instrukce deklaruje",
    )
}
const fn identifier(element: ConfigElement) -> OperandSpec {
    operand(
        "ID",
        OperandKind::Identifier(element),
        "Identifier in the channel configuration",
        "Identifikátor v konfiguraci kanálu",
    )
}
const fn default(kind: OperandKind) -> OperandSpec {
    operand(
        "default",
        kind,
        "Value when the configuration does not know the identifier",
        "Hodnota, když konfigurace identifikátor nezná",
    )
    .or_nothing()
    .or_dash()
}
const FAST: OperandSpec = operand(
    "FAST",
    OperandKind::Keyword(&["FAST"]),
    "Transfer every millisecond",
    "Přenos každou milisekundu",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MAP_IN",
        chapter: "10.1",
        forms: &[
            form("MAP_IN bit, 'ID'"),
            form("MAP_IN bit, 'ID', default"),
            form("MAP_IN bit, 'ID', [default], FAST"),
        ],
        operands: &[new_name(NewCell::Bit), identifier(ConfigElement::Input), default(OperandKind::Number { min: 0, max: 1 }), FAST],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary input and binds it to an element of the channel configuration.",
            "Deklaruje binární vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_OUT",
        chapter: "10.1",
        forms: &[
            form("MAP_OUT bit, 'ID'"),
            form("MAP_OUT bit, 'ID', default"),
            form("MAP_OUT bit, 'ID', [default], FAST"),
        ],
        operands: &[new_name(NewCell::Bit), identifier(ConfigElement::Output), default(OperandKind::Number { min: 0, max: 1 }), FAST],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary output and binds it to an element of the channel configuration.",
            "Deklaruje binární výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_AIN",
        chapter: "10.5",
        forms: &[
            form("MAP_AIN cell, 'ID'"),
            form("MAP_AIN cell, 'ID', default"),
            form("MAP_AIN cell, 'ID', [default], FAST"),
        ],
        operands: &[new_name(NewCell::Real), identifier(ConfigElement::AnalogInput), default(OperandKind::Constant), FAST],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue input and binds it to an element of the channel configuration.",
            "Deklaruje analogový vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_AOUT",
        chapter: "10.5",
        forms: &[
            form("MAP_AOUT cell, 'ID'"),
            form("MAP_AOUT cell, 'ID', default"),
            form("MAP_AOUT cell, 'ID', [default], FAST"),
        ],
        operands: &[new_name(NewCell::Real), identifier(ConfigElement::AnalogOutput), default(OperandKind::Constant), FAST],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue output and binds it to an element of the channel configuration.",
            "Deklaruje analogový výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
];
