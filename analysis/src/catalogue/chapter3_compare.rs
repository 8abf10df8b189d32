//! Chapter 3.14: comparing DR with an operand.

use super::entry::{Effect, Entry, Equation};
use super::pattern::{COMPARED, INSTRUCTION, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "EQ",
        chapter: "3.14",
        forms: &[
            form("EQ val"),
            form("EQ [TYPE.]val"),
            form("EQ TYPE.(val+n)"),
            form("EQ CNST.number"),
            form("EQ CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text("Sets RLO when DR equals the value.", "Nastaví RLO, když se DR rovná hodnotě."),
        ..INSTRUCTION
    },
    Entry {
        name: "LT",
        chapter: "3.14",
        forms: &[
            form("LT val"),
            form("LT [TYPE.]val"),
            form("LT TYPE.(val+n)"),
            form("LT CNST.number"),
            form("LT CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is less than the value.",
            "Nastaví RLO, když je DR menší než hodnota.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "GT",
        chapter: "3.14",
        forms: &[
            form("GT val"),
            form("GT [TYPE.]val"),
            form("GT TYPE.(val+n)"),
            form("GT CNST.number"),
            form("GT CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is greater than the value.",
            "Nastaví RLO, když je DR větší než hodnota.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "LE",
        chapter: "3.14",
        forms: &[
            form("LE val"),
            form("LE [TYPE.]val"),
            form("LE TYPE.(val+n)"),
            form("LE CNST.number"),
            form("LE CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is less than or equal to the value.",
            "Nastaví RLO, když je DR menší než hodnota nebo se jí rovná.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "GE",
        chapter: "3.14",
        forms: &[
            form("GE val"),
            form("GE [TYPE.]val"),
            form("GE TYPE.(val+n)"),
            form("GE CNST.number"),
            form("GE CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is greater than or equal to the value.",
            "Nastaví RLO, když je DR větší než hodnota nebo se jí rovná.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "EQ1",
        chapter: "3.14",
        forms: &[
            form("EQ1 val"),
            form("EQ1 [TYPE.]val"),
            form("EQ1 TYPE.(val+n)"),
            form("EQ1 CNST.number"),
            form("EQ1 CNST.real"),
        ],
        operands: &[operand(
            "val",
            COMPARED,
            "Cell, EQUI constant or number",
            "Buňka, konstanta EQUI nebo číslo",
        )],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Compares DR with the value only when RLO is 1.",
            "Porovná DR s hodnotou, jen když je RLO 1.",
        ),
        ..INSTRUCTION
    },
];
