//! Chapter 3.13: instructions that work on DR itself.

use super::entry::{Effect, Entry, OperandKind};
use super::pattern::{INSTRUCTION, SHIFT_CELLS, SHIFTS, form, operand, source, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "INR",
        chapter: "3.13",
        forms: &[form("INR"), form("INR DWRD"), form("INR QWRD"), form("INR REAL")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD", "REAL"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Adds one to DR.", "Zvětší DR o jedničku."),
        ..INSTRUCTION
    },
    Entry {
        name: "DCR",
        chapter: "3.13",
        forms: &[form("DCR"), form("DCR DWRD"), form("DCR QWRD"), form("DCR REAL")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD", "REAL"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Subtracts one from DR.", "Zmenší DR o jedničku."),
        ..INSTRUCTION
    },
    Entry {
        name: "INRBCD",
        chapter: "3.13",
        forms: &[form("INRBCD")],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Adds one to DR in BCD.", "Zvětší DR o jedničku v kódu BCD."),
        ..INSTRUCTION
    },
    Entry {
        name: "BIN",
        chapter: "3.13",
        forms: &[form("BIN"), form("BIN DWRD")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Converts DR from BCD to binary.", "Převede DR z kódu BCD do binárního kódu."),
        ..INSTRUCTION
    },
    Entry {
        name: "BCD",
        chapter: "3.13",
        forms: &[form("BCD"), form("BCD DWRD")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Converts DR from binary to BCD.", "Převede DR z binárního kódu do kódu BCD."),
        ..INSTRUCTION
    },
    Entry {
        name: "RL",
        chapter: "3.13",
        forms: &[form("RL n"), form("RL [TYPE.]n"), form("RL [TYPE.]n, DWRD"), form("RL [TYPE.]n, QWRD")],
        operands: &[
            operand(
                "n",
                source(SHIFTS, SHIFT_CELLS),
                "Number of places: a constant or a cell of 8 bits",
                "Počet míst: konstanta nebo 8bitová buňka",
            ),
            operand(
                "width",
                OperandKind::Keyword(&["DWRD", "QWRD"]),
                "Width of DR; without it 16 bits",
                "Šířka DR; bez operandu 16 bitů",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("Shifts DR left, filling with zeros.", "Posune DR vlevo, zprava doplní nuly."),
        ..INSTRUCTION
    },
    Entry {
        name: "RR",
        chapter: "3.13",
        forms: &[form("RR n"), form("RR [TYPE.]n"), form("RR [TYPE.]n, DWRD"), form("RR [TYPE.]n, QWRD")],
        operands: &[
            operand(
                "n",
                source(SHIFTS, SHIFT_CELLS),
                "Number of places: a constant or a cell of 8 bits",
                "Počet míst: konstanta nebo 8bitová buňka",
            ),
            operand(
                "width",
                OperandKind::Keyword(&["DWRD", "QWRD"]),
                "Width of DR; without it 16 bits",
                "Šířka DR; bez operandu 16 bitů",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("Shifts DR right, filling with zeros.", "Posune DR vpravo, zleva doplní nuly."),
        ..INSTRUCTION
    },
    Entry {
        name: "INV",
        chapter: "3.13",
        forms: &[form("INV"), form("INV DWRD"), form("INV QWRD"), form("INV REAL")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD", "REAL"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Changes the sign of DR (two's complement).", "Změní znaménko DR (dvojkový doplněk)."),
        ..INSTRUCTION
    },
    Entry {
        name: "ABS",
        chapter: "3.13",
        forms: &[form("ABS"), form("ABS DWRD"), form("ABS QWRD"), form("ABS REAL")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD", "REAL"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Replaces DR by its absolute value.", "Nahradí DR jeho absolutní hodnotou."),
        ..INSTRUCTION
    },
];
