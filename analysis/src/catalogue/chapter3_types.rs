//! Chapter 3.9 and the keywords that stand as operands: type prefixes, BX, NIL, GLOBAL …

use super::entry::Entry;
use super::pattern::{KEYWORD, PREFIX, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "BYTE",
        forms: &[form("BYTE.name"), form("BYTE.(name+n)"), form("BYTE.number")],
        summary: text("Accesses the operand as 8 bits.", "Přistupuje k operandu jako k 8 bitům."),
        ..PREFIX
    },
    Entry {
        name: "WORD",
        forms: &[form("WORD.name"), form("WORD.(name+n)"), form("WORD.number")],
        summary: text("Accesses the operand as 16 bits.", "Přistupuje k operandu jako k 16 bitům."),
        ..PREFIX
    },
    Entry {
        name: "HIGH",
        forms: &[form("HIGH.name"), form("HIGH.(name+n)")],
        summary: text("Accesses the upper byte of a WORD.", "Přistupuje k horní slabice proměnné WORD."),
        ..PREFIX
    },
    Entry {
        name: "CNST",
        forms: &[form("CNST.number"), form("CNST.'c'"), form("CNST.real")],
        summary: text(
            "Makes the operand a direct constant, 32 bits wide.",
            "Označí operand jako přímou konstantu o šířce 32 bitů.",
        ),
        ..PREFIX
    },
    Entry {
        name: "DWRD",
        forms: &[form("DWRD.name"), form("DWRD.(name+n)"), form("DWRD.number")],
        summary: text(
            "Accesses the operand as 32 bits; after an instruction without operand it selects the 32-bit DR.",
            "Přistupuje k operandu jako k 32 bitům; u bezoperandových instrukcí volí 32bitový DR.",
        ),
        ..PREFIX
    },
    Entry {
        name: "QWRD",
        forms: &[form("QWRD.name"), form("QWRD.(name+n)")],
        summary: text(
            "Accesses the operand as 64 bits; after an instruction without operand it selects the 64-bit DR.",
            "Přistupuje k operandu jako k 64 bitům; u bezoperandových instrukcí volí 64bitový DR.",
        ),
        ..PREFIX
    },
    Entry {
        name: "BX",
        chapter: "3.5",
        forms: &[form("name[BX]"), form("(name[BX]+n)"), form("text+BX")],
        summary: text(
            "Index register: a byte offset added to an address at run time.",
            "Indexový registr: posun v bajtech, který se k adrese přičte za běhu.",
        ),
        ..KEYWORD
    },
    Entry {
        name: "NIL",
        chapter: "4.2",
        forms: &[form("TIM NIL, time"), form("TEX0 NIL, time, label")],
        summary: text(
            "Operand not given: the compiler creates an automatic counter (same as `-`).",
            "Operand není zadán: překladač si vytvoří automatický čítač (totéž co `-`).",
        ),
        ..KEYWORD
    },
    Entry {
        name: "GLOBAL",
        chapter: "3.15",
        forms: &[form("CLEAR GLOBAL, ALL")],
        summary: text(
            "With CLEAR: the global data of all files.",
            "U instrukce CLEAR: globální data všech souborů.",
        ),
        ..KEYWORD
    },
    Entry {
        name: "INTERNAL",
        chapter: "3.15",
        forms: &[form("CLEAR INTERNAL, ALL")],
        summary: text(
            "With CLEAR: the local data of all files, automatic variables included.",
            "U instrukce CLEAR: lokální data všech souborů včetně automatických proměnných.",
        ),
        ..KEYWORD
    },
    Entry {
        name: "ALL",
        chapter: "3.15",
        forms: &[form("CLEAR GLOBAL, ALL"), form("CLEAR INTERNAL, ALL")],
        summary: text("With CLEAR: the whole area.", "U instrukce CLEAR: celá oblast."),
        ..KEYWORD
    },
    Entry {
        name: "ON",
        chapter: "7.1",
        forms: &[form("DEBUG ON")],
        summary: text(
            "With DEBUG: begins the region that can be debugged.",
            "U direktivy DEBUG: začátek úseku, který lze ladit.",
        ),
        ..KEYWORD
    },
    Entry {
        name: "OFF",
        chapter: "7.1",
        forms: &[form("DEBUG OFF")],
        summary: text(
            "With DEBUG: ends the region that can be debugged.",
            "U direktivy DEBUG: konec úseku, který lze ladit.",
        ),
        ..KEYWORD
    },
];
