//! Chapter 3.4: declarations.

use super::entry::{Entry, OperandKind, Place};
use super::pattern::{DECLARATION, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DFM",
        chapter: "3.4",
        forms: &[form("[name:] DFM [bit0],[bit1],[bit2],[bit3],[bit4],[bit5],[bit6],[bit7]")],
        operands: &[operand(
            "bit",
            OperandKind::NewBit,
            "Name of the bit at this position, d0 first; an empty place leaves the bit unnamed",
            "Jméno bitu na této pozici, první je d0; prázdné místo nechá bit bezejmenný",
        )
        .or_nothing()
        .repeated()],
        summary: text(
            "Reserves one byte and names its bits.",
            "Vyhradí jednu slabiku a pojmenuje její bity.",
        ),
        ..DECLARATION
    },
    Entry {
        name: "DS",
        chapter: "3.4",
        forms: &[form("name: DS 1"), form("name: DS 2"), form("name: DS 4"), form("name: DS n")],
        operands: &[operand(
            "length",
            OperandKind::Number { min: 1, max: 0xFF_FFFF },
            "Length in bytes: 1 makes a BYTE, 2 a WORD, 4 a DWORD, anything else an untyped area",
            "Délka v bajtech: 1 je BYTE, 2 WORD, 4 DWORD, cokoli jiného je oblast bez typu",
        )],
        summary: text(
            "Reserves memory and gives its label a type by the length.",
            "Vyhradí paměť a podle délky určí typ návěští.",
        ),
        ..DECLARATION
    },
    Entry {
        name: "EQUI",
        chapter: "3.4",
        forms: &[form("EQUI name, value")],
        operands: &[
            operand(
                "name",
                OperandKind::NewName,
                "Name of the constant, without a colon",
                "Jméno konstanty, bez dvojtečky",
            ),
            operand(
                "value",
                OperandKind::Number { min: -0x8000_0000, max: 0xFFFF_FFFF },
                "Integer, character or constant expression of at most 32 bits",
                "Celé číslo, znak nebo konstantní výraz o nejvýše 32 bitech",
            ),
        ],
        place: Place::Anywhere,
        summary: text(
            "Names an integer constant; no memory is reserved.",
            "Pojmenuje celočíselnou konstantu; paměť nezabírá.",
        ),
        ..DECLARATION
    },
];
