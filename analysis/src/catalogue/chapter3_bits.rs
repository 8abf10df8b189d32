//! Chapters 3.5 to 3.7: logic equations over bits, and writing their result.

use super::entry::{Effect, Entry, Equation, OperandKind, OperandSpec, Place};
use super::pattern::{
    DIRECTIVE, INSTRUCTION, NAMED_BIT, READ_BIT, SOURCE_BIT, WRITE_BIT, example, form, operand, text,
};

const COMBINED_BIT: OperandSpec = operand(
    "bit",
    READ_BIT,
    "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation; without it the stack \
     is used",
    "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci; bez operandu se bere \
     zásobník",
)
.or_nothing();
const WATCHED_BIT: OperandSpec =
    operand("bit", NAMED_BIT, "Watched bit, by its name", "Sledovaný bit, zadaný jménem");
const WRITTEN_BIT: OperandSpec = operand(
    "bit",
    WRITE_BIT,
    "Bit to write: a name, `ADR.bit` or `$+n.bit`",
    "Zapisovaný bit: jméno, `ADR.bit` nebo `$+n.bit`",
)
.repeated();
const VALUE: OperandSpec = operand(
    "value",
    OperandKind::Number { min: 0, max: 1 },
    "Value written: 0 or 1",
    "Zapisovaná hodnota: 0 nebo 1",
);
const DST: OperandSpec = operand("dst", WRITE_BIT, "Destination bit", "Cílový bit");
const SRC: OperandSpec = operand("src", SOURCE_BIT, "Source bit", "Zdrojový bit");

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "LDR",
        chapter: "3.5",
        forms: &[form("LDR [-]bit"), form("LDR [-][ADR.]bit"), form("LDR [-]$+n.bit")],
        operands: &[operand(
            "bit",
            READ_BIT,
            "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation",
            "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci",
        )],
        equation: Equation::Open,
        reads: &[Effect::Memory, Effect::Rlo],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text(
            "Loads a bit into RLO, or pushes RLO first when an equation is open.",
            "Načte bit do RLO; je-li rovnice rozpracovaná, nejprve uloží RLO na zásobník.",
        ),
        description: text(
            "Reads the bit, or with `-` its negation, into RLO and opens a logic equation. When an \
             equation is already open (no terminal instruction has closed it since the last LDR), the \
             old RLO is pushed on the stack first; LA, LO or LX without operand later pops it. The \
             compiler decides this by the order of the lines, not by the path taken at run time. The \
             stack holds 8 values; a deeper nesting is an error.\n\n\
             The bit may be a bit of a DFM, a predefined bit or the activation bit of a mechanism. In \
             `ADR.bit` only the position of `bit` is used, on the byte at `ADR`: a cell, another bit \
             (its byte), `(cell+n)`, `cell[BX]`; `$+n.bit` is the byte n bytes after the one where the \
             bit is declared. DR is not changed.",
            "Načte bit, se znaménkem `-` jeho negaci, do RLO a otevře logickou rovnici. Je-li rovnice už \
             rozpracovaná (od posledního LDR ji žádná koncová instrukce neuzavřela), uloží se nejprve \
             staré RLO na zásobník; později je vybere LA, LO nebo LX bez operandu. Překladač o tom \
             rozhoduje podle pořadí řádků, ne podle skutečného průchodu programem. Zásobník má 8 míst, \
             hlubší vnoření je chyba.\n\n\
             Bitem může být bit z DFM, předdefinovaný bit nebo aktivační bit mechanismu. V zápisu \
             `ADR.bit` se z `bit` bere jen pozice, a to ve slabice na adrese `ADR`: buňka, jiný bit \
             (jeho slabika), `(buňka+n)`, `buňka[BX]`; `$+n.bit` je slabika ležící n bajtů za tou, ve \
             které je bit deklarován. DR se nemění.",
        ),
        examples: &[
            example(
                concat!("        LDR  DOOR_SHUT\n", "        LA   -ALARM\n", "        WR   START_OK"),
                "START_OK is 1 when the door is shut and there is no alarm.",
                "START_OK je 1, když jsou dveře zavřené a není alarm.",
            ),
            example(
                concat!("        LDR  STATUS.B4\n", "        WR   $+1.READY"),
                "Bit 4 of the cell STATUS is written to the position of READY, one byte after it.",
                "Bit 4 buňky STATUS se zapíše na pozici bitu READY, o jednu slabiku dál.",
            ),
        ],
        related: &["LA", "LO", "LX", "WR"],
        ..INSTRUCTION
    },
    Entry {
        name: "LA",
        chapter: "3.6",
        forms: &[form("LA"), form("LA [-]bit"), form("LA [-][ADR.]bit"), form("LA [-]$+n.bit")],
        operands: &[COMBINED_BIT],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text(
            "ANDs RLO with a bit, or with the last value on the stack.",
            "Logický součin RLO s bitem nebo s poslední hodnotou na zásobníku.",
        ),
        description: text(
            "With an operand: RLO becomes RLO AND bit. A leading `-` takes the negation of the bit, \
             `ADR.bit` and `$+n.bit` work as in LDR.\n\n\
             Without an operand the other input is the value last pushed on the stack, which is removed. \
             That closes a bracket opened by an inner LDR. With nothing on the stack it is an error. DR \
             is not changed.",
            "S operandem: RLO bude logický součin RLO a bitu. Znaménko `-` bere negaci bitu, zápisy \
             `ADR.bit` a `$+n.bit` fungují stejně jako u LDR.\n\n\
             Bez operandu je druhým vstupem součinu hodnota naposledy uložená na zásobník, která se z \
             něj vybere. Tím se uzavírá závorka otevřená vnitřním LDR. Je-li zásobník prázdný, je to \
             chyba. DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LDR  PUMP\n",
                "        LO   MANUAL\n",
                "        LDR  LEVEL_OK\n",
                "        LO   BYPASS\n",
                "        LA\n",
                "        WR   COOLANT"
            ),
            "(PUMP or MANUAL) and (LEVEL_OK or BYPASS): the second LDR pushes, LA pops.",
            "(PUMP nebo MANUAL) a zároveň (LEVEL_OK nebo BYPASS): druhé LDR ukládá, LA vybírá.",
        )],
        related: &["LDR", "LO", "LX", "CA"],
        ..INSTRUCTION
    },
    Entry {
        name: "LO",
        chapter: "3.6",
        forms: &[form("LO"), form("LO [-]bit"), form("LO [-][ADR.]bit"), form("LO [-]$+n.bit")],
        operands: &[COMBINED_BIT],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text(
            "ORs RLO with a bit, or with the last value on the stack.",
            "Logický součet RLO s bitem nebo s poslední hodnotou na zásobníku.",
        ),
        description: text(
            "With an operand: RLO becomes RLO OR bit. A leading `-` takes the negation of the bit, \
             `ADR.bit` and `$+n.bit` work as in LDR.\n\n\
             Without an operand the other input is the value last pushed on the stack, which is removed. \
             That closes a bracket opened by an inner LDR. With nothing on the stack it is an error. DR \
             is not changed.",
            "S operandem: RLO bude logický součet RLO a bitu. Znaménko `-` bere negaci bitu, zápisy \
             `ADR.bit` a `$+n.bit` fungují stejně jako u LDR.\n\n\
             Bez operandu je druhým vstupem součtu hodnota naposledy uložená na zásobník, která se z něj \
             vybere. Tím se uzavírá závorka otevřená vnitřním LDR. Je-li zásobník prázdný, je to chyba. \
             DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LDR  START\n",
                "        LO   RUNNING\n",
                "        LA   -STOP_KEY\n",
                "        WR   RUNNING"
            ),
            "A latch: START sets it, STOP_KEY clears it.",
            "Paměť se samodržením: START ji nastaví, STOP_KEY vynuluje.",
        )],
        related: &["LDR", "LA", "LX", "CA"],
        ..INSTRUCTION
    },
    Entry {
        name: "LX",
        chapter: "3.6",
        forms: &[form("LX"), form("LX [-]bit"), form("LX [-][ADR.]bit"), form("LX [-]$+n.bit")],
        operands: &[COMBINED_BIT],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text(
            "XORs RLO with a bit, or with the last value on the stack.",
            "Nonekvivalence RLO s bitem nebo s poslední hodnotou na zásobníku.",
        ),
        description: text(
            "With an operand: RLO becomes 1 when RLO and the bit differ. A leading `-` takes the \
             negation of the bit, `ADR.bit` and `$+n.bit` work as in LDR.\n\n\
             Without an operand the other input is the value last pushed on the stack, which is removed. \
             That closes a bracket opened by an inner LDR. With nothing on the stack it is an error. DR \
             is not changed.",
            "S operandem: RLO bude 1, když se RLO a bit liší. Znaménko `-` bere negaci bitu, zápisy \
             `ADR.bit` a `$+n.bit` fungují stejně jako u LDR.\n\n\
             Bez operandu je druhým vstupem nonekvivalence hodnota naposledy uložená na zásobník, která \
             se z něj vybere. Tím se uzavírá závorka otevřená vnitřním LDR. Je-li zásobník prázdný, je \
             to chyba. DR se nemění.",
        ),
        examples: &[example(
            concat!("        LDR  VALVE\n", "        LX   VALVE_BACK\n", "        WR   VALVE_LAGS"),
            "VALVE_LAGS is 1 while the feedback does not follow the output.",
            "VALVE_LAGS je 1, dokud zpětné hlášení nesouhlasí s výstupem.",
        )],
        related: &["LDR", "LA", "LO", "CA"],
        ..INSTRUCTION
    },
    Entry {
        name: "CA",
        chapter: "3.6",
        forms: &[form("CA")],
        equation: Equation::Modify,
        reads: &[Effect::Rlo],
        writes: &[Effect::Rlo],
        summary: text("Negates RLO.", "Neguje RLO."),
        description: text(
            "Turns 1 to 0 and 0 to 1. Neither opens nor closes an equation; the stack and DR stay.",
            "Z jedničky udělá nulu a naopak. Rovnici neotvírá ani neuzavírá, zásobník a DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LDR  LIMIT_A\n",
                "        LA   LIMIT_B\n",
                "        CA\n",
                "        WR   MOVE_FREE"
            ),
            "MOVE_FREE is 0 only when both limits are active.",
            "MOVE_FREE je 0, jen když jsou aktivní oba koncové spínače.",
        )],
        related: &["LDR", "LA", "LO"],
        ..INSTRUCTION
    },
    Entry {
        name: "EDGE_H",
        chapter: "3.6",
        forms: &[form("EDGE_H bit")],
        operands: &[WATCHED_BIT],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Sets RLO for one pass when the bit goes from 0 to 1.",
            "Nastaví RLO na jeden průchod, když bit přejde z 0 do 1.",
        ),
        description: text(
            "Every occurrence of the instruction keeps the state the bit had when this line last ran, in \
             a hidden bit of its own. RLO becomes 1 only in the pass that sees the change from 0 to 1, \
             otherwise 0. The first evaluation after a start of the PLC only records the state and never \
             fires, even when the bit already is 1 (this implementation: also after a restart).\n\n\
             RLO is overwritten without a push, so use it to begin an equation; a warning tells when it \
             loses one that is open. It may stand in MODULE_FAST and inside DFTM blocks; where a line is \
             skipped, it compares with the last time it ran. Only a plain name of a bit is allowed. DR \
             is not changed.",
            "Každý výskyt instrukce si ve vlastním skrytém bitu pamatuje stav, jaký měl sledovaný bit \
             při minulém provedení tohoto řádku. RLO bude 1 jen v průchodu, který zaznamená změnu z 0 do \
             1, jinak 0. První vyhodnocení po startu PLC stav jen zapamatuje a hranu nikdy nehlásí, ani \
             když už bit hodnotu 1 má (tato implementace: i po opětovném startu).\n\n\
             RLO se přepíše bez uložení na zásobník, instrukce proto patří na začátek rovnice; na ztrátu \
             rozpracované rovnice upozorní varování. Smí stát v MODULE_FAST i uvnitř bloků DFTM; byl-li \
             řádek přeskočen, porovnává se se stavem při jeho posledním provedení. Operandem je jen \
             prosté jméno bitu. DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "        EDGE_H PART_OUT\n",
                "        JL0  NO_PART\n",
                "        LOD  PARTS\n",
                "        INR\n",
                "        STO  PARTS\n",
                "NO_PART:"
            ),
            "One part is counted at every rising edge of PART_OUT.",
            "Každá náběžná hrana PART_OUT přičte jeden kus.",
        )],
        related: &["EDGE_L", "LDR", "CU"],
        ..INSTRUCTION
    },
    Entry {
        name: "EDGE_L",
        chapter: "3.6",
        forms: &[form("EDGE_L bit")],
        operands: &[WATCHED_BIT],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Sets RLO for one pass when the bit goes from 1 to 0.",
            "Nastaví RLO na jeden průchod, když bit přejde z 1 do 0.",
        ),
        description: text(
            "Every occurrence of the instruction keeps the state the bit had when this line last ran, in \
             a hidden bit of its own. RLO becomes 1 only in the pass that sees the change from 1 to 0, \
             otherwise 0. The first evaluation after a start of the PLC only records the state and never \
             fires, even when the bit already is 0 (this implementation: also after a restart).\n\n\
             RLO is overwritten without a push, so use it to begin an equation; a warning tells when it \
             loses one that is open. It may stand in MODULE_FAST and inside DFTM blocks; where a line is \
             skipped, it compares with the last time it ran. Only a plain name of a bit is allowed. DR \
             is not changed.",
            "Každý výskyt instrukce si ve vlastním skrytém bitu pamatuje stav, jaký měl sledovaný bit \
             při minulém provedení tohoto řádku. RLO bude 1 jen v průchodu, který zaznamená změnu z 1 do \
             0, jinak 0. První vyhodnocení po startu PLC stav jen zapamatuje a hranu nikdy nehlásí, ani \
             když už bit hodnotu 0 má (tato implementace: i po opětovném startu).\n\n\
             RLO se přepíše bez uložení na zásobník, instrukce proto patří na začátek rovnice; na ztrátu \
             rozpracované rovnice upozorní varování. Smí stát v MODULE_FAST i uvnitř bloků DFTM; byl-li \
             řádek přeskočen, porovnává se se stavem při jeho posledním provedení. Operandem je jen \
             prosté jméno bitu. DR se nemění.",
        ),
        examples: &[example(
            concat!("        EDGE_L DOOR_SHUT\n", "        FL1  0,LIGHT_REQ"),
            "The lamp request is cleared when the door sensor drops.",
            "Požadavek na světlo se zruší, když odpadne snímač dveří.",
        )],
        related: &["EDGE_H", "LDR", "CU"],
        ..INSTRUCTION
    },
    Entry {
        name: "CHECK",
        chapter: "3.6",
        forms: &[form("CHECK")],
        place: Place::Code,
        summary: text(
            "Makes the compiler check at this place that the stack is balanced and no equation is open.",
            "Přikáže překladači ověřit na tomto místě, že je zásobník vyvážený a žádná rovnice není \
             rozpracovaná.",
        ),
        description: text(
            "Produces no code. The compiler checks the balance of the stack by itself at the end of \
             every module, mechanism and procedure; CHECK adds the same check at its own line, which \
             narrows down where an equation was left open. It reports an open equation and values left \
             on the stack (this implementation).",
            "Negeneruje žádný kód. Vyváženost zásobníku kontroluje překladač sám na konci každého \
             modulu, mechanismu a procedury; CHECK přidá tutéž kontrolu na svém řádku, takže se snáze \
             najde místo, kde rovnice zůstala neuzavřená. Hlásí rozpracovanou rovnici i hodnoty zbylé na \
             zásobníku (tato implementace).",
        ),
        examples: &[example(
            concat!("        LDR  A1\n", "        LA   A2\n", "        WR   B1\n", "        CHECK"),
            "Nothing is reported: WR has closed the equation.",
            "Nehlásí se nic: rovnici uzavřela instrukce WR.",
        )],
        related: &["LDR", "DEBUG"],
        ..DIRECTIVE
    },
    Entry {
        name: "WR",
        chapter: "3.7",
        forms: &[
            form("WR bit [,bit2 …]"),
            form("WR [ADR.]bit [,[ADR2.]bit2 …]"),
            form("WR $+n.bit [,$+m.bit2 …]"),
        ],
        operands: &[WRITTEN_BIT],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Memory],
        summary: text("Writes RLO to one or more bits.", "Zapíše RLO do jednoho nebo více bitů."),
        description: text(
            "Writes RLO, be it 0 or 1, to every bit listed; the bits need not lie in one byte. RLO and \
             DR stay, so further conditional instructions can use the same result. WR closes the \
             equation: it is a terminal instruction. A negated target is not possible, use CA before.",
            "Zapíše RLO, ať je 0, nebo 1, do všech uvedených bitů; bity nemusí ležet v jedné slabice. \
             RLO a DR se nemění, takže tentýž výsledek mohou použít i další podmíněné instrukce. WR \
             rovnici uzavírá, je to koncová instrukce. Zápis negace není možný, použijte předtím CA.",
        ),
        examples: &[example(
            concat!("        LDR  SPINDLE_ON\n", "        LA   OIL_OK\n", "        WR   CONTACTOR,LAMP_RUN"),
            "Both outputs follow the same equation.",
            "Oba výstupy sledují tutéž rovnici.",
        )],
        related: &["FL", "FL1", "MOVR", "LDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "FL",
        chapter: "3.7",
        forms: &[
            form("FL 0|1, bit [,bit2 …]"),
            form("FL 0|1, [ADR.]bit [,[ADR2.]bit2 …]"),
            form("FL 0|1, $+n.bit [,$+m.bit2 …]"),
        ],
        operands: &[VALUE, WRITTEN_BIT],
        writes: &[Effect::Memory],
        summary: text("Sets or clears bits unconditionally.", "Nepodmíněně nastaví nebo vynuluje bity."),
        description: text(
            "Writes the constant 0 or 1 to every bit listed, whatever RLO is. RLO and DR stay, an open \
             equation stays open: FL is not a terminal instruction.\n\n\
             `FL 1,mechanism` starts a mechanism. `FL 0,mechanism` on a running one pauses it where it \
             waits and `FL 1` lets it go on; to stop it for good use MECH_INIT (this implementation).",
            "Zapíše konstantu 0 nebo 1 do všech uvedených bitů bez ohledu na RLO. RLO a DR se nemění a \
             rozpracovaná rovnice zůstává rozpracovaná: FL není koncová instrukce.\n\n\
             `FL 1,mechanismus` mechanismus spustí. `FL 0,mechanismus` běžící mechanismus pozastaví v \
             místě, kde čeká, a `FL 1` ho nechá pokračovat; k definitivnímu ukončení slouží MECH_INIT \
             (tato implementace).",
        ),
        examples: &[example(
            concat!("        FL   0,CLAMP_OPEN,CLAMP_LAMP\n", "        FL   1,CLAMPING"),
            "Clears two outputs and starts the mechanism CLAMPING.",
            "Vynuluje dva výstupy a spustí mechanismus CLAMPING.",
        )],
        related: &["FL1", "WR", "MECH_BEGIN", "MECH_INIT"],
        ..INSTRUCTION
    },
    Entry {
        name: "FL1",
        chapter: "3.7",
        forms: &[
            form("FL1 0|1, bit [,bit2 …]"),
            form("FL1 0|1, [ADR.]bit [,[ADR2.]bit2 …]"),
            form("FL1 0|1, $+n.bit [,$+m.bit2 …]"),
        ],
        operands: &[VALUE, WRITTEN_BIT],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Memory],
        summary: text("Sets or clears bits when RLO is 1.", "Nastaví nebo vynuluje bity, když je RLO 1."),
        description: text(
            "With RLO = 1 writes the constant 0 or 1 to every bit listed, with RLO = 0 does nothing. It \
             is short for JL0 over an FL. RLO and DR stay, so several FL1 may follow one equation. \
             Terminal instruction.",
            "Při RLO = 1 zapíše konstantu 0 nebo 1 do všech uvedených bitů, při RLO = 0 neudělá nic. Je \
             to zkratka za skok JL0 přes instrukci FL. RLO a DR se nemění, takže za jednou rovnicí může \
             stát několik FL1. Koncová instrukce.",
        ),
        examples: &[example(
            concat!("        LDR  ESTOP\n", "        FL1  0,DRIVE_ON,COOLANT\n", "        FL1  1,ALARM"),
            "The emergency stop clears two outputs and sets the alarm; without it nothing changes.",
            "Nouzové zastavení vynuluje dva výstupy a nastaví alarm; jinak se nezmění nic.",
        )],
        related: &["FL", "WR", "JL0"],
        ..INSTRUCTION
    },
    Entry {
        name: "MOVR",
        chapter: "3.7",
        forms: &[form("MOVR dst, src"), form("MOVR [ADR.]dst, [ADR.]src")],
        operands: &[DST, SRC],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Copies one bit to another.", "Zkopíruje jeden bit do druhého."),
        description: text(
            "Copies the source bit to the destination, which comes first. RLO, DR and an open equation \
             stay as they were, so it can stand in the middle of an equation. Both operands take \
             `ADR.bit` and `$+n.bit`; a negated source is not possible.",
            "Zkopíruje zdrojový bit do cílového, cíl se píše první. RLO, DR i rozpracovaná rovnice \
             zůstanou beze změny, takže instrukce smí stát i uprostřed rovnice. Oba operandy mohou být \
             ve tvaru `ADR.bit` a `$+n.bit`; negovaný zdroj není možný.",
        ),
        examples: &[example(
            "        MOVR LAMP,P1IN.B3",
            "Bit 3 of the first input port goes to LAMP.",
            "Bit 3 prvního vstupního portu se zkopíruje do LAMP.",
        )],
        related: &["MOVR1", "MOVE", "WR"],
        ..INSTRUCTION
    },
    Entry {
        name: "MOVR1",
        chapter: "3.7",
        forms: &[form("MOVR1 dst, src"), form("MOVR1 [ADR.]dst, [ADR.]src")],
        operands: &[DST, SRC],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies one bit to another when RLO is 1.",
            "Zkopíruje jeden bit do druhého, když je RLO 1.",
        ),
        description: text(
            "As MOVR, but copies only when RLO is 1. RLO and DR stay. Terminal instruction.",
            "Totéž co MOVR, kopíruje se ale jen při RLO = 1. RLO a DR se nemění. Koncová instrukce.",
        ),
        examples: &[example(
            concat!("        LDR  SAMPLE\n", "        MOVR1 HELD,SENSOR"),
            "HELD takes over the sensor while SAMPLE is 1 and keeps it afterwards.",
            "HELD přebírá stav snímače, dokud je SAMPLE 1, a pak si ho podrží.",
        )],
        related: &["MOVR", "MOVE1"],
        ..INSTRUCTION
    },
];
