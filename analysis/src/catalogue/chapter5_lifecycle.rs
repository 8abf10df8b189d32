//! Chapter 5: the modules that run once, and the end of the program.

use super::entry::{Effect, Entry, Place};
use super::pattern::{INSTRUCTION, STRUCTURE, example, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MODULE_INIT",
        chapter: "5.2",
        forms: &[form("MODULE_INIT")],
        place: Place::FileLevel,
        summary: text(
            "Begins the module run once when the PLC program starts.",
            "Začátek modulu, který se provede jednou při startu PLC programu.",
        ),
        description: text(
            "One pass when the PLC program starts. DR is 0 after power-on and 1 after the command START \
             PLC. Mandatory in the first file, optional in others; all run in the order of the files. \
             Longer work belongs to a mechanism started here that ends by MODULE_INIT_FINISHED. EX-type \
             instructions may not stand here.",
            "Jeden průchod při startu PLC programu. DR je 0 po zapnutí a 1 po povelu START PLC. V prvním \
             souboru povinný, v dalších nepovinný; provedou se všechny v pořadí souborů. Delší činnost \
             patří do mechanismu, který se odtud spustí a končí instrukcí MODULE_INIT_FINISHED. \
             Instrukce typu EX tu stát nesmějí.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MECH_INIT CLAMPING\n",
                "        FL   1,WARM_UP\n",
                "MODULE_INIT_END"
            ),
            "Rests one mechanism and starts another.",
            "Jeden mechanismus uvede do klidu a druhý spustí.",
        )],
        related: &["MODULE_INIT_END", "MODULE_INIT_FINISHED", "MODULE_DONE"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INIT_END",
        chapter: "5.2",
        forms: &[form("MODULE_INIT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_INIT.", "Konec modulu MODULE_INIT."),
        description: text(
            "Closes MODULE_INIT. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_INIT. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MECH_INIT CLAMPING\n",
                "        FL   1,WARM_UP\n",
                "MODULE_INIT_END"
            ),
            "Rests one mechanism and starts another.",
            "Jeden mechanismus uvede do klidu a druhý spustí.",
        )],
        related: &["MODULE_INIT"],
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
        description: text(
            "One pass when the PLC program stops. DR is 0 when the system is switched off and 1 after \
             the command STOP PLC. Optional in every file. Longer work belongs to a mechanism that ends \
             by MODULE_DONE_FINISHED. EX-type instructions may not stand here.",
            "Jeden průchod při ukončení PLC programu. DR je 0 při vypínání systému a 1 po povelu STOP \
             PLC. V každém souboru nepovinný. Delší činnost patří do mechanismu, který končí instrukcí \
             MODULE_DONE_FINISHED. Instrukce typu EX tu stát nesmějí.",
        ),
        examples: &[example(
            concat!("MODULE_DONE\n", "        FL   1,PARKING\n", "MODULE_DONE_END"),
            "Starts a mechanism that parks the machine.",
            "Spustí mechanismus, který stroj zaparkuje.",
        )],
        related: &["MODULE_DONE_END", "MODULE_DONE_FINISHED", "MODULE_INIT"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_DONE_END",
        chapter: "5.2",
        forms: &[form("MODULE_DONE_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_DONE.", "Konec modulu MODULE_DONE."),
        description: text(
            "Closes MODULE_DONE. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_DONE. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!("MODULE_DONE\n", "        FL   1,PARKING\n", "MODULE_DONE_END"),
            "Starts a mechanism that parks the machine.",
            "Spustí mechanismus, který stroj zaparkuje.",
        )],
        related: &["MODULE_DONE"],
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
        description: text(
            "One pass on the command to clear the PLC and at no other time. Mandatory in the first file, \
             optional in others. The usual content is CLEAR. EX-type instructions may not stand here.",
            "Jeden průchod na povel k nulování PLC a v žádném jiném případě. V prvním souboru povinný, v \
             dalších nepovinný. Obvyklým obsahem je CLEAR. Instrukce typu EX tu stát nesmějí.",
        ),
        examples: &[example(
            concat!(
                "MODULE_CLEAR\n",
                "        CLEAR GLOBAL,ALL\n",
                "        CLEAR INTERNAL,ALL\n",
                "MODULE_CLEAR_END"
            ),
            "Clears all data.",
            "Vynuluje všechna data.",
        )],
        related: &["MODULE_CLEAR_END", "CLEAR"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CLEAR_END",
        chapter: "5.2",
        forms: &[form("MODULE_CLEAR_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_CLEAR.", "Konec modulu MODULE_CLEAR."),
        description: text(
            "Closes MODULE_CLEAR. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_CLEAR. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_CLEAR\n",
                "        CLEAR GLOBAL,ALL\n",
                "        CLEAR INTERNAL,ALL\n",
                "MODULE_CLEAR_END"
            ),
            "Clears all data.",
            "Vynuluje všechna data.",
        )],
        related: &["MODULE_CLEAR"],
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
        description: text(
            "One pass at a fatal error, before the system stops; the outputs it writes are still copied. \
             Switch the power part off here. Mandatory in the first file, forbidden in others. EX-type \
             instructions may not stand here.",
            "Jeden průchod při fatální chybě, než se systém zastaví; zapsané výstupy se ještě přenesou. \
             Vypíná se v něm silová část. V prvním souboru povinný, v dalších zakázaný. Instrukce typu \
             EX tu stát nesmějí.",
        ),
        examples: &[example(
            concat!("MODULE_HALT\n", "        LOD  CNST.0\n", "        STO  P0OUT\n", "MODULE_HALT_END"),
            "Clears the outputs of the first unit.",
            "Vynuluje výstupy první jednotky.",
        )],
        related: &["MODULE_HALT_END", "MODULE_DONE"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_HALT_END",
        chapter: "5.2",
        forms: &[form("MODULE_HALT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_HALT.", "Konec modulu MODULE_HALT."),
        description: text(
            "Closes MODULE_HALT. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_HALT. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!("MODULE_HALT\n", "        LOD  CNST.0\n", "        STO  P0OUT\n", "MODULE_HALT_END"),
            "Clears the outputs of the first unit.",
            "Vynuluje výstupy první jednotky.",
        )],
        related: &["MODULE_HALT"],
        ..STRUCTURE
    },
    Entry {
        name: "STOP",
        chapter: "5.1",
        forms: &[form("STOP")],
        summary: text("Ends the first source file.", "Konec prvního zdrojového souboru."),
        description: text(
            "Stands alone on the line behind the last module of the first file; only comments may \
             follow. In further files it is optional (this implementation).",
            "Stojí samotné na řádku za posledním modulem prvního souboru; následovat smějí jen \
             komentáře. V dalších souborech je nepovinné (tato implementace).",
        ),
        examples: &[example(
            concat!("MODULE_HALT\n", "MODULE_HALT_END\n", "STOP"),
            "The end of the first file.",
            "Konec prvního souboru.",
        )],
        related: &["DATA", "MODULE_MAIN"],
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
        description: text(
            "Optional. Without it the start is over with the pass of MODULE_INIT. When it stands \
             anywhere in a file, the system waits until one of its occurrences in that file has run, and \
             so for every file that has one. Usually it ends a mechanism in MODULE_MAIN that MODULE_INIT \
             has started. RLO and DR stay.",
            "Nepovinná. Bez ní start končí průchodem modulem MODULE_INIT. Je-li kdekoli v souboru \
             uvedena, systém čeká, dokud se některý její výskyt v tomto souboru neprovede, a to u \
             každého souboru, který ji obsahuje. Obvykle zakončuje mechanismus v MODULE_MAIN, který \
             MODULE_INIT spustil. RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN WARM_UP\n",
                "        LDR  DRIVES_READY\n",
                "        EX0\n",
                "        MODULE_INIT_FINISHED\n",
                "        MECH_END WARM_UP"
            ),
            "The start waits for the drives.",
            "Start čeká na pohony.",
        )],
        related: &["MODULE_INIT", "MECH_BEGIN"],
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
        description: text(
            "Optional. Without it the stop is over with the pass of MODULE_DONE. When it stands anywhere \
             in a file, the system waits until one of its occurrences in that file has run, and so for \
             every file that has one. Usually it ends a mechanism in MODULE_MAIN that MODULE_DONE has \
             started. RLO and DR stay.",
            "Nepovinná. Bez ní ukončení končí průchodem modulem MODULE_DONE. Je-li kdekoli v souboru \
             uvedena, systém čeká, dokud se některý její výskyt v tomto souboru neprovede, a to u \
             každého souboru, který ji obsahuje. Obvykle zakončuje mechanismus v MODULE_MAIN, který \
             MODULE_DONE spustil. RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN PARKING\n",
                "        LDR  AT_HOME\n",
                "        EX0\n",
                "        MODULE_DONE_FINISHED\n",
                "        MECH_END PARKING"
            ),
            "The stop waits until the machine is parked.",
            "Ukončení čeká, až stroj zaparkuje.",
        )],
        related: &["MODULE_DONE", "MECH_BEGIN"],
        ..INSTRUCTION
    },
];
