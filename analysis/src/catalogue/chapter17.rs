//! Chapter 17: PLC tables.

use super::entry::{Effect, Entry};
use super::pattern::{ANY_OPERANDS, MULTI_CYCLE, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "PLCT_GET_INT",
        chapter: "17.4",
        forms: &[form("PLCT_GET_INT table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads an integer from a PLC table.", "Přečte celé číslo z PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_GET_REAL",
        chapter: "17.4",
        forms: &[form("PLCT_GET_REAL table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads a real number from a PLC table.", "Přečte reálné číslo z PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_GET_STR",
        chapter: "17.4",
        forms: &[form("PLCT_GET_STR table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads a text from a PLC table.", "Přečte text z PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_GET_BIN",
        chapter: "17.4",
        forms: &[form("PLCT_GET_BIN table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads binary data from a PLC table.", "Přečte binární data z PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_SET_INT",
        chapter: "17.4",
        forms: &[form("PLCT_SET_INT table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Writes an integer to a PLC table.", "Zapíše celé číslo do PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_SET_REAL",
        chapter: "17.4",
        forms: &[form("PLCT_SET_REAL table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Writes a real number to a PLC table.", "Zapíše reálné číslo do PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_SET_STR",
        chapter: "17.4",
        forms: &[form("PLCT_SET_STR table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Writes a text to a PLC table.", "Zapíše text do PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_SET_BIN",
        chapter: "17.4",
        forms: &[form("PLCT_SET_BIN table, line, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Writes binary data to a PLC table.", "Zapíše binární data do PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_COL_INDEX",
        chapter: "17.4",
        forms: &[form("PLCT_COL_INDEX table, 'ID', cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Finds the index of a column of a PLC table by its identifier.",
            "Najde index sloupce PLC tabulky podle identifikátoru.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_COL_ID",
        chapter: "17.4",
        forms: &[form("PLCT_COL_ID table, text")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Finds the identifier of a column of a PLC table by its index.",
            "Najde identifikátor sloupce PLC tabulky podle indexu.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_COL_TYPE",
        chapter: "17.4",
        forms: &[form("PLCT_COL_TYPE table, column, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Reads the data type of a column of a PLC table.",
            "Zjistí datový typ sloupce PLC tabulky.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_GET_SELLINE",
        chapter: "17.4",
        forms: &[form("PLCT_GET_SELLINE table, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads the selected line of a PLC table.", "Zjistí vybraný řádek PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_SET_SELLINE",
        chapter: "17.4",
        forms: &[form("PLCT_SET_SELLINE table, line")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Selects a line of a PLC table.", "Vybere řádek PLC tabulky."),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_CHANGED",
        chapter: "17.4",
        forms: &[form("PLCT_CHANGED table, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Tells whether a PLC table or its selected line has changed.",
            "Zjistí, zda se PLC tabulka nebo její vybraný řádek změnily.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "PLCT_GET_LINESCOUNT",
        chapter: "17.4",
        forms: &[form("PLCT_GET_LINESCOUNT table, cell")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text("Reads the number of lines of a PLC table.", "Zjistí počet řádků PLC tabulky."),
        ..MULTI_CYCLE
    },
];
