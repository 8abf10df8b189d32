//! Chapter 3.10: loading and storing data.

use super::entry::{Effect, Entry, Equation, OperandSpec, PrefixSet};
use super::pattern::{CELLS, INSTRUCTION, LOADED, STORED, example, form, operand, source, text};

const VAL: OperandSpec = operand("val", STORED, "Cell that receives DR", "Buňka, do které se DR zapíše");
const DST: OperandSpec = operand("dst", STORED, "Destination cell", "Cílová buňka");
const SRC: OperandSpec = operand(
    "src",
    source(PrefixSet::STORE, CELLS),
    "Source cell of the same type",
    "Zdrojová buňka téhož typu",
);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "LOD",
        chapter: "3.10",
        forms: &[
            form("LOD [-]val"),
            form("LOD [-][TYPE.]val"),
            form("LOD [-]TYPE.(val+n)"),
            form("LOD [-]CNST.number"),
            form("LOD CNST.real"),
        ],
        operands: &[operand(
            "val",
            LOADED,
            "Cell, EQUI constant or number; a leading `-` negates",
            "Buňka, konstanta EQUI nebo číslo; znaménko `-` vpředu neguje",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Loads a value into DR.", "Načte hodnotu do DR."),
        description: text(
            "First DR is cleared, then the value is loaded at its own width and sign-extended to 64 \
             bits. A BYTE with 0FFh thus loads as -1, and `EQ CNST.255` is then false (the editor \
             warns); `EQ BYTE.255` or `ANDB CNST.0FFh` before the comparison help. A leading `-` loads \
             the two's complement, for reals the negative number.\n\n\
             Width: declared type or prefix; EQUI constants, `CNST.` and bare numbers are 32 bits. \
             `REAL.` and a constant with a decimal point load DR_REAL, and DR64 gets the value rounded \
             to the nearest integer, ties to even, saturated (this implementation). An integer LOD \
             leaves DR_REAL as it was. RLO and the stack stay.",
            "Nejprve se DR vynuluje, pak se hodnota načte ve své šířce a znaménkově se rozšíří na 64 \
             bitů. BYTE s obsahem 0FFh se tak načte jako -1 a `EQ CNST.255` pak neplatí (editor na to \
             upozorní); pomůže `EQ BYTE.255` nebo `ANDB CNST.0FFh` před porovnáním. Znaménko `-` načte \
             dvojkový doplněk, u reálných čísel zápornou hodnotu.\n\n\
             Šířka: podle deklarace nebo prefixu; konstanty EQUI, `CNST.` a samotná čísla mají 32 bitů. \
             `REAL.` a konstanta s desetinnou tečkou plní DR_REAL a do DR64 se uloží hodnota \
             zaokrouhlená na nejbližší celé číslo, v polovině k sudému, s omezením na rozsah (tato \
             implementace). Celočíselné LOD nechá DR_REAL beze změny. RLO ani zásobník se nemění.",
        ),
        examples: &[
            example(
                concat!("        LOD  PARTS\n", "        STO  DISPLAY"),
                "Copies a cell through DR at its declared width.",
                "Zkopíruje buňku přes DR v deklarované šířce.",
            ),
            example(
                concat!("        LOD  -CNST.5\n", "        LOD  BYTE.(TABLE+2)\n", "        LOD  REAL.ANGLE"),
                "A negated constant, a byte of an area and a real cell.",
                "Negovaná konstanta, slabika z oblasti a reálná buňka.",
            ),
        ],
        related: &["STO", "MOVE", "CNST", "REAL"],
        ..INSTRUCTION
    },
    Entry {
        name: "STO",
        chapter: "3.10",
        forms: &[form("STO val"), form("STO [TYPE.]val"), form("STO TYPE.(val+n)")],
        operands: &[VAL],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory.", "Zapíše DR do paměti."),
        description: text(
            "Writes DR at the width of the operand: DR8, DR16, DR32, with `QWRD.` DR64, with `REAL.` \
             DR_REAL. Upper bits that don't fit are dropped. After a real operation an integer cell gets \
             the rounded value from DR64. DR and RLO stay; STO is no terminal instruction, so an open \
             equation stays open.",
            "Zapíše DR v šířce operandu: DR8, DR16, DR32, s prefixem `QWRD.` DR64, s `REAL.` DR_REAL. \
             Horní bity, které se nevejdou, se zahodí. Po reálné operaci dostane celočíselná buňka \
             zaokrouhlenou hodnotu z DR64. DR ani RLO se nemění; STO není koncová instrukce, \
             rozpracovaná rovnice tedy zůstává rozpracovaná.",
        ),
        examples: &[example(
            concat!("        LOD  CNST.100\n", "        STO  LIMIT\n", "        STO  WORD.(TABLE+4)"),
            "Writes 100 to a cell and to a word of an area.",
            "Zapíše 100 do buňky a do slova v oblasti.",
        )],
        related: &["LOD", "STO1", "STO0", "MOVE"],
        ..INSTRUCTION
    },
    Entry {
        name: "STO1",
        chapter: "3.10",
        forms: &[form("STO1 val"), form("STO1 [TYPE.]val"), form("STO1 TYPE.(val+n)")],
        operands: &[VAL],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory when RLO is 1.", "Zapíše DR do paměti, když je RLO 1."),
        description: text(
            "As STO, but stores only when RLO is 1; otherwise the cell stays. DR and RLO stay. Terminal \
             instruction.",
            "Totéž co STO, zapisuje se ale jen při RLO = 1; jinak se buňka nemění. DR a RLO se nemění. \
             Koncová instrukce.",
        ),
        examples: &[example(
            concat!("        LDR  RESET_KEY\n", "        LOD  CNST.0\n", "        STO1 PARTS"),
            "The counter is cleared while RESET_KEY is 1.",
            "Počítadlo se nuluje, dokud je RESET_KEY 1.",
        )],
        related: &["STO", "STO0", "MOVE1"],
        ..INSTRUCTION
    },
    Entry {
        name: "STO0",
        chapter: "3.10",
        forms: &[form("STO0 val"), form("STO0 [TYPE.]val"), form("STO0 TYPE.(val+n)")],
        operands: &[VAL],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal],
        writes: &[Effect::Memory],
        summary: text("Stores DR in memory when RLO is 0.", "Zapíše DR do paměti, když je RLO 0."),
        description: text(
            "As STO, but stores only when RLO is 0; otherwise the cell stays. DR and RLO stay. Terminal \
             instruction (this implementation).",
            "Totéž co STO, zapisuje se ale jen při RLO = 0; jinak se buňka nemění. DR a RLO se nemění. \
             Koncová instrukce (tato implementace).",
        ),
        examples: &[example(
            concat!("        LDR  RESET_KEY\n", "        LOD  CNST.0\n", "        STO0 PARTS"),
            "The counter is cleared while RESET_KEY is 0.",
            "Počítadlo se nuluje, dokud je RESET_KEY 0.",
        )],
        related: &["STO", "STO1", "MOVE1"],
        ..INSTRUCTION
    },
    Entry {
        name: "MOVE",
        chapter: "3.10",
        forms: &[
            form("MOVE dst, src"),
            form("MOVE [TYPE.]dst, [TYPE.]src"),
            form("MOVE TYPE.(dst+n), TYPE.(src+n)"),
        ],
        operands: &[DST, SRC],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies one cell to another of the same type.",
            "Zkopíruje buňku do jiné buňky téhož typu.",
        ),
        description: text(
            "Copies the source to the destination, which comes first, at the width of their type; both \
             must have the same type or the same prefix. DR, DR_REAL, RLO and an open equation stay. A \
             constant can't be the source: use LOD and STO.",
            "Zkopíruje zdroj do cíle v šířce jejich typu, cíl se píše první; oba musí mít týž typ nebo \
             týž prefix. DR, DR_REAL, RLO i rozpracovaná rovnice zůstanou beze změny. Zdrojem nemůže být \
             konstanta: k tomu slouží LOD a STO.",
        ),
        examples: &[example(
            concat!("        MOVE LAST_POS,POS\n", "        MOVE REAL.OLD,REAL.NEW"),
            "Copies a cell of any declared type, and a real one.",
            "Zkopíruje buňku deklarovaného typu a reálnou buňku.",
        )],
        related: &["MOVE1", "MV", "MOVR", "LOD"],
        ..INSTRUCTION
    },
    Entry {
        name: "MOVE1",
        chapter: "3.10",
        forms: &[
            form("MOVE1 dst, src"),
            form("MOVE1 [TYPE.]dst, [TYPE.]src"),
            form("MOVE1 TYPE.(dst+n), TYPE.(src+n)"),
        ],
        operands: &[DST, SRC],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies one cell to another of the same type when RLO is 1.",
            "Zkopíruje buňku do jiné buňky téhož typu, když je RLO 1.",
        ),
        description: text(
            "As MOVE, but copies only when RLO is 1. Terminal instruction.",
            "Totéž co MOVE, kopíruje se ale jen při RLO = 1. Koncová instrukce.",
        ),
        examples: &[example(
            concat!("        EDGE_H SAMPLE\n", "        MOVE1 HELD_LEVEL,LEVEL"),
            "Takes LEVEL over at the rising edge of SAMPLE.",
            "Při náběžné hraně SAMPLE převezme LEVEL.",
        )],
        related: &["MOVE", "STO1", "MOVR1"],
        ..INSTRUCTION
    },
];
