//! Chapter 3.12: arithmetic and bitwise operations of DR with an operand.

use super::entry::{Effect, Entry, OperandSpec};
use super::pattern::{
    COMPARED, FACTORS, INSTRUCTION, INTEGERS, VALUES, example, form, operand, source, text,
};

const VAL: OperandSpec =
    operand("val", COMPARED, "Cell, EQUI constant or number", "Buňka, konstanta EQUI nebo číslo");
const FACTOR: OperandSpec = operand(
    "val",
    source(FACTORS, VALUES),
    "Cell, EQUI constant or number",
    "Buňka, konstanta EQUI nebo číslo",
);
const MASK: OperandSpec = operand(
    "val",
    source(INTEGERS, VALUES),
    "Cell, EQUI constant or number",
    "Buňka, konstanta EQUI nebo číslo",
);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "AD",
        chapter: "3.12",
        forms: &[
            form("AD val"),
            form("AD [TYPE.]val"),
            form("AD TYPE.(val+n)"),
            form("AD CNST.number"),
            form("AD CNST.real"),
        ],
        operands: &[VAL],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Adds a value to DR.", "Přičte hodnotu k DR."),
        description: text(
            "The operand is added to DR at the operand's width: a BYTE works on DR8, a WORD on DR16, a \
             DWORD and every constant on DR32, `QWRD.` on DR64. Bits of DR above that width stay as they \
             were: no carry goes there and the sign is not extended again. When the sum may need more \
             bits, the operand must be wider: copy it to a wider cell by LOD and STO first.\n\n\
             `REAL.` and a constant with a decimal point work on DR_REAL; the result is also written to \
             DR64, rounded. An integer operation never touches DR_REAL. RLO stays.",
            "Operand se přičte k DR ve své šířce: BYTE pracuje s DR8, WORD s DR16, DWORD a každá \
             konstanta s DR32, `QWRD.` s DR64. Bity DR nad touto šířkou zůstávají, jak byly: nepřenáší \
             se do nich a znaménko se znovu nerozšiřuje. Může-li součet potřebovat více bitů, musí být \
             operand širší: nejprve ho pomocí LOD a STO přeneste do širší buňky.\n\n\
             `REAL.` a konstanta s desetinnou tečkou pracují s DR_REAL; výsledek se zaokrouhlený zapíše \
             i do DR64. Celočíselná operace se DR_REAL nikdy nedotkne. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  PARTS\n", "        AD   CNST.10\n", "        STO  PARTS"),
            "Adds 10 to a cell. The sum is made on 32 bits, STO keeps what fits.",
            "Přičte k buňce 10. Součet se počítá na 32 bitech, STO uloží, co se vejde.",
        )],
        related: &["SU", "LOD", "MULB", "INR"],
        ..INSTRUCTION
    },
    Entry {
        name: "SU",
        chapter: "3.12",
        forms: &[
            form("SU val"),
            form("SU [TYPE.]val"),
            form("SU TYPE.(val+n)"),
            form("SU CNST.number"),
            form("SU CNST.real"),
        ],
        operands: &[VAL],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Subtracts a value from DR.", "Odečte hodnotu od DR."),
        description: text(
            "The operand is subtracted from DR at the operand's width: a BYTE works on DR8, a WORD on \
             DR16, a DWORD and every constant on DR32, `QWRD.` on DR64. Bits of DR above that width stay \
             as they were: no carry goes there and the sign is not extended again. When the difference \
             may need more bits, the operand must be wider: copy it to a wider cell by LOD and STO \
             first.\n\n\
             `REAL.` and a constant with a decimal point work on DR_REAL; the result is also written to \
             DR64, rounded. An integer operation never touches DR_REAL. RLO stays.",
            "Operand se odečte od DR ve své šířce: BYTE pracuje s DR8, WORD s DR16, DWORD a každá \
             konstanta s DR32, `QWRD.` s DR64. Bity DR nad touto šířkou zůstávají, jak byly: nepřenáší \
             se do nich a znaménko se znovu nerozšiřuje. Může-li rozdíl potřebovat více bitů, musí být \
             operand širší: nejprve ho pomocí LOD a STO přeneste do širší buňky.\n\n\
             `REAL.` a konstanta s desetinnou tečkou pracují s DR_REAL; výsledek se zaokrouhlený zapíše \
             i do DR64. Celočíselná operace se DR_REAL nikdy nedotkne. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  POS\n", "        SU   TARGET\n", "        STO  REMAINS"),
            "The way that remains.",
            "Zbývající dráha.",
        )],
        related: &["AD", "LOD", "MULB", "INR"],
        ..INSTRUCTION
    },
    Entry {
        name: "MULB",
        chapter: "3.12",
        forms: &[
            form("MULB val"),
            form("MULB [TYPE.]val"),
            form("MULB TYPE.(val+n)"),
            form("MULB CNST.number"),
            form("MULB CNST.real"),
        ],
        operands: &[FACTOR],
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Multiplies DR by a value, with sign.", "Vynásobí DR hodnotou, se znaménkem."),
        description: text(
            "Signed: DR8 times a BYTE, DR16 times a WORD, DR32 times a DWORD or a constant. The product \
             has double width and is then sign-extended to all 64 bits of DR, so that a DIVB may follow \
             at once. `QWRD.` is not possible.\n\n\
             `REAL.` and a constant with a decimal point multiply DR_REAL; DR64 gets the rounded result. \
             RLO stays.",
            "Se znaménkem: DR8 krát BYTE, DR16 krát WORD, DR32 krát DWORD nebo konstanta. Součin má \
             dvojnásobnou šířku a znaménkově se rozšíří na všech 64 bitů DR, takže hned může následovat \
             DIVB. `QWRD.` použít nelze.\n\n\
             `REAL.` a konstanta s desetinnou tečkou násobí DR_REAL; do DR64 se zapíše zaokrouhlený \
             výsledek. RLO se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LOD  SPEED\n",
                "        MULB CNST.3\n",
                "        DIVB CNST.4\n",
                "        STO  SPEED"
            ),
            "Three quarters of a speed without losing bits on the way.",
            "Tři čtvrtiny rychlosti, aniž se cestou ztratí bity.",
        )],
        related: &["DIVB", "AD", "RL"],
        ..INSTRUCTION
    },
    Entry {
        name: "DIVB",
        chapter: "3.12",
        forms: &[
            form("DIVB val"),
            form("DIVB [TYPE.]val"),
            form("DIVB TYPE.(val+n)"),
            form("DIVB CNST.number"),
            form("DIVB CNST.real"),
        ],
        operands: &[FACTOR],
        reads: &[Effect::Dr64, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Dr64, Effect::DrReal],
        summary: text("Divides DR by a value, with sign.", "Vydělí DR hodnotou, se znaménkem."),
        description: text(
            "Signed division rounding toward zero; no remainder is kept. The dividend depends on the \
             divisor: a BYTE divides DR16, a WORD divides DR32, a DWORD or a constant divides all 64 \
             bits of DR. For these the upper half must be valid, which it is after LOD, MULB and DIVB, \
             but not after AD, SU or INR; the editor warns of a stale one. The quotient is sign-extended \
             to 64 bits. `QWRD.` is not possible.\n\n\
             Division by zero and an integer quotient that does not fit stop the PLC with a run-time \
             fault that names the line; a constant zero is an error at compile time (this \
             implementation). `REAL.` and a constant with a decimal point divide DR_REAL. RLO stays.",
            "Dělení se znaménkem, zaokrouhluje se k nule, zbytek se neuchovává. Dělenec závisí na \
             děliteli: BYTE dělí DR16, WORD dělí DR32, DWORD a konstanta dělí všech 64 bitů DR. U nich \
             musí platit i horní polovina, což platí po LOD, MULB a DIVB, ale ne po AD, SU nebo INR; na \
             neplatnou upozorní editor. Podíl se znaménkově rozšíří na 64 bitů. `QWRD.` použít nelze.\n\n\
             Dělení nulou a celočíselný podíl, který se nevejde, zastaví PLC chybou za běhu s udáním \
             řádku; konstantní nula je chyba při překladu (tato implementace). `REAL.` a konstanta s \
             desetinnou tečkou dělí DR_REAL. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  TOTAL\n", "        DIVB COUNT\n", "        STO  AVERAGE"),
            "The quotient; check COUNT for zero before.",
            "Podíl; COUNT předtím otestujte na nulu.",
        )],
        related: &["MULB", "LOD", "RR"],
        ..INSTRUCTION
    },
    Entry {
        name: "ORB",
        chapter: "3.12",
        forms: &[form("ORB val"), form("ORB [TYPE.]val"), form("ORB TYPE.(val+n)"), form("ORB CNST.number")],
        operands: &[MASK],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("ORs DR with a value bit by bit.", "Logický součet DR s hodnotou po bitech."),
        description: text(
            "Bit by bit OR of DR and the operand at the operand's width, as for AD: a BYTE works on DR8, \
             a WORD on DR16, a DWORD and every constant on DR32, `QWRD.` on DR64 (this implementation). \
             The bits of DR above stay. Reals are not possible. RLO stays.",
            "Provede logický součet DR a operandu po jednotlivých bitech v šířce operandu, stejně jako u \
             AD: BYTE pracuje s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64 (tato \
             implementace). Vyšší bity DR se nemění. Reálné operandy nejsou možné. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  FLAGS\n", "        ORB  BYTE.81h\n", "        STO  FLAGS"),
            "Sets bits 0 and 7.",
            "Nastaví bity 0 a 7.",
        )],
        related: &["ANDB", "XORB", "LOD", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "ANDB",
        chapter: "3.12",
        forms: &[
            form("ANDB val"),
            form("ANDB [TYPE.]val"),
            form("ANDB TYPE.(val+n)"),
            form("ANDB CNST.number"),
        ],
        operands: &[MASK],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("ANDs DR with a value bit by bit.", "Logický součin DR s hodnotou po bitech."),
        description: text(
            "Bit by bit AND of DR and the operand at the operand's width, as for AD: a BYTE works on \
             DR8, a WORD on DR16, a DWORD and every constant on DR32, `QWRD.` on DR64 (this \
             implementation). The bits of DR above stay. Reals are not possible. RLO stays.",
            "Provede logický součin DR a operandu po jednotlivých bitech v šířce operandu, stejně jako u \
             AD: BYTE pracuje s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64 (tato \
             implementace). Vyšší bity DR se nemění. Reálné operandy nejsou možné. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  P1IN\n", "        ANDB CNST.0Fh\n", "        STO  CODE"),
            "Keeps the lower four bits of a port and clears the sign extension.",
            "Ponechá spodní čtyři bity portu a odstraní znaménkové rozšíření.",
        )],
        related: &["ORB", "XORB", "LOD", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "XORB",
        chapter: "3.12",
        forms: &[
            form("XORB val"),
            form("XORB [TYPE.]val"),
            form("XORB TYPE.(val+n)"),
            form("XORB CNST.number"),
        ],
        operands: &[MASK],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("XORs DR with a value bit by bit.", "Nonekvivalence DR s hodnotou po bitech."),
        description: text(
            "Bit by bit XOR of DR and the operand at the operand's width, as for AD: a BYTE works on \
             DR8, a WORD on DR16, a DWORD and every constant on DR32, `QWRD.` on DR64 (this \
             implementation). The bits of DR above stay. Reals are not possible. RLO stays.",
            "Provede nonekvivalenci DR a operandu po jednotlivých bitech v šířce operandu, stejně jako u \
             AD: BYTE pracuje s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64 (tato \
             implementace). Vyšší bity DR se nemění. Reálné operandy nejsou možné. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  INPUTS\n", "        XORB LAST_INPUTS\n", "        STO  CHANGED"),
            "Bits that differ between two cells.",
            "Bity, ve kterých se dvě buňky liší.",
        )],
        related: &["ORB", "ANDB", "LOD", "CONDR"],
        ..INSTRUCTION
    },
];
