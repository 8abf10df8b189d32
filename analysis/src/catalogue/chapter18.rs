//! Chapter 18: shared memory and structures.

use super::entry::{Effect, Entry, Equation, Place};
use super::pattern::{ANY_OPERANDS, MULTI_CYCLE, UNMODELLED, UNMODELLED_DATA, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "STRUC",
        chapter: "18.1",
        forms: &[form("name STRUC")],
        summary: text(
            "Begins the description of a structure, whose members are typed offsets.",
            "Začátek popisu struktury; její položky jsou posuny s typem.",
        ),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "ENDS",
        chapter: "18.1",
        forms: &[form("name ENDS")],
        summary: text("Ends the description of a structure.", "Konec popisu struktury."),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DB",
        chapter: "18.1",
        forms: &[form("member DB ?")],
        operands: ANY_OPERANDS,
        summary: text(
            "Describes a member of type BYTE in a structure.",
            "Popíše položku struktury typu BYTE.",
        ),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DW",
        chapter: "18.1",
        forms: &[form("member DW ?")],
        operands: ANY_OPERANDS,
        summary: text(
            "Describes a member of type WORD in a structure.",
            "Popíše položku struktury typu WORD.",
        ),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DD",
        chapter: "18.1",
        forms: &[form("member DD ?")],
        operands: ANY_OPERANDS,
        summary: text(
            "Describes a member of type DWORD in a structure.",
            "Popíše položku struktury typu DWORD.",
        ),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DQ",
        chapter: "18.1",
        forms: &[form("member DQ ?")],
        operands: ANY_OPERANDS,
        summary: text(
            "Describes a member of type QWORD or REAL in a structure.",
            "Popíše položku struktury typu QWORD nebo REAL.",
        ),
        ..UNMODELLED_DATA
    },
    Entry {
        name: "SHARE_VAR",
        chapter: "18.2",
        forms: &[form("SHARE_VAR cell, 'name', type [,min] [,max]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        place: Place::Init,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Publishes a cell under a name for screens and dialogs; RLO 1 when accepted.",
            "Zveřejní buňku pod jménem pro obrazovky a dialogy; RLO je 1, když byla přijata.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "SHARE_BIT",
        chapter: "18.2",
        forms: &[form("SHARE_BIT cell, 'name', bit")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        place: Place::Init,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Publishes a bit under a name for screens and dialogs; RLO 1 when accepted.",
            "Zveřejní bit pod jménem pro obrazovky a dialogy; RLO je 1, když byl přijat.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "SA_READ",
        chapter: "18.3",
        forms: &[form("SA_READ area, offset, size, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Copies bytes from a shared area to the program.",
            "Zkopíruje bajty ze sdílené oblasti do programu.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "SA_WRITE",
        chapter: "18.3",
        forms: &[form("SA_WRITE area, offset, size, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Copies bytes from the program to a shared area.",
            "Zkopíruje bajty z programu do sdílené oblasti.",
        ),
        ..MULTI_CYCLE
    },
];
