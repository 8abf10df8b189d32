//! Chapter 17.4.1: reading and writing cells of PLC tables.

use super::chapter17::{COLUMN, PLC_TABLE, RESULT, TABLE};
use super::entry::{Access, Effect, Entry, Example, Form, OperandKind, OperandSpec, Prefix, PrefixSet};
use super::pattern::{CELLS, WORD_VALUE, operand, source, text};
use super::transfer::{cs_result, en_result};

/// An integer that a table takes over.
const INTEGER_SOURCE: OperandKind =
    OperandKind::OneOf(&[source(CELLS, CELLS), OperandKind::Text(Access::Read)]);
/// Where an integer of a table goes.
const INTEGER_TARGET: OperandKind = OperandKind::OneOf(&[RESULT, OperandKind::Text(Access::Write)]);
/// Types of a real number in memory.
const REALS: PrefixSet = PrefixSet::of(&[Prefix::Qwrd, Prefix::Real]);
/// A real number that a table takes over.
const REAL_SOURCE: OperandKind = OperandKind::OneOf(&[source(REALS, REALS), OperandKind::Text(Access::Read)]);
/// Where a real number of a table goes.
const REAL_TARGET: OperandKind = OperandKind::OneOf(&[
    OperandKind::Data { access: Access::Write, prefixes: REALS, declared: REALS, negatable: false },
    OperandKind::Text(Access::Write),
]);

const LINE: OperandSpec = operand(
    "line",
    WORD_VALUE,
    "Line from 0: number, constant or WORD cell",
    "Řádek od 0: číslo, konstanta nebo buňka WORD",
);
/// PLCT_GET_x: name, kind and help of the target, what is read, more of the page, example, relatives.
macro_rules! get {
    (
        $name:literal, $kind:expr, [$help_en:literal, $help_cs:literal], [$what_en:literal, $what_cs:literal],
        [$more_en:literal, $more_cs:literal], $code:expr, [$note_en:literal, $note_cs:literal], $related:expr
    ) => {
        Entry {
            name: $name,
            forms: &[Form { syntax: concat!($name, " table, line, column, target") }],
            operands: &[TABLE, LINE, COLUMN, operand("target", $kind, $help_en, $help_cs)],
            summary: text(
                concat!("Reads ", $what_en, " from a PLC table."),
                concat!("Přečte ", $what_cs, " z PLC tabulky."),
            ),
            description: text(
                concat!("Copies one cell of the table to the target. ", $more_en, en_result!()),
                concat!("Zkopíruje jednu buňku tabulky do cíle. ", $more_cs, cs_result!()),
            ),
            examples: &[Example { code: $code, note: text($note_en, $note_cs) }],
            related: $related,
            ..PLC_TABLE
        }
    };
}

