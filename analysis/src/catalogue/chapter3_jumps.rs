//! Chapter 3.8: jumps.

use super::entry::{Effect, Entry, Equation, OperandKind};
use super::pattern::{INSTRUCTION, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "JUM",
        chapter: "3.8",
        forms: &[form("JUM label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at",
            "Návěští, na kterém se pokračuje",
        )],
        summary: text("Jumps unconditionally.", "Nepodmíněný skok."),
        ..INSTRUCTION
    },
    Entry {
        name: "JL0",
        chapter: "3.8",
        forms: &[form("JL0 label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at when RLO is 0",
            "Návěští, na kterém se pokračuje při RLO = 0",
        )],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        summary: text("Jumps when RLO is 0.", "Skočí, když je RLO 0."),
        ..INSTRUCTION
    },
    Entry {
        name: "JL1",
        chapter: "3.8",
        forms: &[form("JL1 label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at when RLO is 1",
            "Návěští, na kterém se pokračuje při RLO = 1",
        )],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        summary: text("Jumps when RLO is 1.", "Skočí, když je RLO 1."),
        ..INSTRUCTION
    },
];
