//! Chapter 3.4: declarations.

use super::entry::{Entry, OperandKind, Place};
use super::pattern::{DECLARATION, MAX_LENGTH, example, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DFM",
        chapter: "3.4",
        forms: &[form("[name:] DFM [bit0],[bit1],[bit2],[bit3],[bit4],[bit5],[bit6],[bit7]")],
        operands: &[operand(
            "bit",
            OperandKind::NewBit,
            "Name of the bit at this position, d0 first; an empty place leaves the bit unnamed",
            "Jméno bitu na této pozici, první je d0; prázdné místo nechá bit bezejmenný",
        )
        .or_nothing()
        .repeated()],
        summary: text(
            "Reserves one byte and names its bits.",
            "Vyhradí jednu slabiku a pojmenuje její bity.",
        ),
        description: text(
            "One DFM always takes exactly one byte. The names belong to its bits in order: the first one \
             is bit d0 (weight 01h), the eighth is d7 (weight 80h). A position may stay empty, but its \
             comma stays; trailing commas may be left out (this implementation). More than eight \
             positions are an error.\n\n\
             With a label the same byte can also be used whole, as a BYTE variable. Without one it still \
             names its bits, which is enough for generic positions used in `ADR.bit`.\n\n\
             In DATA the names are global to the project, in DATA_LOCAL they belong to their file. The \
             byte starts as zero.",
            "Jedna instrukce DFM zabírá vždy právě jednu slabiku. Jména patří jejím bitům po řadě: první \
             je bit d0 (váha 01h), osmý d7 (váha 80h). Pozice může zůstat prázdná, čárku je ale nutné \
             ponechat; čárky na konci se smějí vynechat (tato implementace). Více než osm pozic je \
             chyba.\n\n\
             S návěštím lze tutéž slabiku použít i vcelku jako proměnnou typu BYTE. Bez návěští slouží \
             jen svými bity, což stačí pro obecné pozice v zápisu `ADR.bit`.\n\n\
             V modulu DATA jsou jména společná celému projektu, v DATA_LOCAL patří jen svému souboru. \
             Slabika má na začátku hodnotu nula.",
        ),
        examples: &[example(
            concat!("COOL:   DFM PUMP_ON,FILTER_OK,,LEVEL_LOW\n", "        DFM B0,B1,B2,B3,B4,B5,B6,B7"),
            "PUMP_ON is bit 0 of COOL, LEVEL_LOW bit 3, bit 2 has no name. B0 to B7 are positions for \
             any byte.",
            "PUMP_ON je bit 0 slabiky COOL, LEVEL_LOW bit 3, bit 2 jméno nemá. B0 až B7 jsou obecné \
             pozice pro libovolnou slabiku.",
        )],
        related: &["DS", "LDR", "WR"],
        ..DECLARATION
    },
    Entry {
        name: "DS",
        chapter: "3.4",
        forms: &[form("name: DS 1"), form("name: DS 2"), form("name: DS 4"), form("name: DS n")],
        operands: &[operand(
            "length",
            OperandKind::Number { min: 1, max: MAX_LENGTH },
            "Length in bytes: 1 makes a BYTE, 2 a WORD, 4 a DWORD, anything else an untyped area",
            "Délka v bajtech: 1 je BYTE, 2 WORD, 4 DWORD, cokoli jiného je oblast bez typu",
        )],
        summary: text(
            "Reserves memory and gives its label a type by the length.",
            "Vyhradí paměť a podle délky určí typ návěští.",
        ),
        description: text(
            "The length decides the type: `DS 1` declares a BYTE, `DS 2` a WORD, `DS 4` a DWORD, and the \
             instructions pick their width from it. Any other length is an area without a type, so every \
             access to it must carry a prefix (`BYTE.`, `WORD.`, `DWRD.`, `QWRD.`, `REAL.`). Reals and \
             64-bit integers live in `DS 8`.\n\n\
             The memory starts as zeros. An area can be reached with an offset: `BYTE.(TABLE+3)`.",
            "O typu rozhoduje délka: `DS 1` deklaruje BYTE, `DS 2` WORD, `DS 4` DWORD a instrukce si \
             podle toho samy volí šířku. Jakákoli jiná délka je oblast bez typu, takže každý přístup k \
             ní musí mít prefix (`BYTE.`, `WORD.`, `DWRD.`, `QWRD.`, `REAL.`). Reálná čísla a 64bitová \
             celá čísla se ukládají do `DS 8`.\n\n\
             Paměť má na začátku hodnotu nula. Do oblasti se přistupuje s posunem: `BYTE.(TABLE+3)`.",
        ),
        examples: &[example(
            concat!("PARTS:  DS 2\n", "ANGLE:  DS 8\n", "TABLE:  DS 16"),
            "PARTS is a WORD; ANGLE is read with `LOD REAL.ANGLE`, a byte of TABLE with `LOD \
             BYTE.(TABLE+3)`.",
            "PARTS je WORD; ANGLE se čte pomocí `LOD REAL.ANGLE`, slabika tabulky pomocí `LOD \
             BYTE.(TABLE+3)`.",
        )],
        related: &["DFM", "EQUI", "BYTE", "REAL"],
        ..DECLARATION
    },
    Entry {
        name: "EQUI",
        chapter: "3.4",
        forms: &[form("EQUI name, value")],
        operands: &[
            operand(
                "name",
                OperandKind::NewName,
                "Name of the constant, without a colon",
                "Jméno konstanty, bez dvojtečky",
            ),
            operand(
                "value",
                OperandKind::Number { min: -0x8000_0000, max: 0xFFFF_FFFF },
                "Integer, character or constant expression of at most 32 bits",
                "Celé číslo, znak nebo konstantní výraz o nejvýše 32 bitech",
            ),
        ],
        place: Place::Anywhere,
        summary: text(
            "Names an integer constant; no memory is reserved.",
            "Pojmenuje celočíselnou konstantu; paměť nezabírá.",
        ),
        description: text(
            "The value is a decimal, hexadecimal (`0F8h`) or binary (`0101b`) number, a character in \
             apostrophes or an expression of constants such as `LIMIT+2`; a sign may stand before it. In \
             an instruction the constant acts like `CNST.`: 32 bits wide.\n\n\
             EQUI may stand anywhere, in DATA, among instructions or before DATA. The name is known in \
             the whole project; two different values for one name are an error (this implementation).",
            "Hodnotou je desítkové, šestnáctkové (`0F8h`) nebo dvojkové (`0101b`) číslo, znak v \
             apostrofech nebo výraz z konstant, například `LIMIT+2`; před ním může být znaménko. V \
             instrukci se konstanta chová jako `CNST.`, má tedy 32 bitů.\n\n\
             EQUI může stát kdekoli: v modulu DATA, mezi instrukcemi i před DATA. Jméno platí v celém \
             projektu; dvě různé hodnoty téhož jména jsou chyba (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "EQUI CLAMP_TIME,150\n",
                "EQUI ERR_CLAMP,31h\n",
                "        TEX0 -,CLAMP_TIME,FAULT,ERR_CLAMP"
            ),
            "A time of 150 cycles (3 s) and the number of a message, both under a name.",
            "Čas 150 cyklů (3 s) a číslo hlášení, obojí pod jménem.",
        )],
        related: &["DS", "CNST"],
        ..DECLARATION
    },
];
