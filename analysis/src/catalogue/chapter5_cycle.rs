//! Chapter 5: data and the modules that run in cycles.

use super::entry::{Entry, Place};
use super::pattern::{STRUCTURE, example, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DATA",
        chapter: "5.2",
        forms: &[form("DATA")],
        place: Place::FileLevel,
        summary: text("Begins the global data of the file.", "Začátek globálních dat souboru."),
        description: text(
            "The first module of every source file, once in each; only comments, T_INCLUDE, macros, EQUI \
             and DEBUG may stand before it (this implementation). It holds DFM and DS; its names are \
             known in all files, and the debugger shows them.",
            "První modul každého zdrojového souboru, v každém jednou; před ním smějí stát jen komentáře, \
             T_INCLUDE, makra, EQUI a DEBUG (tato implementace). Obsahuje DFM a DS; jména platí ve všech \
             souborech a ladění je zobrazuje.",
        ),
        examples: &[example(
            concat!("DATA\n", "INPUTS: DFM DOOR_SHUT,OIL_OK\n", "PARTS:  DS 2\n", "DATA_END"),
            "Two bits and a WORD for the whole project.",
            "Dva bity a WORD pro celý projekt.",
        )],
        related: &["DATA_END", "DATA_LOCAL", "DFM", "DS"],
        ..STRUCTURE
    },
    Entry {
        name: "DATA_END",
        chapter: "5.2",
        forms: &[form("DATA_END")],
        place: Place::FileLevel,
        summary: text("Ends DATA.", "Konec modulu DATA."),
        description: text(
            "Closes DATA. Code may not stand between DATA and this line.",
            "Uzavírá DATA. Mezi DATA a tímto řádkem nesmí stát výkonné instrukce.",
        ),
        examples: &[example(
            concat!("DATA\n", "INPUTS: DFM DOOR_SHUT,OIL_OK\n", "PARTS:  DS 2\n", "DATA_END"),
            "Two bits and a WORD for the whole project.",
            "Dva bity a WORD pro celý projekt.",
        )],
        related: &["DATA"],
        ..STRUCTURE
    },
    Entry {
        name: "DATA_LOCAL",
        chapter: "5.2",
        forms: &[form("DATA_LOCAL")],
        place: Place::FileLevelOrModule,
        summary: text("Begins data that only this file sees.", "Začátek dat, která vidí jen tento soubor."),
        description: text(
            "Optional and repeatable; it may also stand inside another module, next to the code that \
             uses it. Its names are known only in this file, so other files may use the same ones. The \
             compiler puts its automatic variables (counters of TM, TIM, TEX) here too. The debugger \
             shows local data per file (this implementation).",
            "Nepovinný a opakovatelný; smí stát i uvnitř jiného modulu, hned u kódu, který data používá. \
             Jména platí jen v tomto souboru, jiné soubory tedy mohou mít stejná. Překladač sem ukládá i \
             automatické proměnné (čítače TM, TIM, TEX). Ladění zobrazuje lokální data podle souborů \
             (tato implementace).",
        ),
        examples: &[example(
            concat!("DATA_LOCAL\n", "STEP:   DS 1\n", "DATA_LOCAL_END"),
            "A BYTE that only this file sees.",
            "BYTE, který vidí jen tento soubor.",
        )],
        related: &["DATA_LOCAL_END", "DATA"],
        ..STRUCTURE
    },
    Entry {
        name: "DATA_LOCAL_END",
        chapter: "5.2",
        forms: &[form("DATA_LOCAL_END")],
        place: Place::FileLevelOrModule,
        summary: text("Ends DATA_LOCAL.", "Konec modulu DATA_LOCAL."),
        description: text(
            "Closes DATA_LOCAL. Code may not stand between DATA_LOCAL and this line.",
            "Uzavírá DATA_LOCAL. Mezi DATA_LOCAL a tímto řádkem nesmí stát výkonné instrukce.",
        ),
        examples: &[example(
            concat!("DATA_LOCAL\n", "STEP:   DS 1\n", "DATA_LOCAL_END"),
            "A BYTE that only this file sees.",
            "BYTE, který vidí jen tento soubor.",
        )],
        related: &["DATA_LOCAL"],
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
        description: text(
            "Runs first in every cycle of 20 ms, after the inputs were copied. Here the ports are read \
             into named bits and changed where needed. Mandatory in the first file, forbidden in others; \
             EX-type instructions may not stand here.",
            "Provádí se jako první v každém cyklu 20 ms, po přečtení vstupů. Čtou se v něm porty do \
             pojmenovaných bitů a podle potřeby se upravují. V prvním souboru povinný, v dalších \
             zakázaný; instrukce typu EX tu stát nesmějí.",
        ),
        examples: &[example(
            concat!("MODULE_INPUT\n", "        LOD  P1IN\n", "        STO  INPUTS\n", "MODULE_INPUT_END"),
            "Takes the first input port into own bits.",
            "Převezme první vstupní port do vlastních bitů.",
        )],
        related: &["MODULE_INPUT_END", "MODULE_MAIN"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_INPUT_END",
        chapter: "5.2",
        forms: &[form("MODULE_INPUT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_INPUT.", "Konec modulu MODULE_INPUT."),
        description: text(
            "Closes MODULE_INPUT. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_INPUT. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!("MODULE_INPUT\n", "        LOD  P1IN\n", "        STO  INPUTS\n", "MODULE_INPUT_END"),
            "Takes the first input port into own bits.",
            "Převezme první vstupní port do vlastních bitů.",
        )],
        related: &["MODULE_INPUT"],
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
        description: text(
            "Runs after a block of the part program has started, before its motion: spindle, clamping, \
             tool change. It behaves like a mechanism: EX-type instructions may stand directly in it, \
             and a wait is checked again once in each cycle of 20 ms. Mandatory in the first file, \
             forbidden in others. A pure motion block should pass it in one go, so keep every wait \
             behind a conditional jump; a lint reports others.",
            "Provádí se po startu bloku partprogramu před jeho pohybem: vřeteno, upnutí, výměna \
             nástroje. Chová se jako mechanismus: instrukce typu EX smějí stát přímo v něm a čekání se \
             znovu vyhodnocuje jednou za cyklus 20 ms. V prvním souboru povinný, v dalších zakázaný. \
             Čistě pohybový blok jím má projít najednou, každé čekání proto patří za podmíněný skok; na \
             jiné upozorní kontrola.",
        ),
        examples: &[example(
            concat!(
                "MODULE_BLOCK_INIT\n",
                "        LDR  M06PID\n",
                "        JL0  NO_CHANGE\n",
                "        FL   1,TOOL_CHANGE\n",
                "        EX\n",
                "        LDR  TOOL_CHANGE\n",
                "        EX1\n",
                "NO_CHANGE:\n",
                "MODULE_BLOCK_INIT_END"
            ),
            "Starts a mechanism at M06 and waits until it has finished.",
            "Při M06 spustí mechanismus a čeká, až skončí.",
        )],
        related: &["MODULE_BLOCK_INIT_END", "MODULE_BLOCK_DONE", "EX0", "MECH_BEGIN"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_INIT_END",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_INIT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_BLOCK_INIT.", "Konec modulu MODULE_BLOCK_INIT."),
        description: text(
            "Closes MODULE_BLOCK_INIT. The stack must be balanced and no equation open; otherwise an \
             error names the LDR that was not consumed.",
            "Uzavírá modul MODULE_BLOCK_INIT. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; \
             jinak chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_BLOCK_INIT\n",
                "        LDR  M06PID\n",
                "        JL0  NO_CHANGE\n",
                "        FL   1,TOOL_CHANGE\n",
                "        EX\n",
                "        LDR  TOOL_CHANGE\n",
                "        EX1\n",
                "NO_CHANGE:\n",
                "MODULE_BLOCK_INIT_END"
            ),
            "Starts a mechanism at M06 and waits until it has finished.",
            "Při M06 spustí mechanismus a čeká, až skončí.",
        )],
        related: &["MODULE_BLOCK_INIT"],
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
        description: text(
            "Runs after the motion of a block: spindle stop, coolant off, unclamping. It behaves like a \
             mechanism: EX-type instructions may stand directly in it, and a wait is checked again once \
             in each cycle of 20 ms. Mandatory in the first file, forbidden in others. A pure motion \
             block should pass it in one go, so keep every wait behind a conditional jump; a lint \
             reports others.",
            "Provádí se po pohybu bloku: zastavení vřetene, vypnutí chlazení, uvolnění. Chová se jako \
             mechanismus: instrukce typu EX smějí stát přímo v něm a čekání se znovu vyhodnocuje jednou \
             za cyklus 20 ms. V prvním souboru povinný, v dalších zakázaný. Čistě pohybový blok jím má \
             projít najednou, každé čekání proto patří za podmíněný skok; na jiné upozorní kontrola.",
        ),
        examples: &[example(
            concat!(
                "MODULE_BLOCK_DONE\n",
                "        LDR  M30_PID\n",
                "        FL1  0,COOLANT\n",
                "MODULE_BLOCK_DONE_END"
            ),
            "Switches the coolant off at the end of the program.",
            "Na konci programu vypne chlazení.",
        )],
        related: &["MODULE_BLOCK_DONE_END", "MODULE_BLOCK_INIT"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_BLOCK_DONE_END",
        chapter: "5.2",
        forms: &[form("MODULE_BLOCK_DONE_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_BLOCK_DONE.", "Konec modulu MODULE_BLOCK_DONE."),
        description: text(
            "Closes MODULE_BLOCK_DONE. The stack must be balanced and no equation open; otherwise an \
             error names the LDR that was not consumed.",
            "Uzavírá modul MODULE_BLOCK_DONE. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; \
             jinak chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_BLOCK_DONE\n",
                "        LDR  M30_PID\n",
                "        FL1  0,COOLANT\n",
                "MODULE_BLOCK_DONE_END"
            ),
            "Switches the coolant off at the end of the program.",
            "Na konci programu vypne chlazení.",
        )],
        related: &["MODULE_BLOCK_DONE"],
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
        description: text(
            "Runs in every cycle of 20 ms and holds the permanent logic, the mechanisms and the \
             procedures; the outputs are copied to the machine after it. Mandatory in every file; the \
             modules of further files run behind it in the order of the project. EX-type instructions \
             may stand only inside mechanisms.",
            "Provádí se v každém cyklu 20 ms a obsahuje trvalou logiku, mechanismy a procedury; po něm \
             se výstupy přenesou na stroj. Povinný v každém souboru; moduly dalších souborů se provádějí \
             za ním v pořadí podle projektu. Instrukce typu EX smějí stát jen uvnitř mechanismů.",
        ),
        examples: &[example(
            concat!(
                "MODULE_MAIN\n",
                "        LDR  DOOR_SHUT\n",
                "        LA   OIL_OK\n",
                "        WR   READY\n",
                "        LOD  OUTPUTS\n",
                "        STO  P0OUT\n",
                "MODULE_MAIN_END"
            ),
            "Logic, then the outputs.",
            "Logika a nakonec výstupy.",
        )],
        related: &["MODULE_MAIN_END", "MODULE_INPUT", "MECH_BEGIN", "PROC_BEGIN"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_MAIN_END",
        chapter: "5.2",
        forms: &[form("MODULE_MAIN_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_MAIN.", "Konec modulu MODULE_MAIN."),
        description: text(
            "Closes MODULE_MAIN. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_MAIN. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_MAIN\n",
                "        LDR  DOOR_SHUT\n",
                "        LA   OIL_OK\n",
                "        WR   READY\n",
                "        LOD  OUTPUTS\n",
                "        STO  P0OUT\n",
                "MODULE_MAIN_END"
            ),
            "Logic, then the outputs.",
            "Logika a nakonec výstupy.",
        )],
        related: &["MODULE_MAIN"],
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
        description: text(
            "Runs every millisecond, in step with the position loop. Optional, in any file. Mechanisms \
             may stand here; TIM and TEX then count milliseconds. Break-points are not possible, \
             registers can be traced. A pass over 1 ms is reported (this implementation).",
            "Provádí se každou milisekundu ve stejném rytmu jako polohová smyčka. Nepovinný, v \
             kterémkoli souboru. Smějí tu stát mechanismy; TIM a TEX pak čítají milisekundy. Breakpointy \
             nejsou možné, registry sledovat lze. Průchod delší než 1 ms se ohlásí (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_FAST\n",
                "        EDGE_H ENCODER\n",
                "        JL0  NO_PULSE\n",
                "        LOD  PULSES\n",
                "        INR\n",
                "        STO  PULSES\n",
                "NO_PULSE:\n",
                "MODULE_FAST_END"
            ),
            "Counts pulses too short for 20 ms.",
            "Čítá pulzy příliš krátké pro 20 ms.",
        )],
        related: &["MODULE_FAST_END", "MODULE_MAIN", "MODULE_CONT"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_FAST_END",
        chapter: "5.2",
        forms: &[form("MODULE_FAST_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_FAST.", "Konec modulu MODULE_FAST."),
        description: text(
            "Closes MODULE_FAST. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_FAST. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!(
                "MODULE_FAST\n",
                "        EDGE_H ENCODER\n",
                "        JL0  NO_PULSE\n",
                "        LOD  PULSES\n",
                "        INR\n",
                "        STO  PULSES\n",
                "NO_PULSE:\n",
                "MODULE_FAST_END"
            ),
            "Counts pulses too short for 20 ms.",
            "Čítá pulzy příliš krátké pro 20 ms.",
        )],
        related: &["MODULE_FAST"],
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
        description: text(
            "Runs every 20 ms and goes on while the debugger holds the other modules, for functions of \
             the machine that must not stop. Optional, only in the first file. Break-points are not \
             possible.",
            "Provádí se každých 20 ms a běží dál, i když ladění ostatní moduly drží; je určen pro \
             životně důležité funkce stroje. Nepovinný, jen v prvním souboru. Breakpointy nejsou možné.",
        ),
        examples: &[example(
            concat!("MODULE_CONT\n", "        LDR  ESTOP\n", "        FL1  0,DRIVE_ON\n", "MODULE_CONT_END"),
            "The emergency stop works also at a break-point.",
            "Nouzové zastavení funguje i na breakpointu.",
        )],
        related: &["MODULE_CONT_END", "MODULE_FAST", "DEBUG"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CONT_END",
        chapter: "5.2",
        forms: &[form("MODULE_CONT_END")],
        place: Place::FileLevel,
        summary: text("Ends MODULE_CONT.", "Konec modulu MODULE_CONT."),
        description: text(
            "Closes MODULE_CONT. The stack must be balanced and no equation open; otherwise an error \
             names the LDR that was not consumed.",
            "Uzavírá modul MODULE_CONT. Zásobník musí být vyvážený a žádná rovnice rozpracovaná; jinak \
             chyba ukáže na LDR, které nikdo nevybral.",
        ),
        examples: &[example(
            concat!("MODULE_CONT\n", "        LDR  ESTOP\n", "        FL1  0,DRIVE_ON\n", "MODULE_CONT_END"),
            "The emergency stop works also at a break-point.",
            "Nouzové zastavení funguje i na breakpointu.",
        )],
        related: &["MODULE_CONT"],
        ..STRUCTURE
    },
];
