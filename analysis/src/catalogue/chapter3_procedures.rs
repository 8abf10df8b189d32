//! Chapter 3.17: procedures, and those that the system calls.

use super::entry::{Effect, Entry, OperandKind, Place};
use super::pattern::{EVENT_PROCEDURE, INSTRUCTION, STRUCTURE, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "PROC_BEGIN",
        chapter: "3.17",
        forms: &[form("PROC_BEGIN name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: true },
            "Name of the procedure",
            "Jméno procedury",
        )],
        place: Place::Main,
        summary: text("Begins the definition of a procedure.", "Začátek definice procedury."),
        ..STRUCTURE
    },
    Entry {
        name: "PROC_END",
        chapter: "3.17",
        forms: &[form("PROC_END name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: false },
            "The name given at PROC_BEGIN",
            "Jméno uvedené u PROC_BEGIN",
        )],
        place: Place::Main,
        summary: text(
            "Ends a procedure and returns to its caller.",
            "Konec procedury a návrat za místo volání.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "PROC_CALL",
        chapter: "3.17",
        forms: &[form("PROC_CALL name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: false },
            "Procedure of any file",
            "Procedura z kteréhokoli souboru",
        )],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::DrReal, Effect::Memory],
        summary: text("Calls a procedure.", "Zavolá proceduru."),
        ..INSTRUCTION
    },
    Entry {
        name: "_ON_ESET",
        forms: &[form("PROC_BEGIN _ON_ESET")],
        reads: &[Effect::Dr],
        summary: text(
            "Procedure that every message of ESET, ESET1 calls, with its number in DR.",
            "Procedura, kterou volá každé hlášení ESET, ESET1; v DR je číslo hlášení.",
        ),
        ..EVENT_PROCEDURE
    },
    Entry {
        name: "_ON_CMD",
        forms: &[form("PROC_BEGIN _ON_CMD")],
        reads: &[Effect::Rlo, Effect::Dr],
        summary: text(
            "Procedure called when a configured key or soft-menu is pressed or released.",
            "Procedura volaná při stisku a uvolnění nakonfigurované klávesy nebo softwarového menu.",
        ),
        ..EVENT_PROCEDURE
    },
    Entry {
        name: "_ON_EVENT",
        forms: &[form("PROC_BEGIN _ON_EVENT")],
        reads: &[Effect::Dr],
        summary: text(
            "Procedure called at selected events of the system, with the event in DR.",
            "Procedura volaná při vybraných událostech systému; v DR je kód události.",
        ),
        ..EVENT_PROCEDURE
    },
];
