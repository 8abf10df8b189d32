//! Chapter 16: configuration parameters and constants of the program.

use super::entry::{Effect, Entry, Equation};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CNF_GET_INT",
        chapter: "16.1",
        forms: &[form("CNF_GET_INT cell, 'ID' [,default]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads an integer configuration parameter; RLO 0 when it is missing.",
            "Přečte celočíselný konfigurační parametr; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CNF_GET_REAL",
        chapter: "16.1",
        forms: &[form("CNF_GET_REAL cell, 'ID' [,default]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a real configuration parameter; RLO 0 when it is missing.",
            "Přečte reálný konfigurační parametr; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CNF_GET_STR",
        chapter: "16.1",
        forms: &[form("CNF_GET_STR text, 'ID' [,default]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a text configuration parameter; RLO 0 when it is missing.",
            "Přečte textový konfigurační parametr; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CNF_GET_BIN",
        chapter: "16.1",
        forms: &[form("CNF_GET_BIN text, 'ID' [,default]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a binary configuration parameter; RLO 0 when it is missing.",
            "Přečte binární konfigurační parametr; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CNF_GET_BIT",
        chapter: "16.1",
        forms: &[form("CNF_GET_BIT bit, 'ID' [,default]")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a logical configuration parameter; RLO 0 when it is missing.",
            "Přečte logický konfigurační parametr; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CONST_GET",
        chapter: "16.2",
        forms: &[form("CONST_GET cell, 'ID'")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Reads a constant of the program into a cell and DR; RLO 0 when it is missing.",
            "Přečte konstantu programu do buňky a do DR; RLO je 0, když chybí.",
        ),
        ..UNMODELLED
    },
];
