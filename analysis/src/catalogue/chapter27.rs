//! Chapter 27: logical inputs and outputs, and the fastest modules.

use super::cell_type::CELL_TYPES;
use super::entry::{ConfigElement, Effect, Entry, NewCell, OperandKind, OperandSpec, Place};
use super::pattern::{INSTRUCTION, STRUCTURE, example, form, operand, text};

const fn identifier(element: ConfigElement) -> OperandSpec {
    operand(
        "id",
        OperandKind::Identifier(element),
        "Identifier without its group: a literal in apostrophes or the label of a STR",
        "Identifikátor bez skupiny: řetězec v apostrofech nebo návěští textu STR",
    )
}

const CELL: OperandSpec = operand(
    "cell",
    OperandKind::Declares(NewCell::Typed),
    "Name of the bit or cell, which this instruction declares; `name[n]` declares n elements",
    "Jméno bitu nebo buňky; deklaruje je sama tato instrukce; `jméno[n]` deklaruje n prvků",
);
const TYPE: OperandSpec = operand(
    "type",
    OperandKind::Keyword(CELL_TYPES),
    "Type of the cell, or of each element",
    "Typ buňky, nebo každého prvku",
);
const DEFAULT: OperandSpec = operand(
    "default",
    OperandKind::Constant,
    "Value while nothing is connected, for TYPE_REAL with a decimal point; without it 0",
    "Hodnota, dokud není nic připojeno, u TYPE_REAL s desetinnou tečkou; bez zadání 0",
)
.or_dash()
.or_nothing();
const PERIOD: OperandSpec = operand(
    "period",
    OperandKind::Keyword(&["SLOW", "FAST", "FASTEST", "ONDEMAND"]),
    "How often the connection is served; without it SLOW",
    "Jak často se spojení obsluhuje; bez zadání SLOW",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DEF_IN",
        chapter: "27.2",
        forms: &[
            form("DEF_IN cell, id, type"),
            form("DEF_IN cell, 'ID', type [,default] [,period]"),
            form("DEF_IN cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: &[CELL, identifier(ConfigElement::LogicalInput), TYPE, DEFAULT, PERIOD],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical input that the configuration links to its source.",
            "Deklaruje logický vstup, který konfigurace propojí se zdrojem.",
        ),
        description: text(
            "The cell is the destination `PLC.Input.ID` of a `Connection` in the ChannelConfig file; its source may \
             be a logical output, a CAN or EtherCAT unit or the control itself, and its value is converted to the \
             type. Dialogs may write it too. It must not be declared by DFM or DS; it is known in all files and is \
             shared without SHARE_VAR. Without a connection it keeps `default` or what the program writes.\n\n\
             An identifier has no group before it and no index behind it; indexes inside it, `Servo[8].Status`, are \
             part of the name, and `[0]` is the same as none. `cell[n]` is element n, counted from 0. A text of \
             TYPE_STR and a block of TYPE_BIN have 255 bytes, or n (this implementation). RLO and DR stay (this \
             implementation).\n\n\
             Converted to a shorter cell, an integer gives its low bits; a real is rounded, ties to even, and held \
             within the range of the cell; any number but 0 is 1 in a bit; between numbers and texts nothing is \
             converted (this implementation).",
            "Buňka je cílem `PLC.Input.ID` elementu `Connection` v souboru ChannelConfig; zdrojem může být logický \
             výstup, jednotka CAN nebo EtherCAT či sám systém a hodnota se převede na daný typ. Zapisovat do ní \
             mohou i dialogy. Nesmí být deklarována pomocí DFM ani DS; platí ve všech souborech a sdílí se i bez \
             SHARE_VAR. Bez spojení si drží `default` nebo to, co zapíše program.\n\n\
             Identifikátor nemá před sebou skupinu ani za sebou index; indexy uvnitř, `Servo[8].Status`, jsou \
             součástí jména a `[0]` je totéž co žádný. `cell[n]` je prvek n počítaný od 0. Text TYPE_STR a blok \
             TYPE_BIN mají 255 bajtů, nebo n (tato implementace). RLO ani DR se nemění (tato implementace).\n\n\
             Při převodu do kratší buňky se z celého čísla vezmou nejnižší bity; reálné číslo se zaokrouhlí, polovina \
             k sudému, a omezí na rozsah buňky; nenulové číslo je v bitu 1; mezi čísly a texty se nepřevádí (tato \
             implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        DEF_IN LASER_TOUCH,'Laser.BodyTouch',TYPE_BIT,-,FAST\n",
                "        DEF_IN LASER_GAP,'Laser.Gap',TYPE_REAL,1.5\n",
                "        DEF_IN SERVO_POS[3],'ServoPos',TYPE_INT_32\n",
                "MODULE_INIT_END\n",
                "MODULE_MAIN\n",
                "        LOD  SERVO_POS[2]\n",
                "        STO  LENGTH\n",
                "MODULE_MAIN_END"
            ),
            "A bit every millisecond, a REAL with a default, and an array of three.",
            "Bit každou milisekundu, REAL s náhradní hodnotou a pole tří prvků.",
        )],
        related: &["DEF_OUT", "UPDATE_IN", "MAP_IN", "TYPE_BIT", "SLOW"],
        ..INSTRUCTION
    },
    Entry {
        name: "DEF_OUT",
        chapter: "27.2",
        forms: &[
            form("DEF_OUT cell, id, type"),
            form("DEF_OUT cell, 'ID', type [,default] [,period]"),
            form("DEF_OUT cell[n], 'ID', type [,default] [,period]"),
        ],
        operands: &[CELL, identifier(ConfigElement::LogicalOutput), TYPE, DEFAULT, PERIOD],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a logical output that the configuration links to its targets.",
            "Deklaruje logický výstup, který konfigurace propojí s cíli.",
        ),
        description: text(
            "The cell is the source `PLC.Output.ID` of `Connection` elements in the ChannelConfig file, as many as \
             the configuration likes; each converts the value to the type of its destination. Everything else is as \
             for DEF_IN. With ONDEMAND the value is passed on when UPDATE_IN asks for it at the other end (this \
             implementation). RLO and DR stay (this implementation).",
            "Buňka je zdrojem `PLC.Output.ID` elementů `Connection` v souboru ChannelConfig, kolik jich konfigurace \
             určí; každý převede hodnotu na typ svého cíle. Vše ostatní je jako u DEF_IN. S ONDEMAND se hodnota \
             předá, až o ni na druhém konci požádá UPDATE_IN (tato implementace). RLO ani DR se nemění (tato \
             implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        DEF_OUT GATE_OPEN,'GateOpen',TYPE_BIT,1\n",
                "        DEF_OUT SERVO_CTRL,'ServoCtrl',TYPE_UNS_16,-,FAST\n",
                "MODULE_INIT_END"
            ),
            "A bit that begins as 1 and a control word served every millisecond.",
            "Bit, který začíná jako 1, a řídicí slovo obsluhované každou milisekundu.",
        )],
        related: &["DEF_IN", "MAP_OUT", "TYPE_UNS_16", "SLOW"],
        ..INSTRUCTION
    },
    Entry {
        name: "UPDATE_IN",
        chapter: "27.4",
        forms: &[form("UPDATE_IN cell"), form("UPDATE_IN cell[n]")],
        operands: &[operand(
            "cell",
            OperandKind::DeclaredElement,
            "Cell declared by DEF_IN; `name[n]` fetches one element, the name alone all of them",
            "Buňka deklarovaná pomocí DEF_IN; `jméno[n]` načte jeden prvek, samotné jméno všechny",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Fetches a logical input at once.", "Okamžitě načte logický vstup."),
        description: text(
            "Takes the present value of the connected source into the cell, so the program itself chooses the \
             moment. Meant for inputs with the period ONDEMAND, which nothing else fetches; for others it is \
             allowed and only comes earlier than their period (this implementation). RLO and DR stay (this \
             implementation).",
            "Převezme do buňky současnou hodnotu připojeného zdroje, okamžik tedy volí sám program. Je určena pro \
             vstupy s periodou ONDEMAND, které nic jiného nenačítá; u ostatních je dovolena a jen předběhne jejich \
             periodu (tato implementace). RLO ani DR se nemění (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        DEF_IN LASER_GAP,'Laser.Gap',TYPE_REAL,-,ONDEMAND\n",
                "        DEF_IN SERVO_POS[3],'ServoPos',TYPE_INT_32,-,ONDEMAND\n",
                "MODULE_INIT_END\n",
                "MODULE_MAIN\n",
                "        UPDATE_IN LASER_GAP\n",
                "        UPDATE_IN SERVO_POS[1]\n",
                "MODULE_MAIN_END"
            ),
            "A whole input and one element of an array.",
            "Celý vstup a jeden prvek pole.",
        )],
        related: &["DEF_IN", "ONDEMAND"],
        ..INSTRUCTION
    },
    Entry {
        name: "MODULE_CYCLICOPERATION",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION")],
        summary: text(
            "Begins the module run every millisecond before MODULE_FAST.",
            "Začátek modulu, který se provádí každou milisekundu před MODULE_FAST.",
        ),
        description: text(
            "Runs at the start of the 1 ms loop, before the position loop and MODULE_FAST. Connections with the \
             period FAST are served before it, and again between it and MODULE_FAST. Optional, in any file; it may \
             hold no mechanism, and no break-point is possible (this implementation).",
            "Provádí se na začátku smyčky 1 ms, před polohovou smyčkou a MODULE_FAST. Spojení s periodou FAST se \
             obsluhují před ním a znovu mezi ním a MODULE_FAST. Nepovinný, v kterémkoli souboru; nesmí obsahovat \
             mechanismus a breakpoint v něm nastavit nelze (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_CYCLICOPERATION\n",
                "        LDR  DOOR\n",
                "        WR   LAMP\n",
                "MODULE_CYCLICOPERATION_END"
            ),
            "Answers to DOOR within a millisecond.",
            "Reaguje na DOOR do jedné milisekundy.",
        )],
        related: &["MODULE_CYCLICOPERATION_END", "MODULE_FAST", "MODULE_FASTEST"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_CYCLICOPERATION_END",
        chapter: "27.8",
        forms: &[form("MODULE_CYCLICOPERATION_END")],
        summary: text("Ends MODULE_CYCLICOPERATION.", "Konec modulu MODULE_CYCLICOPERATION."),
        description: text(
            "The stack must be balanced here and no equation open (this implementation).",
            "Zásobník tu musí být vyvážený a žádná rovnice rozpracovaná (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "MODULE_CYCLICOPERATION\n",
                "        LDR  DOOR\n",
                "        WR   LAMP\n",
                "MODULE_CYCLICOPERATION_END"
            ),
            "The module ends on a line of its own.",
            "Modul končí na samostatném řádku.",
        )],
        related: &["MODULE_CYCLICOPERATION"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST")],
        summary: text(
            "Begins the fastest module, run every 100 to 1000 µs by the configuration.",
            "Začátek nejrychlejšího modulu, který se podle konfigurace provádí každých 100 až 1000 µs.",
        ),
        description: text(
            "Runs in the tick of the EtherCAT master: every 100, 200, 250, 500 or 1000 µs, 1000 by default (this \
             implementation). Connections with the period FASTEST are served right before and after it. Optional, \
             in any file; it may hold no mechanism, and no break-point is possible (this implementation). Keep it \
             as short as can be.",
            "Provádí se v taktu EtherCAT masteru: každých 100, 200, 250, 500 nebo 1000 µs, bez nastavení 1000 (tato \
             implementace). Spojení s periodou FASTEST se obsluhují těsně před ním a po něm. Nepovinný, v \
             kterémkoli souboru; nesmí obsahovat mechanismus a breakpoint v něm nastavit nelze (tato \
             implementace). Má být co nejkratší.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        DEF_IN LASER_TOUCH,'Laser.BodyTouch',TYPE_BIT,-,FASTEST\n",
                "        DEF_OUT LASER_STOP,'Laser.Stop',TYPE_BIT,0,FASTEST\n",
                "MODULE_INIT_END\n",
                "MODULE_FASTEST\n",
                "        LDR  LASER_TOUCH\n",
                "        WR   LASER_STOP\n",
                "MODULE_FASTEST_END"
            ),
            "Stops the laser in the same tick in which it touches.",
            "Zastaví laser v témže taktu, ve kterém se dotkne.",
        )],
        related: &["MODULE_FASTEST_END", "MODULE_FAST", "FASTEST"],
        ..STRUCTURE
    },
    Entry {
        name: "MODULE_FASTEST_END",
        chapter: "27.8",
        forms: &[form("MODULE_FASTEST_END")],
        summary: text("Ends MODULE_FASTEST.", "Konec modulu MODULE_FASTEST."),
        description: text(
            "The stack must be balanced here and no equation open (this implementation).",
            "Zásobník tu musí být vyvážený a žádná rovnice rozpracovaná (tato implementace).",
        ),
        examples: &[example(
            concat!("MODULE_FASTEST\n", "        LDR  DOOR\n", "        WR   LAMP\n", "MODULE_FASTEST_END"),
            "The module ends on a line of its own.",
            "Modul končí na samostatném řádku.",
        )],
        related: &["MODULE_FASTEST"],
        ..STRUCTURE
    },
];
