//! Chapter 27: logical inputs and outputs, and the fastest modules.

use super::entry::{Effect, Entry, Place};
use super::pattern::{ANY_OPERANDS, UNMODELLED, UNMODELLED_STRUCTURE, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DEF_IN",
        chapter: "27.2",
        forms: &[
            form("DEF_IN cell, 'ID', type [,default] [,period]"),
            form("DEF_IN cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical input that the configuration links to its source.",
            "Deklaruje logický vstup, který konfigurace propojí se zdrojem.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "DEF_OUT",
        chapter: "27.2",
        forms: &[
            form("DEF_OUT cell, 'ID', type [,default] [,period]"),
            form("DEF_OUT cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical output that the configuration links to its targets.",
            "Deklaruje logický výstup, který konfigurace propojí s cíli.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "UPDATE_IN",
        chapter: "27.4",
        forms: &[form("UPDATE_IN cell"), form("UPDATE_IN cell[n]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Fetches a logical input at once.", "Okamžitě načte logický vstup."),
        ..UNMODELLED
    },
    Entry {
        name: "MODULE_CYCLICOPERATION",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION")],
        summary: text(
            "Begins the module run every millisecond before MODULE_FAST.",
            "Začátek modulu, který se provádí každou milisekundu před MODULE_FAST.",
        ),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_CYCLICOPERATION_END",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION_END")],
        summary: text("Ends MODULE_CYCLICOPERATION.", "Konec modulu MODULE_CYCLICOPERATION."),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST")],
        summary: text(
            "Begins the fastest module, run every 100 to 1000 µs by the configuration.",
            "Začátek nejrychlejšího modulu, který se podle konfigurace provádí každých 100 až 1000 µs.",
        ),
        ..UNMODELLED_STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST_END",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST_END")],
        summary: text("Ends MODULE_FASTEST.", "Konec modulu MODULE_FASTEST."),
        ..UNMODELLED_STRUCTURE
    },
];
