//! Chapter 10: mapping of inputs and outputs.

use super::entry::{Effect, Entry, Place};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MAP_IN",
        chapter: "10.1",
        forms: &[
            form("MAP_IN bit, 'ID'"),
            form("MAP_IN bit, 'ID', default"),
            form("MAP_IN bit, 'ID', [default], FAST"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary input and binds it to an element of the channel configuration.",
            "Deklaruje binární vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_OUT",
        chapter: "10.1",
        forms: &[
            form("MAP_OUT bit, 'ID'"),
            form("MAP_OUT bit, 'ID', default"),
            form("MAP_OUT bit, 'ID', [default], FAST"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary output and binds it to an element of the channel configuration.",
            "Deklaruje binární výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_AIN",
        chapter: "10.5",
        forms: &[
            form("MAP_AIN cell, 'ID'"),
            form("MAP_AIN cell, 'ID', default"),
            form("MAP_AIN cell, 'ID', [default], FAST"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue input and binds it to an element of the channel configuration.",
            "Deklaruje analogový vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "MAP_AOUT",
        chapter: "10.5",
        forms: &[
            form("MAP_AOUT cell, 'ID'"),
            form("MAP_AOUT cell, 'ID', default"),
            form("MAP_AOUT cell, 'ID', [default], FAST"),
        ],
        operands: ANY_OPERANDS,
        place: Place::Init,
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue output and binds it to an element of the channel configuration.",
            "Deklaruje analogový výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        ..UNMODELLED
    },
];
