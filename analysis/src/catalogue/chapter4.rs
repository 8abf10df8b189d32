//! Chapter 4: mechanisms and the instructions that hold a sequence.

use super::entry::{Effect, Entry, OperandKind, OperandSpec, Place, Prefix, PrefixSet, TimeUnit};
use super::pattern::{INSTRUCTION, STRUCTURE, VALUES, WAITING, example, form, operand, source, text};

const COUNT: OperandSpec = operand(
    "count",
    OperandKind::AutoCounter,
    "BYTE or WORD counter; `-` or NIL makes an automatic one",
    "Čítač typu BYTE nebo WORD; `-` nebo NIL vytvoří automatický",
)
.or_dash();
const TIME: OperandSpec = operand(
    "time",
    OperandKind::Time,
    "Longest wait in cycles: number, EQUI constant, or BYTE or WORD cell",
    "Nejdelší čekání v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD",
);
const ERROR: OperandSpec = operand(
    "error",
    OperandKind::Label,
    "Label to continue at when the time runs out",
    "Návěští, na kterém se pokračuje po vypršení času",
);
const CODE: OperandSpec = operand(
    "code",
    source(PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Cnst, Prefix::Dwrd]), VALUES),
    "Value left in DR at that jump, usually the number of a message",
    "Hodnota, která při tomto skoku zůstane v DR, obvykle číslo hlášení",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MECH_BEGIN",
        chapter: "4.2",
        forms: &[form("MECH_BEGIN mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: true },
            "Name of the mechanism and of its activation bit",
            "Jméno mechanismu a jeho aktivačního bitu",
        )],
        place: Place::MechanismHost,
        reads: &[Effect::Memory],
        summary: text(
            "Begins a mechanism, a sequence that runs while its activation bit is 1.",
            "Začátek mechanismu, tedy sekvence, která běží, dokud je její aktivační bit 1.",
        ),
        description: text(
            "Declares the mechanism and with it the activation bit of the same name, the place where it \
             will continue, and the WORD `name_LINE` with the source line where it waits (0 when it is \
             at rest). A mechanism starts when its bit is set, for instance by `FL 1,name`, from any \
             file. While the bit is 0 the body is skipped; while it is 1 the program jumps to the place \
             of continuation. Any number of mechanisms run side by side.\n\n\
             Mechanisms stand in MODULE_MAIN and MODULE_FAST, with a warning in MODULE_CONT; they are \
             not nested. Clearing the bit pauses the mechanism where it waits, setting it again lets it \
             go on (this implementation). A name may not be shared with a cell.",
            "Deklaruje mechanismus a s ním stejnojmenný aktivační bit, místo, odkud se bude pokračovat, \
             a WORD `jméno_LINE` s číslem zdrojového řádku, na kterém mechanismus čeká (v klidu 0). \
             Mechanismus se spustí nastavením bitu, například `FL 1,jméno`, z kteréhokoli souboru. Dokud \
             je bit 0, tělo se přeskakuje; je-li 1, program skočí na místo pokračování. Souběžně může \
             běžet libovolný počet mechanismů.\n\n\
             Mechanismy stojí v MODULE_MAIN a MODULE_FAST, s varováním i v MODULE_CONT; nevnořují se. \
             Vynulováním bitu se mechanismus pozastaví v místě, kde čeká, opětovným nastavením pokračuje \
             (tato implementace). Jméno nesmí mít zároveň jiná proměnná.",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN CLAMPING\n",
                "        FL   1,VALVE_CLAMP\n",
                "        LDR  CLAMPED\n",
                "        TEX0 -,150,CL_ERR,ERR_CLAMP\n",
                "        JUM  CL_END\n",
                "CL_ERR: ESET\n",
                "CL_END:\n",
                "        MECH_END CLAMPING"
            ),
            "Opens the valve, waits at most 3 s for the switch, otherwise reports a message.",
            "Otevře ventil, čeká na spínač nejvýše 3 s, jinak vydá hlášení.",
        )],
        related: &["MECH_END", "MECH_INIT", "EX", "EX0", "TEX0", "TIM", "FL"],
        ..STRUCTURE
    },
    Entry {
        name: "MECH_END",
        chapter: "4.2",
        forms: &[form("MECH_END mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: false },
            "The name given at MECH_BEGIN",
            "Jméno uvedené u MECH_BEGIN",
        )],
        place: Place::MechanismHost,
        writes: &[Effect::Memory],
        summary: text(
            "Ends a mechanism; reaching it clears the activation bit.",
            "Konec mechanismu; jeho dosažení vynuluje aktivační bit.",
        ),
        description: text(
            "Names the mechanism opened by MECH_BEGIN. A run that reaches it has finished: the \
             activation bit is cleared, the place of continuation goes back to the beginning and \
             `name_LINE` becomes 0. An instruction that waits also leaves here, but keeps the mechanism \
             active. The stack must be balanced.",
            "Uvádí jméno mechanismu otevřeného pomocí MECH_BEGIN. Průchod, který sem dojde, mechanismus \
             ukončil: aktivační bit se vynuluje, místo pokračování se vrátí na začátek a `jméno_LINE` \
             bude 0. Čekající instrukce opouští mechanismus rovněž tudy, ten ale zůstává aktivní. \
             Zásobník musí být vyvážený.",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN CLAMPING\n",
                "        FL   1,VALVE_CLAMP\n",
                "        LDR  CLAMPED\n",
                "        TEX0 -,150,CL_ERR,ERR_CLAMP\n",
                "        JUM  CL_END\n",
                "CL_ERR: ESET\n",
                "CL_END:\n",
                "        MECH_END CLAMPING"
            ),
            "After the switch or the message the mechanism is at rest again.",
            "Po sepnutí spínače nebo po hlášení je mechanismus opět v klidu.",
        )],
        related: &["MECH_BEGIN", "MECH_INIT"],
        ..STRUCTURE
    },
    Entry {
        name: "MECH_INIT",
        chapter: "4.2",
        forms: &[form("MECH_INIT mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: false },
            "Mechanism of any file",
            "Mechanizmus z kteréhokoli souboru",
        )],
        writes: &[Effect::Memory],
        summary: text(
            "Puts a mechanism at rest and back to its beginning.",
            "Uvede mechanismus do klidu a vrátí ho na začátek.",
        ),
        description: text(
            "Clears the activation bit and moves the place of continuation to the beginning; the \
             counters of waiting instructions start anew. It may stand in any file. Used at start, in \
             fault handling, and to stop an opposite mechanism before this one runs. A mechanism that \
             does it to itself goes on to its next EX-type instruction or to MECH_END (this \
             implementation). RLO and DR stay.",
            "Vynuluje aktivační bit a vrátí místo pokračování na začátek; čítače čekajících instrukcí \
             začínají znovu. Smí stát v kterémkoli souboru. Používá se při startu, při ošetření poruch a \
             k ukončení protichůdného mechanismu předtím, než se tento rozběhne. Mechanismus, který ji \
             použije sám na sebe, doběhne k nejbližší instrukci typu EX nebo k MECH_END (tato \
             implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LDR  UNCLAMP_KEY\n",
                "        JL0  NO_KEY\n",
                "        MECH_INIT CLAMPING\n",
                "        FL   1,UNCLAMPING\n",
                "NO_KEY:"
            ),
            "Stops clamping and starts unclamping.",
            "Ukončí upínání a spustí uvolnění.",
        )],
        related: &["MECH_BEGIN", "FL"],
        ..INSTRUCTION
    },
    Entry {
        name: "EX",
        forms: &[form("EX")],
        summary: text("Holds the sequence for one cycle.", "Pozastaví sekvenci na jeden cyklus."),
        description: text(
            "Leaves the mechanism at once; in the next cycle (20 ms, in MODULE_FAST 1 ms) it continues \
             on the next line. RLO and DR are not kept over the pause. An endless loop in a mechanism \
             needs EX or another instruction that holds it.",
            "Okamžitě opustí mechanismus; v dalším cyklu (20 ms, v MODULE_FAST 1 ms) se pokračuje na \
             dalším řádku. RLO a DR se přes pauzu nezachovají. Nekonečná smyčka v mechanismu potřebuje \
             EX nebo jinou instrukci, která ji podrží.",
        ),
        examples: &[example(
            concat!("        FL   1,RELAY\n", "        EX\n", "        FL   0,RELAY"),
            "A pulse one cycle long.",
            "Pulz dlouhý jeden cyklus.",
        )],
        related: &["EX0", "EX1", "BEX", "TIM"],
        ..WAITING
    },
    Entry {
        name: "EX0",
        forms: &[form("EX0")],
        reads: &[Effect::Rlo],
        summary: text("Holds the sequence while RLO is 0.", "Drží sekvenci, dokud je RLO 0."),
        description: text(
            "With RLO = 0 leaves the mechanism; in every following cycle the lines since the EX-type \
             instruction passed last (or since MECH_BEGIN) run again, compute the condition, and so does \
             this one. With the other value of RLO it goes on at once, in the same pass, and RLO and DR \
             stay as they were (this implementation). Put BEX before the condition when the lines above \
             must not repeat.",
            "Při RLO = 0 opustí mechanismus; v každém dalším cyklu se znovu provedou řádky od naposledy \
             prošlé instrukce typu EX (nebo od MECH_BEGIN), spočte se podmínka a znovu se vyhodnotí i \
             tato instrukce. Při opačném RLO pokračuje hned, v témže průchodu, a RLO i DR zůstanou \
             zachovány (tato implementace). Nemají-li se předchozí řádky opakovat, dejte před podmínku \
             BEX.",
        ),
        examples: &[example(
            concat!(
                "        FL   1,MOTOR\n",
                "        BEX\n",
                "        LDR  AT_END\n",
                "        EX0\n",
                "        FL   0,MOTOR"
            ),
            "Runs the motor until AT_END. Thanks to BEX only the two lines of the condition repeat.",
            "Motor běží, dokud nepřijde AT_END. Díky BEX se opakují jen dva řádky podmínky.",
        )],
        related: &["EX1", "BEX", "TEX0", "EX"],
        ..WAITING
    },
    Entry {
        name: "EX1",
        forms: &[form("EX1")],
        reads: &[Effect::Rlo],
        summary: text("Holds the sequence while RLO is 1.", "Drží sekvenci, dokud je RLO 1."),
        description: text(
            "With RLO = 1 leaves the mechanism; in every following cycle the lines since the EX-type \
             instruction passed last (or since MECH_BEGIN) run again, compute the condition, and so does \
             this one. With the other value of RLO it goes on at once, in the same pass, and RLO and DR \
             stay as they were (this implementation). Put BEX before the condition when the lines above \
             must not repeat.",
            "Při RLO = 1 opustí mechanismus; v každém dalším cyklu se znovu provedou řádky od naposledy \
             prošlé instrukce typu EX (nebo od MECH_BEGIN), spočte se podmínka a znovu se vyhodnotí i \
             tato instrukce. Při opačném RLO pokračuje hned, v témže průchodu, a RLO i DR zůstanou \
             zachovány (tato implementace). Nemají-li se předchozí řádky opakovat, dejte před podmínku \
             BEX.",
        ),
        examples: &[example(
            concat!("        BEX\n", "        LDR  DOOR_OPEN\n", "        EX1"),
            "Waits until the door is no longer open.",
            "Čeká, až dveře nebudou otevřené.",
        )],
        related: &["EX0", "BEX", "TEX1", "EX"],
        ..WAITING
    },
    Entry {
        name: "BEX",
        forms: &[form("BEX")],
        summary: text(
            "Marks where a following wait evaluates its condition again, without holding the sequence.",
            "Označí místo, od kterého následující čekání znovu vyhodnocuje podmínku; sekvenci nedrží.",
        ),
        description: text(
            "Sets the place of continuation behind itself and goes on at once, so that a following EX0, \
             EX1, TEX0 or TEX1 repeats only its condition. Unlike EX it costs no cycle. It does not \
             yield: it is not enough for an endless loop, and a TIM after it repeats the lines between \
             them (this implementation).",
            "Nastaví místo pokračování za sebe a hned pokračuje, takže následující EX0, EX1, TEX0 nebo \
             TEX1 opakuje jen svou podmínku. Na rozdíl od EX nestojí žádný cyklus. Sekvenci nedrží: pro \
             nekonečnou smyčku nestačí a TIM za ní opakuje řádky mezi nimi (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        FL   1,PUMP\n",
                "        BEX\n",
                "        LDR  PRESSURE_OK\n",
                "        TEX0 -,500,NO_OIL"
            ),
            "PUMP is set once, the condition repeats for at most 10 s.",
            "PUMP se nastaví jednou, podmínka se opakuje nejvýše 10 s.",
        )],
        related: &["EX", "EX0", "EX1", "TEX0"],
        ..WAITING
    },
    Entry {
        name: "TEX0",
        forms: &[
            form("TEX0 count, time, error [,code]"),
            form("TEX0 [TYPE.]count, time, error [,code]"),
            form("TEX0 TYPE.(count+n), (time+m), error [,code]"),
            form("TEX0 -, time, error [,code]"),
            form("TEX0 NIL, time, error [,code]"),
        ],
        operands: &[COUNT, TIME, ERROR, CODE],
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory, Effect::Dr64],
        time_unit: Some(TimeUnit::Cycle),
        summary: text(
            "Holds the sequence while RLO is 0, at most for a given time.",
            "Drží sekvenci, dokud je RLO 0, nejvýše však zadanou dobu.",
        ),
        description: text(
            "As EX0, but it counts the cycles it waits; after `time` cycles it jumps to `error`. A cycle \
             is 20 ms, also in the block modules, so 50 is one second; in MODULE_FAST it is 1 ms. At the \
             jump DR holds `code` as LOD would load it, which lets several waits share one handler that \
             ends by ESET.\n\n\
             The counter is a BYTE or WORD cell, or `-` or NIL for an automatic one; it starts anew when \
             the state is entered, left or timed out and at MECH_INIT (this implementation). A type \
             prefix covers counter and time; the time then may not be a constant.",
            "Totéž co EX0, čítá ale cykly čekání; po `time` cyklech skočí na `error`. Cyklus trvá 20 ms, \
             i v blokových modulech, takže 50 je jedna sekunda; v MODULE_FAST trvá 1 ms. Při skoku \
             obsahuje DR hodnotu `code` tak, jak by ji načetlo LOD, takže několik čekání může mít \
             společné ošetření zakončené ESET.\n\n\
             Čítač je buňka BYTE nebo WORD, `-` nebo NIL vytvoří automatický; začíná znovu při vstupu do \
             stavu, jeho opuštění, vypršení času a při MECH_INIT (tato implementace). Prefix typu se \
             vztahuje na čítač i čas; čas pak nesmí být konstanta.",
        ),
        examples: &[example(
            concat!(
                "        FL   1,TURRET_UP\n",
                "        BEX\n",
                "        LDR  TURRET_IS_UP\n",
                "        TEX0 -,100,FAULT,ERR_TURRET"
            ),
            "Waits at most 2 s; then FAULT gets the number of the message in DR.",
            "Čeká nejvýše 2 s; pak se na FAULT předá číslo hlášení v DR.",
        )],
        related: &["TEX1", "EX0", "TIM", "ESET", "BEX"],
        ..WAITING
    },
    Entry {
        name: "TEX1",
        forms: &[
            form("TEX1 count, time, error [,code]"),
            form("TEX1 [TYPE.]count, time, error [,code]"),
            form("TEX1 TYPE.(count+n), (time+m), error [,code]"),
            form("TEX1 -, time, error [,code]"),
            form("TEX1 NIL, time, error [,code]"),
        ],
        operands: &[COUNT, TIME, ERROR, CODE],
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory, Effect::Dr64],
        time_unit: Some(TimeUnit::Cycle),
        summary: text(
            "Holds the sequence while RLO is 1, at most for a given time.",
            "Drží sekvenci, dokud je RLO 1, nejvýše však zadanou dobu.",
        ),
        description: text(
            "As EX1, but it counts the cycles it waits; after `time` cycles it jumps to `error`. A cycle \
             is 20 ms, also in the block modules, so 50 is one second; in MODULE_FAST it is 1 ms. At the \
             jump DR holds `code` as LOD would load it, which lets several waits share one handler that \
             ends by ESET.\n\n\
             The counter is a BYTE or WORD cell, or `-` or NIL for an automatic one; it starts anew when \
             the state is entered, left or timed out and at MECH_INIT (this implementation). A type \
             prefix covers counter and time; the time then may not be a constant.",
            "Totéž co EX1, čítá ale cykly čekání; po `time` cyklech skočí na `error`. Cyklus trvá 20 ms, \
             i v blokových modulech, takže 50 je jedna sekunda; v MODULE_FAST trvá 1 ms. Při skoku \
             obsahuje DR hodnotu `code` tak, jak by ji načetlo LOD, takže několik čekání může mít \
             společné ošetření zakončené ESET.\n\n\
             Čítač je buňka BYTE nebo WORD, `-` nebo NIL vytvoří automatický; začíná znovu při vstupu do \
             stavu, jeho opuštění, vypršení času a při MECH_INIT (tato implementace). Prefix typu se \
             vztahuje na čítač i čas; čas pak nesmí být konstanta.",
        ),
        examples: &[example(
            concat!(
                "        FL   1,TURRET_UP\n",
                "        BEX\n",
                "        LDR  TURRET_LOCKED\n",
                "        TEX1 -,100,FAULT,ERR_TURRET"
            ),
            "Waits at most 2 s; then FAULT gets the number of the message in DR.",
            "Čeká nejvýše 2 s; pak se na FAULT předá číslo hlášení v DR.",
        )],
        related: &["TEX0", "EX1", "TIM", "ESET", "BEX"],
        ..WAITING
    },
    Entry {
        name: "TIM",
        forms: &[
            form("TIM count, time"),
            form("TIM [TYPE.]count, time"),
            form("TIM TYPE.(count+n), (time+m)"),
            form("TIM -, time"),
            form("TIM NIL, time"),
        ],
        operands: &[
            COUNT,
            operand(
                "time",
                OperandKind::Time,
                "Delay in cycles: number, EQUI constant, or BYTE or WORD cell",
                "Prodleva v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD",
            ),
        ],
        reads: &[Effect::Memory],
        time_unit: Some(TimeUnit::Cycle),
        summary: text("Holds the sequence for a given time.", "Pozastaví sekvenci na zadanou dobu."),
        description: text(
            "Leaves the mechanism for `time` cycles and then goes on. A cycle is 20 ms, also in the \
             block modules, so 50 is one second; in MODULE_FAST it is 1 ms. As with EX0, the lines since \
             the EX-type instruction passed last run again in every cycle of the delay, so actions that \
             must not repeat belong behind an EX or before a BEX.\n\n\
             The counter is a BYTE or WORD cell, or `-` or NIL for an automatic one; it starts anew when \
             the state is entered, left or timed out and at MECH_INIT (this implementation). A type \
             prefix covers counter and time; the time then may not be a constant.",
            "Opustí mechanismus na `time` cyklů a pak pokračuje. Cyklus trvá 20 ms, i v blokových \
             modulech, takže 50 je jedna sekunda; v MODULE_FAST trvá 1 ms. Stejně jako u EX0 se v každém \
             cyklu prodlevy znovu provádějí řádky od naposledy prošlé instrukce typu EX; akce, které se \
             opakovat nemají, proto patří za EX nebo před BEX.\n\n\
             Čítač je buňka BYTE nebo WORD, `-` nebo NIL vytvoří automatický; začíná znovu při vstupu do \
             stavu, jeho opuštění, vypršení času a při MECH_INIT (tato implementace). Prefix typu se \
             vztahuje na čítač i čas; čas pak nesmí být konstanta.",
        ),
        examples: &[example(
            concat!("        FL   1,HORN\n", "        TIM  -,25\n", "        FL   0,HORN"),
            "Sounds the horn for half a second.",
            "Houká půl sekundy.",
        )],
        related: &["EX", "TEX0", "TM", "BEX"],
        ..WAITING
    },
];
