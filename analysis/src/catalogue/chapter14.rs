//! Chapter 14: messages of the PLC program.

use super::entry::{Effect, Entry, Equation, OperandKind};
use super::pattern::{INSTRUCTION, MESSAGE, MESSAGE_VALUE, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ESET",
        chapter: "14.3",
        forms: &[
            form("ESET"),
            form("ESET error"),
            form("ESET [error], [subid], [set], [par1], [par2], [par3]"),
        ],
        operands: &[
            operand(
                "error",
                OperandKind::Value(MESSAGE),
                "Number of the message: WORD cell or constant; without it DR",
                "Číslo hlášení: buňka WORD nebo konstanta; bez operandu se bere DR",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "subid",
                OperandKind::Value(MESSAGE_VALUE),
                "Supplementary number: DWORD cell or constant",
                "Doplňkové číslo: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "set",
                OperandKind::Number { min: 0, max: 1 },
                "Persistent messages only: 1 shows the message, 0 removes it",
                "Jen u trvalých hlášení: 1 hlášení zobrazí, 0 odstraní",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par1",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 1 for the text of the message: DWORD cell or constant",
                "Hodnota 1 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par2",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 2 for the text of the message: DWORD cell or constant",
                "Hodnota 2 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par3",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 3 for the text of the message: DWORD cell or constant",
                "Hodnota 3 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
        ],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Reports a message of the PLC program.", "Vydá hlášení PLC programu."),
        ..INSTRUCTION
    },
    Entry {
        name: "ESET1",
        chapter: "14.3",
        forms: &[
            form("ESET1"),
            form("ESET1 error"),
            form("ESET1 [error], [subid], [set], [par1], [par2], [par3]"),
        ],
        operands: &[
            operand(
                "error",
                OperandKind::Value(MESSAGE),
                "Number of the message: WORD cell or constant; without it DR",
                "Číslo hlášení: buňka WORD nebo konstanta; bez operandu se bere DR",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "subid",
                OperandKind::Value(MESSAGE_VALUE),
                "Supplementary number: DWORD cell or constant",
                "Doplňkové číslo: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "set",
                OperandKind::Number { min: 0, max: 1 },
                "Persistent messages only: 1 shows the message, 0 removes it",
                "Jen u trvalých hlášení: 1 hlášení zobrazí, 0 odstraní",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par1",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 1 for the text of the message: DWORD cell or constant",
                "Hodnota 1 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par2",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 2 for the text of the message: DWORD cell or constant",
                "Hodnota 2 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "par3",
                OperandKind::Value(MESSAGE_VALUE),
                "Value 3 for the text of the message: DWORD cell or constant",
                "Hodnota 3 do textu hlášení: buňka DWORD nebo konstanta",
            )
            .or_dash()
            .or_nothing(),
        ],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Reports a message of the PLC program when RLO is 1.",
            "Vydá hlášení PLC programu, když je RLO 1.",
        ),
        ..INSTRUCTION
    },
];