/// PLCT_SET_x: name, kind and help of the source, what is written, more of the page, example, relatives.
macro_rules! set {
    (
        $name:literal, $kind:expr, [$help_en:literal, $help_cs:literal], [$what_en:literal, $what_cs:literal],
        [$more_en:literal, $more_cs:literal], $code:expr, [$note_en:literal, $note_cs:literal], $related:expr
    ) => {
        Entry {
            name: $name,
            forms: &[Form { syntax: concat!($name, " table, line, column, source") }],
            operands: &[TABLE, LINE, COLUMN, operand("source", $kind, $help_en, $help_cs)],
            writes: &[Effect::Rlo, Effect::Dr],
            summary: text(
                concat!("Writes ", $what_en, " to a PLC table."),
                concat!("Zapíše ", $what_cs, " do PLC tabulky."),
            ),
            description: text(
                concat!("Copies the source to one cell of the table. ", $more_en, en_result!()),
                concat!("Zkopíruje zdroj do jedné buňky tabulky. ", $more_cs, cs_result!()),
            ),
            examples: &[Example { code: $code, note: text($note_en, $note_cs) }],
            related: $related,
            ..PLC_TABLE
        }
    };
}

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    get!(
        "PLCT_GET_INT",
        INTEGER_TARGET,
        [
            "BYTE, WORD or DWORD cell, or a text with an optional offset, which receives four bytes",
            "Buňka BYTE, WORD nebo DWORD, nebo text s případným posunem, do něhož se uloží čtyři bajty"
        ],
        ["an integer", "celé číslo"],
        [
            "The column is of the type INT, 32 bits; a BYTE or WORD cell receives the lower bits, a text the \
             four bytes of the number, not its digits (this implementation).",
            "Sloupec je typu INT, 32 bitů; do buňky BYTE nebo WORD se uloží dolní bity, do textu čtyři bajty \
             čísla, ne jeho číslice (tato implementace)."
        ],
        concat!(
            "        PLCT_GET_INT 0,LINE_NO,2,TEETH\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        [
            "The number of teeth from column 2; a failure leads to NO_TABLE.",
            "Počet zubů ze sloupce 2; neúspěch vede na NO_TABLE."
        ],
        &["PLCT_SET_INT", "PLCT_GET_REAL", "PLCT_COL_INDEX", "EX0"]
    ),
    get!(
        "PLCT_GET_REAL",
        REAL_TARGET,
        [
            "8 bytes: REAL cell, area of `DS 8` with `REAL.` or without it, text with an optional offset",
            "8 bajtů: buňka REAL, oblast `DS 8` s `REAL.` i bez něj, text s případným posunem"
        ],
        ["a real number", "reálné číslo"],
        [
            "The column is of the type REAL, the target takes eight bytes and is then loaded by `LOD REAL.`.",
            "Sloupec je typu REAL, cíl pojme osm bajtů a načte se potom pomocí `LOD REAL.`."
        ],
        concat!(
            "        PLCT_COL_INDEX 0,'Pitch',COL\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_COLUMN\n",
            "        PLCT_GET_REAL 0,LINE_NO,COL,PITCH\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_VALUE"
        ),
        [
            "Finds the column by its identifier, then reads the pitch of the thread.",
            "Najde sloupec podle identifikátoru a pak přečte stoupání závitu."
        ],
        &["PLCT_SET_REAL", "PLCT_GET_INT", "PLCT_COL_INDEX", "LOD"]
    ),
    get!(
        "PLCT_GET_STR",
        OperandKind::Address(Access::Write),
        [
            "Text declared by STR, or memory, with an optional offset",
            "Text deklarovaný STR, nebo paměť, s případným posunem"
        ],
        ["a text", "text"],
        [
            "The column is of the type STRING. The text is copied with its terminating zero, but never past the \
             end of the target; a longer one is cut (this implementation).",
            "Sloupec je typu STRING. Text se zkopíruje i s koncovou nulou, nikdy však přes konec cíle; delší se \
             zkrátí (tato implementace)."
        ],
        concat!(
            "        PLCT_GET_STR 1,LINE_NO,0,NAME\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        ["The name of the material to the text NAME.", "Název materiálu do textu NAME."],
        &["PLCT_SET_STR", "PLCT_GET_BIN", "STR"]
    ),
    get!(
        "PLCT_GET_BIN",
        OperandKind::Address(Access::Write),
        [
            "Memory or text with an optional offset, long enough for the column",
            "Paměť nebo text s případným posunem, dostatečně dlouhé pro sloupec"
        ],
        ["binary data", "binární data"],
        [
            "The column is of the type BINARY. Bytes that do not fit the target are left out (this \
             implementation).",
            "Sloupec je typu BINARY. Bajty, které se do cíle nevejdou, se vynechají (tato implementace)."
        ],
        concat!(
            "        PLCT_GET_BIN 1,LINE_NO,4,RECIPE\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        ["A recipe of raw bytes to the area RECIPE.", "Recept z holých bajtů do oblasti RECIPE."],
        &["PLCT_SET_BIN", "PLCT_GET_STR", "MEMCPY"]
    ),
    set!(
        "PLCT_SET_INT",
        INTEGER_SOURCE,
        [
            "BYTE, WORD or DWORD cell, or a text with an optional offset, of which four bytes are taken",
            "Buňka BYTE, WORD nebo DWORD, nebo text s případným posunem, z něhož se vezmou čtyři bajty"
        ],
        ["an integer", "celé číslo"],
        [
            "The column is of the type INT, 32 bits; a BYTE or WORD cell is extended with its sign (this \
             implementation). A constant must be stored to a cell first.",
            "Sloupec je typu INT, 32 bitů; buňka BYTE nebo WORD se rozšíří se znaménkem (tato implementace). \
             Konstantu je třeba nejprve uložit do buňky."
        ],
        concat!(
            "        PLCT_SET_INT 0,LINE_NO,3,PARTS\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        ["Keeps the number of parts in column 3.", "Uchová počet kusů ve sloupci 3."],
        &["PLCT_GET_INT", "PLCT_SET_REAL", "PLCT_CHANGED"]
    ),
    set!(
        "PLCT_SET_REAL",
        REAL_SOURCE,
        [
            "8 bytes: REAL cell, area of `DS 8` with `REAL.` or without it, text with an optional offset",
            "8 bajtů: buňka REAL, oblast `DS 8` s `REAL.` i bez něj, text s případným posunem"
        ],
        ["a real number", "reálné číslo"],
        [
            "The column is of the type REAL; eight bytes are taken, as `STO REAL.` left them.",
            "Sloupec je typu REAL; vezme se osm bajtů tak, jak je uložilo `STO REAL.`."
        ],
        concat!(
            "        PLCT_SET_REAL 0,LINE_NO,COL,PITCH\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_VALUE"
        ),
        ["Keeps a corrected pitch.", "Uchová opravené stoupání."],
        &["PLCT_GET_REAL", "PLCT_SET_INT", "STO"]
    ),
    set!(
        "PLCT_SET_STR",
        OperandKind::Address(Access::Read),
        [
            "Text declared by STR, or memory, with an optional offset; no literal",
            "Text deklarovaný STR, nebo paměť, s případným posunem; ne řetězec"
        ],
        ["a text", "text"],
        [
            "The column is of the type STRING. The text is taken up to its terminating zero. A literal must be \
             given to a STR first.",
            "Sloupec je typu STRING. Text se bere po koncovou nulu. Řetězec v apostrofech je třeba nejprve dát \
             do STR."
        ],
        concat!(
            "        PLCT_SET_STR 1,LINE_NO,0,NAME\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        ["Renames the material of a line.", "Přejmenuje materiál na řádku."],
        &["PLCT_GET_STR", "PLCT_SET_BIN", "STRCPY"]
    ),
    set!(
        "PLCT_SET_BIN",
        OperandKind::Address(Access::Read),
        ["Memory or text with an optional offset", "Paměť nebo text s případným posunem"],
        ["binary data", "binární data"],
        [
            "The column is of the type BINARY. Everything from the address to the end of the named cell or area \
             is taken (this implementation).",
            "Sloupec je typu BINARY. Vezme se vše od adresy do konce uvedené buňky nebo oblasti (tato \
             implementace)."
        ],
        concat!(
            "        PLCT_SET_BIN 1,LINE_NO,4,RECIPE\n",
            "        EX0\n",
            "        EQ   CNST.0\n",
            "        JL0  NO_TABLE"
        ),
        ["Keeps the recipe as raw bytes.", "Uchová recept jako holé bajty."],
        &["PLCT_GET_BIN", "PLCT_SET_STR"]
    ),
];
