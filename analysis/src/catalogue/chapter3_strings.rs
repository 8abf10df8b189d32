//! Chapter 3.18: text and binary strings.

use super::entry::{Access, Effect, Entry, Equation, OperandKind, Place};
use super::pattern::{DECLARATION, INSTRUCTION, form, operand, text};

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
                OperandKind::Number { min: 1, max: 0xFF_FFFF },
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
        executable: false,
        summary: text("Declares a text of at most n characters.", "Deklaruje text o nejvýše n znacích."),
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
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Write),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "text2",
                OperandKind::TextOrLiteral,
                "Text declared by STR with an optional offset, or a literal in apostrophes",
                "Text deklarovaný STR s případným posunem, nebo řetězec v apostrofech",
            ),
            operand(
                "num",
                OperandKind::Number { min: 0, max: 0xFF_FFFF },
                "Number of characters",
                "Počet znaků",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        executable: false,
        summary: text("Copies a text; the destination comes first.", "Zkopíruje text; cíl se píše první."),
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
            operand(
                "text2",
                OperandKind::TextOrLiteral,
                "Text declared by STR with an optional offset, or a literal in apostrophes",
                "Text deklarovaný STR s případným posunem, nebo řetězec v apostrofech",
            ),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        executable: false,
        summary: text("Appends a text to another.", "Připojí text na konec jiného textu."),
        ..INSTRUCTION
    },
    Entry {
        name: "BINSTR",
        chapter: "3.18",
        forms: &[form("BINSTR text1"), form("BINSTR text1, DWRD")],
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Write),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "width",
                OperandKind::Keyword(&["DWRD"]),
                "Width of DR; without it 16 bits",
                "Šířka DR; bez operandu 16 bitů",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Dr],
        writes: &[Effect::Memory],
        executable: false,
        summary: text(
            "Writes the binary number in DR as decimal digits.",
            "Zapíše binární číslo z DR jako desítkové číslice.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "BCDSTR",
        chapter: "3.18",
        forms: &[form("BCDSTR text1"), form("BCDSTR text1, DWRD")],
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Write),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "width",
                OperandKind::Keyword(&["DWRD"]),
                "Width of DR; without it 16 bits",
                "Šířka DR; bez operandu 16 bitů",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Dr],
        writes: &[Effect::Memory],
        executable: false,
        summary: text("Writes the BCD number in DR as digits.", "Zapíše BCD číslo z DR jako číslice."),
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
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Read),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "text2",
                OperandKind::TextOrLiteral,
                "Text declared by STR with an optional offset, or a literal in apostrophes",
                "Text deklarovaný STR s případným posunem, nebo řetězec v apostrofech",
            ),
            operand(
                "num",
                OperandKind::Number { min: 0, max: 0xFF_FFFF },
                "Number of characters",
                "Počet znaků",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        executable: false,
        summary: text("Sets RLO when two texts are equal.", "Nastaví RLO, když jsou dva texty shodné."),
        ..INSTRUCTION
    },
    Entry {
        name: "MEMCPY",
        chapter: "3.18",
        forms: &[form("MEMCPY text1, text2 [,num]"), form("MEMCPY text1+offset, text2+offset [,num]")],
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Write),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "text2",
                OperandKind::Text(Access::Read),
                "Text declared by STR, with an optional offset",
                "Text deklarovaný STR, případně s posunem",
            ),
            operand(
                "num",
                OperandKind::Number { min: 0, max: 0xFF_FFFF },
                "Number of characters",
                "Počet znaků",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        executable: false,
        summary: text(
            "Copies binary data; a zero byte does not end the copy.",
            "Zkopíruje binární data; nulový bajt kopírování neukončí.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "MEMCMP",
        chapter: "3.18",
        forms: &[form("MEMCMP text1, text2 [,num]"), form("MEMCMP text1+offset, text2+offset [,num]")],
        operands: &[
            operand(
                "text1",
                OperandKind::Text(Access::Read),
                "Text declared by STR, with an optional offset `+n` or `+BX`",
                "Text deklarovaný STR, případně s posunem `+n` nebo `+BX`",
            ),
            operand(
                "text2",
                OperandKind::Text(Access::Read),
                "Text declared by STR, with an optional offset",
                "Text deklarovaný STR, případně s posunem",
            ),
            operand(
                "num",
                OperandKind::Number { min: 0, max: 0xFF_FFFF },
                "Number of characters",
                "Počet znaků",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        executable: false,
        summary: text(
            "Sets RLO when two blocks of binary data are equal.",
            "Nastaví RLO, když jsou dva bloky binárních dat shodné.",
        ),
        ..INSTRUCTION
    },
];
