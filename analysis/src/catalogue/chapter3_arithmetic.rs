//! Chapter 3.12: arithmetic and bitwise operations of DR with an operand.

use super::entry::{Effect, Entry};
use super::pattern::{COMPARED, FACTORS, INSTRUCTION, INTEGERS, VALUES, form, operand, source, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "AD",
        chapter: "3.12",
        forms: &[
            form("AD val"),
            form("AD [TYPE.]val"),
            form("AD TYPE.(val+n)"),
            form("AD CNST.number"),
            form("AD CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Adds a value to DR.", "Přičte hodnotu k DR."),
        ..INSTRUCTION
    },
    Entry {
        name: "SU",
        chapter: "3.12",
        forms: &[
            form("SU val"),
            form("SU [TYPE.]val"),
            form("SU TYPE.(val+n)"),
            form("SU CNST.number"),
            form("SU CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Subtracts a value from DR.", "Odečte hodnotu od DR."),
        ..INSTRUCTION
    },
    Entry {
        name: "MULB",
        chapter: "3.12",
        forms: &[
            form("MULB val"),
            form("MULB [TYPE.]val"),
            form("MULB TYPE.(val+n)"),
            form("MULB CNST.number"),
            form("MULB CNST.real"),
        ],
        operands: &[operand(
            "val",
            source(FACTORS, VALUES),
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Multiplies DR by a value, with sign.", "Vynásobí DR hodnotou, se znaménkem."),
        ..INSTRUCTION
    },
    Entry {
        name: "DIVB",
        chapter: "3.12",
        forms: &[
            form("DIVB val"),
            form("DIVB [TYPE.]val"),
            form("DIVB TYPE.(val+n)"),
            form("DIVB CNST.number"),
            form("DIVB CNST.real"),
        ],
        operands: &[operand(
            "val",
            source(FACTORS, VALUES),
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr64, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Divides DR by a value, with sign.", "Vydělí DR hodnotou, se znaménkem."),
        ..INSTRUCTION
    },
    Entry {
        name: "ORB",
        chapter: "3.12",
        forms: &[form("ORB val"), form("ORB [TYPE.]val"), form("ORB TYPE.(val+n)"), form("ORB CNST.number")],
        operands: &[operand(
            "val",
            source(INTEGERS, VALUES),
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("ORs DR with a value bit by bit.", "Logický součet DR s hodnotou po bitech."),
        ..INSTRUCTION
    },
    Entry {
        name: "ANDB",
        chapter: "3.12",
        forms: &[
            form("ANDB val"),
            form("ANDB [TYPE.]val"),
            form("ANDB TYPE.(val+n)"),
            form("ANDB CNST.number"),
        ],
        operands: &[operand(
            "val",
            source(INTEGERS, VALUES),
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("ANDs DR with a value bit by bit.", "Logický součin DR s hodnotou po bitech."),
        ..INSTRUCTION
    },
    Entry {
        name: "XORB",
        chapter: "3.12",
        forms: &[
            form("XORB val"),
            form("XORB [TYPE.]val"),
            form("XORB TYPE.(val+n)"),
            form("XORB CNST.number"),
        ],
        operands: &[operand(
            "val",
            source(INTEGERS, VALUES),
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("XORs DR with a value bit by bit.", "Nonekvivalence DR s hodnotou po bitech."),
        ..INSTRUCTION
    },
];
