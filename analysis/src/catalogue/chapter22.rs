//! Chapter 22: included files and user macros.

use super::entry::{Entry, OperandKind};
use super::pattern::{ANY_OPERANDS, DIRECTIVE, UNMODELLED_DIRECTIVE, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "T_INCLUDE",
        chapter: "22.1",
        forms: &[form("T_INCLUDE file"), form("T_INCLUDE 'file'")],
        operands: &[operand(
            "file",
            OperandKind::LiteralOrAddress,
            "File name, with or without apostrophes",
            "Jméno souboru, v apostrofech i bez nich",
        )],
        summary: text(
            "Joins a file of definitions to the source text.",
            "Připojí ke zdrojovému textu soubor s definicemi.",
        ),
        ..DIRECTIVE
    },
    Entry {
        name: "DEF_T_MACRO",
        chapter: "22.2",
        forms: &[form("DEF_T_MACRO name [par1, par2, …]")],
        operands: ANY_OPERANDS,
        summary: text(
            "Begins the definition of a macro, which is then used like an instruction.",
            "Začátek definice makra; to se pak používá jako instrukce.",
        ),
        ..UNMODELLED_DIRECTIVE
    },
    Entry {
        name: "END_T_MACRO",
        chapter: "22.2",
        forms: &[form("END_T_MACRO"), form("END_T_MACRO stackflag [,convflag [,debugflag]]")],
        operands: ANY_OPERANDS,
        summary: text("Ends the definition of a macro.", "Konec definice makra."),
        ..UNMODELLED_DIRECTIVE
    },
    Entry {
        name: "T_LOCAL",
        chapter: "22.3",
        forms: &[form("T_LOCAL symbol1 [,symbol2 …]")],
        operands: ANY_OPERANDS,
        summary: text(
            "Makes symbols of a macro local to each use.",
            "Učiní symboly makra lokálními pro každé jeho použití.",
        ),
        ..UNMODELLED_DIRECTIVE
    },
    Entry {
        name: "APPEND_T_MACRO",
        chapter: "22.4",
        forms: &[form("APPEND_T_MACRO name, alias [,stackflag [,convflag [,debugflag]]]")],
        operands: ANY_OPERANDS,
        summary: text("Adds a word that expands to a macro.", "Přidá slovo, které se rozvine v makro."),
        ..UNMODELLED_DIRECTIVE
    },
    Entry {
        name: "CONTROL_T_MACRO",
        chapter: "22.4",
        forms: &[form("CONTROL_T_MACRO POS"), form("CONTROL_T_MACRO PRE")],
        operands: ANY_OPERANDS,
        summary: text(
            "Chooses whether macros are expanded after or before the instructions are decoded.",
            "Zvolí, zda se makra rozvíjejí po rozpoznání instrukcí, nebo před ním.",
        ),
        ..UNMODELLED_DIRECTIVE
    },
];
