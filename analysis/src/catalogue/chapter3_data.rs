//! Chapter 3.10: loading and storing data.

use super::entry::{Effect, Entry, Equation, PrefixSet};
use super::pattern::{CELLS, INSTRUCTION, LOADED, STORED, form, operand, source, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "LOD",
        chapter: "3.10",
        forms: &[
            form("LOD [-]val"),
            form("LOD [-][TYPE.]val"),
            form("LOD [-]TYPE.(val+n)"),
            form("LOD [-]CNST.number"),
            form("LOD CNST.real"),
        ],
        operands: &[operand(
            "val",
            LOADED,
            "Cell, EQUI constant or number; a leading `-` negates",
            "Buňka, konstanta EQUI nebo číslo; znaménko `-` vpředu neguje",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Loads a value into DR.", "Načte hodnotu do DR."),
        ..INSTRUCTION
    },
    Entry {
        name: "STO",
        chapter: "3.10",
        forms: &[form("STO val"), form("STO [TYPE.]val"), form("STO TYPE.(val+n)")],
        operands: &[operand("val", STORED, "Cell that receives DR", "Buňka, do které se DR zapíše")],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory.", "Zapíše DR do paměti."),
        ..INSTRUCTION
    },
    Entry {
        name: "STO1",
        chapter: "3.10",
        forms: &[form("STO1 val"), form("STO1 [TYPE.]val"), form("STO1 TYPE.(val+n)")],
        operands: &[operand("val", STORED, "Cell that receives DR", "Buňka, do které se DR zapíše")],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory when RLO is 1.", "Zapíše DR do paměti, když je RLO 1."),
        ..INSTRUCTION
    },
    Entry {
        name: "STO0",
        chapter: "3.10",
        forms: &[form("STO0 val"), form("STO0 [TYPE.]val"), form("STO0 TYPE.(val+n)")],
        operands: &[operand("val", STORED, "Cell that receives DR", "Buňka, do které se DR zapíše")],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory when RLO is 0.", "Zapíše DR do paměti, když je RLO 0."),
        ..INSTRUCTION
    },
    Entry {
        name: "MOVE",
        chapter: "3.10",
        forms: &[
            form("MOVE dst, src"),
            form("MOVE [TYPE.]dst, [TYPE.]src"),
            form("MOVE TYPE.(dst+n), TYPE.(src+n)"),
        ],
        operands: &[
            operand("dst", STORED, "Destination cell", "Cílová buňka"),
            operand(
                "src",
                source(PrefixSet::STORE, CELLS),
                "Source cell of the same type",
                "Zdrojová buňka téhož typu",
            ),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies one cell to another of the same type.",
            "Zkopíruje buňku do jiné buňky téhož typu.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "MOVE1",
        chapter: "3.10",
        forms: &[
            form("MOVE1 dst, src"),
            form("MOVE1 [TYPE.]dst, [TYPE.]src"),
            form("MOVE1 TYPE.(dst+n), TYPE.(src+n)"),
        ],
        operands: &[
            operand("dst", STORED, "Destination cell", "Cílová buňka"),
            operand(
                "src",
                source(PrefixSet::STORE, CELLS),
                "Source cell of the same type",
                "Zdrojová buňka téhož typu",
            ),
        ],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies one cell to another of the same type when RLO is 1.",
            "Zkopíruje buňku do jiné buňky téhož typu, když je RLO 1.",
        ),
        ..INSTRUCTION
    },
];
