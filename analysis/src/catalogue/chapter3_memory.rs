//! Chapters 3.15 and 3.16: conversions between RLO, DR and DR_REAL, blocks of memory.

use super::entry::{Access, Effect, Entry, Equation, OperandKind};
use super::pattern::{INSTRUCTION, example, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CONDR",
        chapter: "3.15",
        forms: &[form("CONDR"), form("CONDR DWRD"), form("CONDR n")],
        operands: &[operand(
            "which",
            OperandKind::KeywordOrNumber(&["DWRD"], 0, 31),
            "DWRD tests 32 bits; a number 0 to 31 picks one bit; without it 16 bits are tested",
            "DWRD testuje 32 bitů; číslo 0 až 31 vybere jeden bit; bez operandu se testuje 16 bitů",
        )
        .or_nothing()],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO from DR: 0 when DR is zero, otherwise 1, or one bit of DR.",
            "Naplní RLO z DR: 0 při nulovém DR, jinak 1, nebo jeden bit DR.",
        ),
        description: text(
            "Without operand RLO is 0 when DR16 is zero, otherwise 1; `DWRD` tests DR32. With a number \
             from 0 to 31 RLO takes over that bit of DR. DR stays. RLO is overwritten without a push; \
             CONDR is no terminal instruction.",
            "Bez operandu je RLO 0 při nulovém DR16, jinak 1; `DWRD` testuje DR32. S číslem 0 až 31 \
             převezme RLO příslušný bit DR. DR se nemění. RLO se přepíše bez uložení na zásobník; CONDR \
             není koncová instrukce.",
        ),
        examples: &[example(
            concat!("        LOD  STATUS\n", "        CONDR 3\n", "        WR   READY"),
            "READY is bit 3 of the cell.",
            "READY je bit 3 buňky.",
        )],
        related: &["CONRD", "EQ", "LDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "CONRD",
        chapter: "3.15",
        forms: &[form("CONRD"), form("CONRD DWRD")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Dr],
        summary: text("Fills DR with zeros or ones by RLO.", "Naplní DR nulami nebo jedničkami podle RLO."),
        description: text(
            "RLO = 0 makes DR16 zero, RLO = 1 makes it FFFFh; `DWRD` does the same with DR32. The bits \
             above the width stay (this implementation). RLO stays. Terminal instruction.",
            "RLO = 0 vynuluje DR16, RLO = 1 ho naplní hodnotou FFFFh; `DWRD` udělá totéž s DR32. Bity \
             nad touto šířkou se nemění (tato implementace). RLO se nemění. Koncová instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LDR  ENABLE\n",
                "        CONRD\n",
                "        ANDB SPEED\n",
                "        STO  SPEED_OUT"
            ),
            "Passes the WORD SPEED only while ENABLE is 1.",
            "Propustí hodnotu WORD SPEED, jen když je ENABLE 1.",
        )],
        related: &["CONDR", "ANDB"],
        ..INSTRUCTION
    },
    Entry {
        name: "MV",
        chapter: "3.15",
        forms: &[form("MV src, dest, num"), form("MV src+n, dest+m, num")],
        operands: &[
            operand(
                "src",
                OperandKind::Address(Access::Read),
                "Address to copy from",
                "Adresa, odkud se kopíruje",
            ),
            operand(
                "dest",
                OperandKind::Address(Access::Write),
                "Address to copy to",
                "Adresa, kam se kopíruje",
            ),
            operand("num", OperandKind::Number { min: 0, max: 0xFF_FFFF }, "Number of bytes", "Počet bajtů"),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies a block of memory; the source comes first.",
            "Zkopíruje blok paměti; zdroj se píše první.",
        ),
        description: text(
            "Copies `num` bytes. The source comes first, unlike in MOVE and MOVR. Both addresses may \
             carry an offset and lie in the backed-up memory PLC_MEM_BACKUP; areas that overlap are \
             copied correctly (this implementation). RLO, DR and an open equation stay.",
            "Zkopíruje `num` bajtů. Zdroj se na rozdíl od MOVE a MOVR píše první. Obě adresy mohou mít \
             posun a ležet v zálohované paměti PLC_MEM_BACKUP; překrývající se oblasti se zkopírují \
             správně (tato implementace). RLO, DR ani rozpracovaná rovnice se nemění.",
        ),
        examples: &[example(
            "        MV   TOOL_TABLE,PLC_MEM_BACKUP+100,64",
            "Saves 64 bytes of a table to the backed-up memory.",
            "Uloží 64 bajtů tabulky do zálohované paměti.",
        )],
        related: &["MOVE", "CLEAR"],
        ..INSTRUCTION
    },
    Entry {
        name: "CLEAR",
        chapter: "3.15",
        forms: &[form("CLEAR begin, end"), form("CLEAR GLOBAL, ALL"), form("CLEAR INTERNAL, ALL")],
        operands: &[
            operand(
                "begin",
                OperandKind::OneOf(&[
                    OperandKind::Address(Access::Write),
                    OperandKind::Keyword(&["GLOBAL", "INTERNAL"]),
                ]),
                "First cell, or GLOBAL or INTERNAL",
                "První buňka, nebo GLOBAL či INTERNAL",
            ),
            operand(
                "end",
                OperandKind::OneOf(&[OperandKind::Address(Access::Write), OperandKind::Keyword(&["ALL"])]),
                "Last cell, itself included, or ALL",
                "Poslední buňka (včetně ní), nebo ALL",
            ),
        ],
        writes: &[Effect::Memory],
        summary: text("Fills memory with zeros.", "Vynuluje paměť."),
        description: text(
            "`CLEAR begin, end` writes zeros from the first cell to the last one, both included (this \
             implementation). Both must lie in the same data, global or local of one file, and `begin` \
             must not lie behind `end`.\n\n\
             `CLEAR GLOBAL, ALL` clears the global data of all files together with the mechanisms, \
             `CLEAR INTERNAL, ALL` the local data and the automatic variables. Used in MODULE_CLEAR they \
             give the state after power-on. RLO and DR stay.",
            "`CLEAR begin, end` zapíše nuly od první buňky po poslední, včetně obou (tato implementace). \
             Obě musí ležet v týchž datech, globálních nebo lokálních jednoho souboru, a `begin` nesmí \
             ležet za `end`.\n\n\
             `CLEAR GLOBAL, ALL` vynuluje globální data všech souborů i s mechanismy, `CLEAR INTERNAL, \
             ALL` lokální data a automatické proměnné. V modulu MODULE_CLEAR tak uvedou program do stavu \
             po zapnutí. RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!(
                "MODULE_CLEAR\n",
                "        CLEAR GLOBAL,ALL\n",
                "        CLEAR INTERNAL,ALL\n",
                "MODULE_CLEAR_END"
            ),
            "The usual module.",
            "Obvyklá podoba modulu.",
        )],
        related: &["MODULE_CLEAR", "GLOBAL", "INTERNAL", "MV"],
        ..INSTRUCTION
    },
    Entry {
        name: "REAL",
        chapter: "3.16",
        forms: &[form("REAL"), form("REAL DWRD"), form("REAL QWRD"), form("INSTRUCTION REAL.name")],
        operands: &[operand(
            "width",
            OperandKind::Keyword(&["DWRD", "QWRD"]),
            "Width of DR; without it 16 bits",
            "Šířka DR; bez operandu 16 bitů",
        )
        .or_nothing()],
        reads: &[Effect::Dr],
        writes: &[Effect::DrReal, Effect::Dr64],
        summary: text(
            "Converts the integer in DR to a real number; as the prefix `REAL.` accesses the operand as \
             a 64-bit real.",
            "Převede celé číslo v DR na reálné; jako prefix `REAL.` přistupuje k operandu jako k \
             64bitovému reálnému číslu.",
        ),
        description: text(
            "As an instruction converts the integer in DR16 to DR_REAL; `DWRD` converts DR32, `QWRD` \
             DR64, which must be valid (after LOD, MULB, DIVB). The value is also left in DR64. It is \
             the only way from integer arithmetic back to reals, because integer operations never touch \
             DR_REAL. RLO stays.\n\n\
             As the prefix `REAL.` it accesses an 8-byte cell as a 64-bit real. It goes with LOD, STO, \
             STO1, STO0, MOVE, MOVE1, AD, SU, MULB, DIVB and the comparisons. Results are also written \
             to DR64 rounded to the nearest integer, ties to even, saturated, and 0 for a value that is \
             not a number (this implementation).",
            "Jako instrukce převede celé číslo v DR16 na DR_REAL; `DWRD` převede DR32, `QWRD` DR64, \
             které musí být platné (po LOD, MULB, DIVB). Hodnota zůstane i v DR64. Je to jediná cesta z \
             celočíselné aritmetiky zpět k reálné, protože celočíselné operace se DR_REAL nikdy \
             nedotknou. RLO se nemění.\n\n\
             Jako prefix `REAL.` přistupuje k 8bajtové buňce jako k 64bitovému reálnému číslu. Používá \
             se s LOD, STO, STO1, STO0, MOVE, MOVE1, AD, SU, MULB, DIVB a s porovnáním. Výsledky se \
             zapisují i do DR64, a to zaokrouhlené na nejbližší celé číslo, v polovině k sudému, s \
             omezením na rozsah a s nulou místo neplatného čísla (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        LOD  PARTS\n",
                "        REAL QWRD\n",
                "        MULB CNST.0.35\n",
                "        STO  REAL.WEIGHT"
            ),
            "An integer cell times a real constant.",
            "Celočíselná buňka krát reálná konstanta.",
        )],
        related: &["LOD", "MULB", "CNST", "QWRD"],
        ..INSTRUCTION
    },
];
