//! Chapter 3.13: instructions that work on DR itself.

use super::entry::{Effect, Entry, OperandKind, OperandSpec};
use super::pattern::{INSTRUCTION, SHIFT_CELLS, SHIFTS, example, form, operand, source, text};

const WIDTH_OR_REAL: OperandSpec = operand(
    "width",
    OperandKind::Keyword(&["DWRD", "QWRD", "REAL"]),
    "Width of DR; without it 16 bits",
    "Šířka DR; bez operandu 16 bitů",
)
.or_nothing();
const WIDTH_DWRD: OperandSpec = operand(
    "width",
    OperandKind::Keyword(&["DWRD"]),
    "Width of DR; without it 16 bits",
    "Šířka DR; bez operandu 16 bitů",
)
.or_nothing();
const N: OperandSpec = operand(
    "n",
    source(SHIFTS, SHIFT_CELLS),
    "Number of places: a constant or a cell of 8 bits",
    "Počet míst: konstanta nebo 8bitová buňka",
);
const WIDTH: OperandSpec = operand(
    "width",
    OperandKind::Keyword(&["DWRD", "QWRD"]),
    "Width of DR; without it 16 bits",
    "Šířka DR; bez operandu 16 bitů",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "INR",
        chapter: "3.13",
        forms: &[form("INR"), form("INR DWRD"), form("INR QWRD"), form("INR REAL")],
        operands: &[WIDTH_OR_REAL],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Adds one to DR.", "Zvětší DR o jedničku."),
        description: text(
            "Adds one to DR16 and wraps around its range; `DWRD` takes DR32, `QWRD` DR64. The bits of DR \
             above the width stay, so a 32-bit value needs `DWRD`. `REAL` works on DR_REAL and writes \
             the rounded result also to DR64. RLO stays.",
            "Přičte jedničku k DR16, po překročení rozsahu přeteče; s `DWRD` pracuje s DR32, s `QWRD` s \
             DR64. Bity DR nad touto šířkou se nemění, 32bitová hodnota proto potřebuje `DWRD`. `REAL` \
             pracuje s DR_REAL a zaokrouhlený výsledek zapíše i do DR64. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  PARTS\n", "        INR\n", "        STO  PARTS"),
            "Changes a BYTE or WORD cell by one.",
            "Změní buňku BYTE nebo WORD o jedničku.",
        )],
        related: &["DCR", "AD", "INRBCD"],
        ..INSTRUCTION
    },
    Entry {
        name: "DCR",
        chapter: "3.13",
        forms: &[form("DCR"), form("DCR DWRD"), form("DCR QWRD"), form("DCR REAL")],
        operands: &[WIDTH_OR_REAL],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Subtracts one from DR.", "Zmenší DR o jedničku."),
        description: text(
            "Subtracts one from DR16 and wraps around its range; `DWRD` takes DR32, `QWRD` DR64. The \
             bits of DR above the width stay, so a 32-bit value needs `DWRD`. `REAL` works on DR_REAL \
             and writes the rounded result also to DR64. RLO stays.",
            "Odečte jedničku od DR16, po překročení rozsahu přeteče; s `DWRD` pracuje s DR32, s `QWRD` s \
             DR64. Bity DR nad touto šířkou se nemění, 32bitová hodnota proto potřebuje `DWRD`. `REAL` \
             pracuje s DR_REAL a zaokrouhlený výsledek zapíše i do DR64. RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  PARTS\n", "        DCR\n", "        STO  PARTS"),
            "Changes a BYTE or WORD cell by one.",
            "Změní buňku BYTE nebo WORD o jedničku.",
        )],
        related: &["INR", "SU", "INRBCD"],
        ..INSTRUCTION
    },
    Entry {
        name: "INRBCD",
        chapter: "3.13",
        forms: &[form("INRBCD")],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Adds one to DR in BCD.", "Zvětší DR o jedničku v kódu BCD."),
        description: text(
            "Adds one to DR16 as to a BCD number of four digits; 9999 is followed by 0. A digit above 9 \
             is a run-time fault (this implementation). The upper bits of DR and RLO stay.",
            "Přičte jedničku k DR16 jako ke čtyřmístnému BCD číslu; po 9999 následuje 0. Číslice větší \
             než 9 způsobí chybu za běhu (tato implementace). Vyšší bity DR ani RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  TOOL_BCD\n", "        INRBCD\n", "        STO  TOOL_BCD"),
            "From 09h to 10h.",
            "Z 09h na 10h.",
        )],
        related: &["INR", "BCD", "CUBCD"],
        ..INSTRUCTION
    },
    Entry {
        name: "BIN",
        chapter: "3.13",
        forms: &[form("BIN"), form("BIN DWRD")],
        operands: &[WIDTH_DWRD],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Converts DR from BCD to binary.", "Převede DR z kódu BCD do binárního kódu."),
        description: text(
            "Reads DR16 as four BCD digits and leaves the binary value there; `DWRD` converts eight \
             digits in DR32, where bit 31 set before means a negative number. A digit above 9 is a \
             run-time fault (this implementation). The bits above the width and RLO stay.",
            "Čte DR16 jako čtyři BCD číslice a ponechá v něm binární hodnotu; s `DWRD` převede osm \
             číslic v DR32, přičemž předem nastavený bit 31 znamená záporné číslo. Číslice větší než 9 \
             způsobí chybu za běhu (tato implementace). Bity nad touto šířkou ani RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  PB06\n", "        BIN\n", "        STO  M_CODE"),
            "M19 arrives as 19h, M_CODE is 19.",
            "M19 přijde jako 19h, v M_CODE bude 19.",
        )],
        related: &["BCD", "INRBCD"],
        ..INSTRUCTION
    },
    Entry {
        name: "BCD",
        chapter: "3.13",
        forms: &[form("BCD"), form("BCD DWRD")],
        operands: &[WIDTH_DWRD],
        reads: &[Effect::Dr],
        writes: &[Effect::Dr],
        summary: text("Converts DR from binary to BCD.", "Převede DR z binárního kódu do kódu BCD."),
        description: text(
            "Converts the binary value in DR16 to BCD digits; it may be 0 to 9999, with `DWRD` 0 to \
             99999999 in DR32. A value outside is a run-time fault (this implementation). The bits above \
             the width and RLO stay.",
            "Převede binární hodnotu v DR16 na BCD číslice; smí být 0 až 9999, s `DWRD` 0 až 99999999 v \
             DR32. Hodnota mimo rozsah způsobí chybu za běhu (tato implementace). Bity nad touto šířkou \
             ani RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  PARTS\n", "        BCD\n", "        STO  DISPLAY"),
            "Prepares a number for a BCD display.",
            "Připraví číslo pro BCD displej.",
        )],
        related: &["BIN", "INRBCD"],
        ..INSTRUCTION
    },
    Entry {
        name: "RL",
        chapter: "3.13",
        forms: &[form("RL n"), form("RL [TYPE.]n"), form("RL [TYPE.]n, DWRD"), form("RL [TYPE.]n, QWRD")],
        operands: &[N, WIDTH],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("Shifts DR left, filling with zeros.", "Posune DR vlevo, zprava doplní nuly."),
        description: text(
            "Shifts DR16 to the left by `n` places and fills with zeros; `DWRD` shifts DR32, `QWRD` \
             DR64. It is a logic shift: bits that leave are lost and nothing rotates. A count of the \
             width or more gives 0 (this implementation). The count is a constant or a cell of 8 bits. \
             The bits of DR above the width and RLO stay.",
            "Posune DR16 vlevo o `n` míst a uvolněná místa doplní nulami; s `DWRD` posouvá DR32, s \
             `QWRD` DR64. Jde o logický posuv: vysunuté bity se ztratí, nic nerotuje. Posun o celou \
             šířku nebo více dá 0 (tato implementace). Počet míst je konstanta nebo 8bitová buňka. Bity \
             DR nad touto šířkou ani RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  INDEX\n", "        RL   CNST.2\n", "        MOV  BX,CX"),
            "Index times four, for cells of 32 bits.",
            "Index krát čtyři, pro 32bitové buňky.",
        )],
        related: &["RR", "MULB", "ANDB"],
        ..INSTRUCTION
    },
    Entry {
        name: "RR",
        chapter: "3.13",
        forms: &[form("RR n"), form("RR [TYPE.]n"), form("RR [TYPE.]n, DWRD"), form("RR [TYPE.]n, QWRD")],
        operands: &[N, WIDTH],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr],
        summary: text("Shifts DR right, filling with zeros.", "Posune DR vpravo, zleva doplní nuly."),
        description: text(
            "Shifts DR16 to the right by `n` places and fills with zeros; `DWRD` shifts DR32, `QWRD` \
             DR64. It is a logic shift: bits that leave are lost and nothing rotates. A count of the \
             width or more gives 0 (this implementation). The count is a constant or a cell of 8 bits. \
             The bits of DR above the width and RLO stay.",
            "Posune DR16 vpravo o `n` míst a uvolněná místa doplní nulami; s `DWRD` posouvá DR32, s \
             `QWRD` DR64. Jde o logický posuv: vysunuté bity se ztratí, nic nerotuje. Posun o celou \
             šířku nebo více dá 0 (tato implementace). Počet míst je konstanta nebo 8bitová buňka. Bity \
             DR nad touto šířkou ani RLO se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  BYTE.CODE\n", "        RR   4\n", "        ANDB CNST.0Fh"),
            "The upper digit of a BCD byte.",
            "Horní číslice BCD slabiky.",
        )],
        related: &["RL", "DIVB", "ANDB"],
        ..INSTRUCTION
    },
    Entry {
        name: "INV",
        chapter: "3.13",
        forms: &[form("INV"), form("INV DWRD"), form("INV QWRD"), form("INV REAL")],
        operands: &[WIDTH_OR_REAL],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Changes the sign of DR (two's complement).", "Změní znaménko DR (dvojkový doplněk)."),
        description: text(
            "Negates DR16 arithmetically (two's complement, not a bit by bit negation: for that use \
             `XORB` with ones); `DWRD` takes DR32, `QWRD` DR64, `REAL` changes the sign of DR_REAL and \
             writes the result also to DR64. The smallest negative number stays as it is. The bits above \
             the width and RLO stay.",
            "Aritmeticky neguje DR16 (dvojkový doplněk, nikoli negace po bitech: na tu je `XORB` s \
             jedničkami); s `DWRD` pracuje s DR32, s `QWRD` s DR64, `REAL` změní znaménko DR_REAL a \
             výsledek zapíše i do DR64. Nejmenší záporné číslo se nezmění. Bity nad touto šířkou ani RLO \
             se nemění.",
        ),
        examples: &[example(
            concat!("        LOD  STEP\n", "        INV\n", "        STO  STEP"),
            "Turns the direction of a step.",
            "Obrátí směr kroku.",
        )],
        related: &["ABS", "XORB", "LOD"],
        ..INSTRUCTION
    },
    Entry {
        name: "ABS",
        chapter: "3.13",
        forms: &[form("ABS"), form("ABS DWRD"), form("ABS QWRD"), form("ABS REAL")],
        operands: &[WIDTH_OR_REAL],
        reads: &[Effect::Dr, Effect::DrReal],
        writes: &[Effect::Dr, Effect::DrReal],
        summary: text("Replaces DR by its absolute value.", "Nahradí DR jeho absolutní hodnotou."),
        description: text(
            "Absolute value of DR16; `DWRD` takes DR32, `QWRD` DR64, `REAL` works on DR_REAL and writes \
             the result also to DR64. The smallest negative number stays as it is. The bits above the \
             width and RLO stay.",
            "Absolutní hodnota DR16; s `DWRD` pracuje s DR32, s `QWRD` s DR64, `REAL` pracuje s DR_REAL \
             a výsledek zapíše i do DR64. Nejmenší záporné číslo se nezmění. Bity nad touto šířkou ani \
             RLO se nemění.",
        ),
        examples: &[example(
            concat!(
                "        LOD  DWRD.DIFCIT_X\n",
                "        ABS  DWRD\n",
                "        GT   TOLERANCE\n",
                "        WR   OUT_OF_POS"
            ),
            "Tests a position error in both directions.",
            "Testuje polohovou odchylku v obou směrech.",
        )],
        related: &["INV", "GT"],
        ..INSTRUCTION
    },
];
