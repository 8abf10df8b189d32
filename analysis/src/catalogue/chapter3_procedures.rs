//! Chapter 3.17: procedures, and those that the system calls.

use super::entry::{Effect, Entry, OperandKind, Place};
use super::pattern::{EVENT_PROCEDURE, INSTRUCTION, STRUCTURE, example, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "PROC_BEGIN",
        chapter: "3.17",
        forms: &[form("PROC_BEGIN name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: true },
            "Name of the procedure",
            "Jméno procedury",
        )],
        place: Place::Main,
        summary: text("Begins the definition of a procedure.", "Začátek definice procedury."),
        description: text(
            "Begins a procedure, which stands in MODULE_MAIN of any file. The normal run of MODULE_MAIN \
             skips its body; it runs only by PROC_CALL. The name is known in all files.\n\n\
             A procedure may not hold EX-type instructions, call itself, directly or through others, nor \
             contain another procedure or a mechanism (this implementation). The names `_ON_ESET`, \
             `_ON_CMD` and `_ON_EVENT` belong to procedures that the system calls.",
            "Začíná procedura, která stojí v modulu MODULE_MAIN kteréhokoli souboru. Běžný průchod \
             modulem její tělo přeskočí; provádí se jen voláním PROC_CALL. Jméno platí ve všech \
             souborech.\n\n\
             Procedura nesmí obsahovat instrukce typu EX, volat sama sebe, přímo ani přes jiné, a nesmí \
             v ní být jiná procedura ani mechanismus (tato implementace). Jména `_ON_ESET`, `_ON_CMD` a \
             `_ON_EVENT` patří procedurám, které volá systém.",
        ),
        examples: &[example(
            concat!(
                "        PROC_BEGIN LAMPS_OFF\n",
                "        FL   0,LAMP_A,LAMP_B\n",
                "        PROC_END LAMPS_OFF"
            ),
            "A procedure that clears two bits.",
            "Procedura, která vynuluje dva bity.",
        )],
        related: &["PROC_END", "PROC_CALL", "_ON_ESET"],
        ..STRUCTURE
    },
    Entry {
        name: "PROC_END",
        chapter: "3.17",
        forms: &[form("PROC_END name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: false },
            "The name given at PROC_BEGIN",
            "Jméno uvedené u PROC_BEGIN",
        )],
        place: Place::Main,
        summary: text(
            "Ends a procedure and returns to its caller.",
            "Konec procedury a návrat za místo volání.",
        ),
        description: text(
            "Names the procedure opened by PROC_BEGIN. Reaching it returns behind the PROC_CALL. The \
             stack must be balanced here (this implementation).",
            "Uvádí jméno procedury otevřené pomocí PROC_BEGIN. Po jeho dosažení se program vrátí za \
             PROC_CALL. Zásobník tu musí být vyvážený (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        PROC_BEGIN LAMPS_OFF\n",
                "        FL   0,LAMP_A,LAMP_B\n",
                "        PROC_END LAMPS_OFF"
            ),
            "The names at both ends agree.",
            "Jména na obou koncích se shodují.",
        )],
        related: &["PROC_BEGIN", "PROC_CALL"],
        ..STRUCTURE
    },
    Entry {
        name: "PROC_CALL",
        chapter: "3.17",
        forms: &[form("PROC_CALL name")],
        operands: &[operand(
            "name",
            OperandKind::Procedure { declares: false },
            "Procedure of any file",
            "Procedura z kteréhokoli souboru",
        )],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::DrReal, Effect::Memory],
        summary: text("Calls a procedure.", "Zavolá proceduru."),
        description: text(
            "Runs the procedure and goes on with the next line. RLO, DR and DR_REAL pass in and out, so \
             they serve as parameters and results. The call may stand in any module, mechanism or \
             procedure of any file; keep no equation open across it, a warning tells.",
            "Provede proceduru a pokračuje dalším řádkem. RLO, DR a DR_REAL se předávají dovnitř i ven, \
             slouží tedy jako parametry a výsledky. Volání může stát v kterémkoli modulu, mechanismu \
             nebo proceduře libovolného souboru; rovnice přes ně nemá zůstat rozpracovaná, upozorní na \
             to varování.",
        ),
        examples: &[example(
            concat!("        LOD  TOOL\n", "        PROC_CALL FIND_POCKET\n", "        STO  POCKET"),
            "The number of the tool goes in by DR, the pocket comes back.",
            "Číslo nástroje se předá v DR a vrátí se v něm lůžko.",
        )],
        related: &["PROC_BEGIN", "PROC_END"],
        ..INSTRUCTION
    },
    Entry {
        name: "_ON_ESET",
        forms: &[form("PROC_BEGIN _ON_ESET")],
        reads: &[Effect::Dr],
        summary: text(
            "Procedure that every message of ESET, ESET1 calls, with its number in DR.",
            "Procedura, kterou volá každé hlášení ESET, ESET1; v DR je číslo hlášení.",
        ),
        description: text(
            "Optional. When a procedure of this name stands in any file, every ESET and ESET1 that \
             reports a message calls it, with the number of the message in DR. It runs inside the \
             instruction; the reporting program goes on with the RLO and DR it had (this implementation).",
            "Nepovinná. Existuje-li v některém souboru procedura tohoto jména, volá ji každá instrukce \
             ESET a ESET1, která vydá hlášení; v DR je jeho číslo. Provádí se uvnitř instrukce; \
             program po hlášení pokračuje s RLO a DR, které měl (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        PROC_BEGIN _ON_ESET\n",
                "        STO  WORD.LAST_MESSAGE\n",
                "        FL   1,HORN\n",
                "        PROC_END _ON_ESET"
            ),
            "Keeps the last message and sounds the horn.",
            "Zapamatuje si poslední hlášení a zapne houkačku.",
        )],
        related: &["ESET", "ESET1", "PROC_BEGIN"],
        ..EVENT_PROCEDURE
    },
    Entry {
        name: "_ON_CMD",
        forms: &[form("PROC_BEGIN _ON_CMD")],
        reads: &[Effect::Rlo, Effect::Dr],
        summary: text(
            "Procedure called when a configured key or soft-menu is pressed or released.",
            "Procedura volaná při stisku a uvolnění nakonfigurované klávesy nebo softwarového menu.",
        ),
        description: text(
            "Optional. The system calls it when a key or soft-menu that the configuration joins to the \
             PLC is pressed (RLO = 1) or released (RLO = 0); DR holds the code of the command as 32 \
             bits.",
            "Nepovinná. Systém ji volá, když se stiskne (RLO = 1) nebo uvolní (RLO = 0) klávesa či \
             softwarové menu, které konfigurace přiřazuje PLC; DR obsahuje kód povelu na 32 bitech.",
        ),
        examples: &[example(
            concat!(
                "        PROC_BEGIN _ON_CMD\n",
                "        EQ1  CMD_LIGHT\n",
                "        FL1  1,LIGHT\n",
                "        PROC_END _ON_CMD"
            ),
            "Pressing the key CMD_LIGHT switches the light on.",
            "Stisk klávesy CMD_LIGHT rozsvítí světlo.",
        )],
        related: &["_ON_EVENT", "PROC_BEGIN"],
        ..EVENT_PROCEDURE
    },
    Entry {
        name: "_ON_EVENT",
        forms: &[form("PROC_BEGIN _ON_EVENT")],
        reads: &[Effect::Dr],
        summary: text(
            "Procedure called at selected events of the system, with the event in DR.",
            "Procedura volaná při vybraných událostech systému; v DR je kód události.",
        ),
        description: text(
            "Optional. The system calls it at the request and at the execution of a start and a stop; DR \
             holds the event as 32 bits, one of PLCEVENT_STOP_REQ (1), PLCEVENT_STOP_EMERGENCY_REQ (2), \
             PLCEVENT_STOP (3), PLCEVENT_START (4), PLCEVENT_START_REQ (5), in this numbering (this \
             implementation). At PLCEVENT_START_REQ the program may set START_SUSPEND and let the start \
             go on later.",
            "Nepovinná. Systém ji volá při žádosti o start a stop a při jejich provedení; DR obsahuje \
             událost na 32 bitech, a to PLCEVENT_STOP_REQ (1), PLCEVENT_STOP_EMERGENCY_REQ (2), \
             PLCEVENT_STOP (3), PLCEVENT_START (4) nebo PLCEVENT_START_REQ (5), v tomto číslování (tato \
             implementace). Při PLCEVENT_START_REQ smí program nastavit START_SUSPEND a start pustit až \
             později.",
        ),
        examples: &[example(
            concat!(
                "        PROC_BEGIN _ON_EVENT\n",
                "        EQ   PLCEVENT_START_REQ\n",
                "        FL1  1,START_SUSPEND,WARM_UP\n",
                "        PROC_END _ON_EVENT"
            ),
            "Holds the start and starts a mechanism that clears START_SUSPEND at its end.",
            "Pozdrží start a spustí mechanismus, který START_SUSPEND na svém konci vynuluje.",
        )],
        related: &["_ON_CMD", "PROC_BEGIN"],
        ..EVENT_PROCEDURE
    },
];
