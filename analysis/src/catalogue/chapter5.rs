//! Chapter 5: the modules of a program.

use super::entry::{Effect, Entry, Place};
use super::pattern::{INSTRUCTION, STRUCTURE, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DATA",
        chapter: "5.2",
        forms: &[form("DATA")],
        place: Place::FileLevel,
        summary: text("Begins the global data of the file.", "Začátek globálních dat souboru."),
        ..STRUCTURE
    },
    Entry {
        name: "DATA_END",
        chapter: "5.2",
        forms: &[form("DATA_END")],
        place: Place::FileLevel,
        summary: text("Ends DATA.", "Konec modulu DATA."),
        ..STRUCTURE
    },
    Entry {
        name: "DATA_LOCAL",
        chapter: "5.2",
        forms: &[form("DATA_LOCAL")],
        place: Place::FileLevelOrModule,
        summary: text("Begins data that only this file sees.", "Začátek dat, která vidí jen tento soubor."),
        ..STRUCTURE
    },
    Entry {
        name: "DATA_LOCAL_END",
        chapter: "5.2",
        forms: &[form("DATA_LOCAL_END")],
        place: Place::FileLevelOrModule,
        summary: text("Ends DATA_LOCAL.", "Konec modulu DATA_LOCAL."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INPUT",
        chapter: "5.2",
        forms: &[form("MODULE_INPUT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module that runs first in every cycle and reads the inputs.",
            "Začátek modulu, který se provádí jako první v každém cyklu a čte vstupy.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INPUT_END",
        chapter: "5.2",
        forms: &[form("MODULE_INPUT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_INPUT.", "Konec modulu MODULE_INPUT."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_INIT",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_INIT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the preparatory functions of a block, run as a sequence.",
            "Začátek přípravných funkcí bloku; modul běží jako sekvence.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_INIT_END",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_INIT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_BLOCK_INIT.", "Konec modulu MODULE_BLOCK_INIT."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_DONE",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_DONE")],
        place: Place::FileLevel,
        summary: text(
            "Begins the closing functions of a block, run as a sequence.",
            "Začátek závěrečných funkcí bloku; modul běží jako sekvence.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_DONE_END",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_DONE_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_BLOCK_DONE.", "Konec modulu MODULE_BLOCK_DONE."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_MAIN",
        chapter: "5.2",
        forms: &[form("MODULE_MAIN")],
        place: Place::FileLevel,
        summary: text(
            "Begins the permanent logic of the machine, run every cycle.",
            "Začátek trvalé logiky stroje, která se provádí každý cyklus.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_MAIN_END",
        chapter: "5.2",
        forms: &[form("MODULE_MAIN_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_MAIN.", "Konec modulu MODULE_MAIN."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INIT",
        chapter: "5.2",
        forms: &[form("MODULE_INIT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module run once when the PLC program starts.",
            "Začátek modulu, který se provede jednou při startu PLC programu.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INIT_END",
        chapter: "5.2",
        forms: &[form("MODULE_INIT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_INIT.", "Konec modulu MODULE_INIT."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_DONE",
        chapter: "5.2",
        forms: &[form("MODULE_DONE")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module run once when the PLC program stops.",
            "Začátek modulu, který se provede jednou při ukončení PLC programu.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_DONE_END",
        chapter: "5.2",
        forms: &[form("MODULE_DONE_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_DONE.", "Konec modulu MODULE_DONE."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CLEAR",
        chapter: "5.2",
        forms: &[form("MODULE_CLEAR")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module run once on the command to clear the PLC.",
            "Začátek modulu, který se provede jednou na povel k nulování PLC.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CLEAR_END",
        chapter: "5.2",
        forms: &[form("MODULE_CLEAR_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_CLEAR.", "Konec modulu MODULE_CLEAR."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_HALT",
        chapter: "5.2",
        forms: &[form("MODULE_HALT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module run once at a fatal error of the system.",
            "Začátek modulu, který se provede jednou při fatální chybě systému.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_HALT_END",
        chapter: "5.2",
        forms: &[form("MODULE_HALT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_HALT.", "Konec modulu MODULE_HALT."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_FAST",
        chapter: "5.2",
        forms: &[form("MODULE_FAST")],
        place: Place::FileLevel,
        summary: text(
            "Begins the fast module, run every millisecond.",
            "Začátek rychlého modulu, který se provádí každou milisekundu.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_FAST_END",
        chapter: "5.2",
        forms: &[form("MODULE_FAST_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_FAST.", "Konec modulu MODULE_FAST."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CONT",
        chapter: "5.2",
        forms: &[form("MODULE_CONT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module that keeps running while the debugger holds the others.",
            "Začátek modulu, který běží dál, i když ladění ostatní moduly drží.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CONT_END",
        chapter: "5.2",
        forms: &[form("MODULE_CONT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_CONT.", "Konec modulu MODULE_CONT."),
        ..STRUCTURE
    },
    Entry {
        name: "STOP",
        chapter: "5.1",
        forms: &[form("STOP")],
        summary: text("Ends the first source file.", "Konec prvního zdrojového souboru."),
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INIT_FINISHED",
        chapter: "5.2",
        forms: &[form("MODULE_INIT_FINISHED")],
        writes: &[Effect::Memory],
        summary: text(
            "Reports that the initialisation of this file has ended.",
            "Ohlásí, že inicializace tohoto souboru skončila.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "MODULE_DONE_FINISHED",
        chapter: "5.2",
        forms: &[form("MODULE_DONE_FINISHED")],
        writes: &[Effect::Memory],
        summary: text(
            "Reports that the closing operations of this file have ended.",
            "Ohlásí, že závěrečné operace tohoto souboru skončily.",
        ),
        ..INSTRUCTION
    },
];
