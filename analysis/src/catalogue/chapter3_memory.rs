//! Chapters 3.15 and 3.16: conversions between RLO, DR and DR_REAL, blocks of memory.

use super::entry::{Access, Effect, Entry, Equation, OperandKind};
use super::pattern::{INSTRUCTION, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CONDR",
        chapter: "3.15",
        forms: &[form("CONDR"), form("CONDR DWRD"), form("CONDR n")],
        operands: &[operand(
            "which",
            OperandKind::KeywordOrNumber(&["DWRD"], 0, 31),
            "DWRD tests 32 bits; a number 0 to 31 picks one bit; without it 16 bits are tested",
            "DWRD testuje 32 bitů; číslo 0 až 31 vybere jeden bit; bez operandu se testuje 16 bitů",
        )
        .or_nothing()],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO from DR: 0 when DR is zero, otherwise 1, or one bit of DR.",
            "Naplní RLO z DR: 0 při nulovém DR, jinak 1, nebo jeden bit DR.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "CONRD",
        chapter: "3.15",
        forms: &[form("CONRD"), form("CONRD DWRD")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Dr],
        summary: text("Fills DR with zeros or ones by RLO.", "Naplní DR nulami nebo jedničkami podle RLO."),
        ..INSTRUCTION
    },
    Entry {
        name: "MV",
        chapter: "3.15",
        forms: &[form("MV src, dest, num"), form("MV src+n, dest+m, num")],
        operands: &[
            operand(
                "src",
                OperandKind::Address(Access::Read),
                "Address to copy from",
                "Adresa, odkud se kopíruje",
            ),
            operand(
                "dest",
                OperandKind::Address(Access::Write),
                "Address to copy to",
                "Adresa, kam se kopíruje",
            ),
            operand("num", OperandKind::Number { min: 0, max: 0xFF_FFFF }, "Number of bytes", "Počet bajtů"),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies a block of memory; the source comes first.",
            "Zkopíruje blok paměti; zdroj se píše první.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "CLEAR",
        chapter: "3.15",
        forms: &[form("CLEAR begin, end"), form("CLEAR GLOBAL, ALL"), form("CLEAR INTERNAL, ALL")],
        operands: &[
            operand(
                "begin",
                OperandKind::Address(Access::Write),
                "First cell, or GLOBAL or INTERNAL",
                "První buňka, nebo GLOBAL či INTERNAL",
            ),
            operand(
                "end",
                OperandKind::Address(Access::Write),
                "Last cell, itself included, or ALL",
                "Poslední buňka (včetně ní), nebo ALL",
            ),
        ],
        writes: &[Effect::Memory],
        summary: text("Fills memory with zeros.", "Vynuluje paměť."),
        ..INSTRUCTION
    },
    Entry {
        name: "REAL",
        chapter: "3.16",
        forms: &[form("REAL"), form("REAL DWRD"), form("REAL QWRD"), form("INSTRUCTION REAL.name")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr],
        writes: &[Effect::DrReal, Effect::Dr64],
        summary: text(
            "Converts the integer in DR to a real number; as the prefix `REAL.` accesses the operand as a 64-bit real.",
            "Převede celé číslo v DR na reálné; jako prefix `REAL.` přistupuje k operandu jako k 64bitovému reálnému číslu.",
        ),
        ..INSTRUCTION
    },
];
