//! Chapter 3.18: text and binary strings.

use super::entry::{Access, Effect, Entry, Equation, OperandKind, OperandSpec, Place};
use super::pattern::{DECLARATION, INSTRUCTION, MAX_LENGTH, example, form, operand, text};

const TARGET: OperandSpec = operand(
    "text1",
    OperandKind::Text(Access::Write),
    "Text declared by STR, with an optional offset `+n` or `+BX`",
    "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
);
const SOURCE_OR_LITERAL: OperandSpec = operand(
    "text2",
    OperandKind::TextOrLiteral,
    "Text declared by STR with an optional offset, or a literal in apostrophes",
    "Text deklarovaný STR s případným posunem, nebo řetězec v apostrofech",
);
const NUM: OperandSpec =
    operand("num", OperandKind::Number { min: 0, max: 0xFF_FFFF }, "Number of characters", "Počet znaků")
        .or_nothing();
const WIDTH: OperandSpec = operand(
    "width",
    OperandKind::Keyword(&["DWRD"]),
    "Width of DR; without it 16 bits",
    "Šířka DR; bez operandu 16 bitů",
)
.or_nothing();
const COMPARED_TEXT: OperandSpec = operand(
    "text1",
    OperandKind::Text(Access::Read),
    "Text declared by STR, with an optional offset `+n` or `+BX`",
    "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
);
const SOURCE: OperandSpec = operand(
    "text2",
    OperandKind::Text(Access::Read),
    "Text declared by STR, with an optional offset",
    "Text deklarovaný STR, případně s posunem",
);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "STR",
        chapter: "3.18",
        forms: &[
            form("name: STR n"),
            form("name: STR n, 'text'"),
            form("name: STR n, PLC_MEM_BACKUP+offset"),
            form("name: STR n, cell+offset"),
        ],
        operands: &[
            operand(
                "n",
                OperandKind::Number { min: 1, max: MAX_LENGTH },
                "Most characters it may hold; one more byte is reserved for the terminating zero",
                "Největší počet znaků; na koncovou nulu se vyhradí bajt navíc",
            ),
            operand(
                "source",
                OperandKind::LiteralOrAddress,
                "Initial text in apostrophes, or memory to lay the text over",
                "Počáteční text v apostrofech, nebo paměť, přes kterou se text překryje",
            )
            .or_nothing(),
        ],
        place: Place::AnyModule,
        writes: &[Effect::Memory],
        summary: text("Declares a text of at most n characters.", "Deklaruje text o nejvýše n znacích."),
        description: text(
            "Reserves `n` bytes and one more for the terminating zero; the label is known in all files. \
             With a literal, which may have at most `n` characters, the text is filled in whenever a new \
             program is loaded; without it the text is empty (this implementation).\n\n\
             With `PLC_MEM_BACKUP+offset` the text lies in the backed-up memory, with a cell it is laid \
             over that cell, which must be declared in the same file. These forms reserve nothing; `n` + \
             1 bytes must be there.",
            "Vyhradí `n` bajtů a jeden navíc na koncovou nulu; návěští platí ve všech souborech. Řetězec \
             v apostrofech smí mít nejvýše `n` znaků a naplní se při každém zavedení nového programu; \
             bez něj je text prázdný (tato implementace).\n\n\
             Se zápisem `PLC_MEM_BACKUP+posun` leží text v zálohované paměti, s buňkou se překrývá přes \
             tuto buňku, která musí být deklarována v témže souboru. Tyto tvary nic nevyhrazují; `n` + 1 \
             bajtů tam musí být k dispozici.",
        ),
        examples: &[example(
            concat!("TITLE:  STR 20,'Coolant low'\n", "NAME:   STR 8"),
            "A text with a content and an empty one.",
            "Text s počátečním obsahem a prázdný text.",
        )],
        related: &["STRCPY", "STRADD", "STRCMP"],
        ..DECLARATION
    },
    Entry {
        name: "STRCPY",
        chapter: "3.18",
        forms: &[
            form("STRCPY text1, text2 [,num]"),
            form("STRCPY text1, 'literal'"),
            form("STRCPY text1+offset, text2+offset [,num]"),
        ],
        operands: &[TARGET, SOURCE_OR_LITERAL, NUM],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Copies a text; the destination comes first.", "Zkopíruje text; cíl se píše první."),
        description: text(
            "Without `num` it copies up to and including the terminating zero, but never past the size \
             of the destination. With `num` it stops at the first of: the zero, which is copied, the \
             size of the destination, `num` characters; in the last two cases no zero is written and the \
             destination is not shortened. The byte behind its last character always stays zero (this \
             implementation). RLO and DR stay.",
            "Bez `num` kopíruje až po koncovou nulu včetně, nikdy ale přes velikost cíle. S `num` skončí \
             u prvního z těchto případů: nula (ta se zkopíruje), velikost cíle, `num` znaků; ve druhých \
             dvou se nula nezapíše a cíl se nezkrátí. Bajt za posledním znakem cíle zůstává vždy nulový \
             (tato implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("        STRCPY NAME,'AXIS'\n", "        STRCPY NAME+5,TITLE,3"),
            "A literal, then three characters behind it.",
            "Řetězec a za něj tři znaky.",
        )],
        related: &["STRADD", "STR", "MEMCPY"],
        ..INSTRUCTION
    },
    Entry {
        name: "STRADD",
        chapter: "3.18",
        forms: &[form("STRADD text1, text2"), form("STRADD text1, 'literal'")],
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::ReadWrite),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            SOURCE_OR_LITERAL,
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Appends a text to another.", "Připojí text na konec jiného textu."),
        description: text(
            "Appends at the place of the terminating zero of `text1` and cuts what does not fit its size \
             (this implementation). RLO and DR stay.",
            "Připojuje od koncové nuly textu `text1`; co se do jeho velikosti nevejde, se usekne (tato \
             implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("        STRCPY LINE,'Tool '\n", "        STRADD LINE,NUMBER"),
            "Builds a line from two parts.",
            "Sestaví řádek ze dvou částí.",
        )],
        related: &["STRCPY", "BINSTR"],
        ..INSTRUCTION
    },
    Entry {
        name: "BINSTR",
        chapter: "3.18",
        forms: &[form("BINSTR text1"), form("BINSTR text1, DWRD")],
        operands: &[TARGET, WIDTH],
        reads: &[Effect::Dr],
        writes: &[Effect::Memory],
        summary: text(
            "Writes the binary number in DR as decimal digits.",
            "Zapíše binární číslo z DR jako desítkové číslice.",
        ),
        description: text(
            "The size of `text1`, 1 to 10, gives the number of digits; missing ones are zeros. DR16 is \
             taken, with `DWRD` DR32, without sign; of a longer number the lower digits remain (this \
             implementation). RLO and DR stay.",
            "Počet číslic určuje velikost textu `text1`, 1 až 10; chybějící se doplní nulami. Bere se \
             DR16, s `DWRD` DR32, bez znaménka; z delšího čísla zůstanou spodní číslice (tato \
             implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("NUMBER: STR 4\n", "        LOD  PARTS\n", "        BINSTR NUMBER"),
            "37 becomes the text 0037.",
            "Z hodnoty 37 vznikne text 0037.",
        )],
        related: &["BCDSTR", "STRADD"],
        ..INSTRUCTION
    },
    Entry {
        name: "BCDSTR",
        chapter: "3.18",
        forms: &[form("BCDSTR text1"), form("BCDSTR text1, DWRD")],
        operands: &[TARGET, WIDTH],
        reads: &[Effect::Dr],
        writes: &[Effect::Memory],
        summary: text("Writes the BCD number in DR as digits.", "Zapíše BCD číslo z DR jako číslice."),
        description: text(
            "As BINSTR, but DR holds BCD digits. RLO and DR stay.",
            "Totéž co BINSTR, v DR jsou ale BCD číslice. RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("CODE:   STR 2\n", "        LOD  PB06\n", "        BCDSTR CODE"),
            "19h becomes the text 19.",
            "Z hodnoty 19h vznikne text 19.",
        )],
        related: &["BINSTR", "BIN"],
        ..INSTRUCTION
    },
    Entry {
        name: "STRCMP",
        chapter: "3.18",
        forms: &[
            form("STRCMP text1, text2 [,num]"),
            form("STRCMP text1, 'literal' [,num]"),
            form("STRCMP text1+offset, text2+offset [,num]"),
        ],
        operands: &[COMPARED_TEXT, SOURCE_OR_LITERAL, NUM],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text("Sets RLO when two texts are equal.", "Nastaví RLO, když jsou dva texty shodné."),
        description: text(
            "With `num` it compares at most `num` characters and ends sooner at a difference or at a \
             terminating zero. Without `num` it compares the length of `text2` with its terminating \
             zero, so a longer `text1` is not equal (this implementation for a literal). RLO is \
             overwritten without a push; DR stays.",
            "S `num` porovná nejvýše `num` znaků a skončí dříve při rozdílu nebo na koncové nule. Bez \
             `num` porovná celý `text2` i s koncovou nulou, delší `text1` tedy shodný není (tato \
             implementace i pro řetězec v apostrofech). RLO se přepíše bez uložení na zásobník, DR se \
             nemění.",
        ),
        examples: &[example(
            concat!("        STRCMP NAME,'AXIS',4\n", "        WR   IS_AXIS"),
            "Tests the first four characters.",
            "Testuje první čtyři znaky.",
        )],
        related: &["MEMCMP", "STRCPY"],
        ..INSTRUCTION
    },
    Entry {
        name: "MEMCPY",
        chapter: "3.18",
        forms: &[form("MEMCPY text1, text2 [,num]"), form("MEMCPY text1+offset, text2+offset [,num]")],
        operands: &[TARGET, SOURCE, NUM],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Copies binary data; a zero byte does not end the copy.",
            "Zkopíruje binární data; nulový bajt kopírování neukončí.",
        ),
        description: text(
            "As STRCPY, but zeros are data: it copies `num` bytes, without `num` as many as both texts \
             hold (this implementation). RLO and DR stay.",
            "Totéž co STRCPY, nuly jsou ale data: zkopíruje `num` bajtů, bez `num` tolik, kolik pojmou \
             oba texty (tato implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            "        MEMCPY PACKET+4,VALUES,8",
            "Copies 8 bytes behind a head of 4.",
            "Zkopíruje 8 bajtů za čtyřbajtovou hlavičku.",
        )],
        related: &["MEMCMP", "STRCPY", "MV"],
        ..INSTRUCTION
    },
    Entry {
        name: "MEMCMP",
        chapter: "3.18",
        forms: &[form("MEMCMP text1, text2 [,num]"), form("MEMCMP text1+offset, text2+offset [,num]")],
        operands: &[COMPARED_TEXT, SOURCE, NUM],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when two blocks of binary data are equal.",
            "Nastaví RLO, když jsou dva bloky binárních dat shodné.",
        ),
        description: text(
            "As STRCMP, but zeros are data: it compares `num` bytes, without `num` the size of `text2`. \
             RLO is overwritten without a push; DR stays.",
            "Totéž co STRCMP, nuly jsou ale data: porovná `num` bajtů, bez `num` velikost textu `text2`. \
             RLO se přepíše bez uložení na zásobník, DR se nemění.",
        ),
        examples: &[example(
            concat!("        MEMCMP PACKET,EXPECTED,12\n", "        WR   AS_EXPECTED"),
            "Compares 12 bytes.",
            "Porovná 12 bajtů.",
        )],
        related: &["MEMCPY", "STRCMP"],
        ..INSTRUCTION
    },
];
