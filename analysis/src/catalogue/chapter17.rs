//! Chapter 17: PLC tables: columns, lines, changes.

use super::entry::{Access, Bilingual, ConfigElement, Effect, Entry, OperandKind, OperandSpec};
use super::pattern::{BYTE_VALUE, CELLS, VALUES, WORD_VALUE, example, form, operand, source, text};
use super::transfer::{TRANSFER, cs_result, en_result};

/// A cell that receives a small number: an index, a type, a count.
pub(super) const RESULT: OperandKind =
    OperandKind::Data { access: Access::Write, prefixes: CELLS, declared: CELLS, negatable: false };
pub(super) const TABLE: OperandSpec = operand(
    "table",
    BYTE_VALUE,
    "Number of the table from 0, as registered: number, constant or BYTE cell",
    "Číslo tabulky od 0 podle registrace: číslo, konstanta nebo buňka BYTE",
);
pub(super) const COLUMN: OperandSpec = operand(
    "column",
    WORD_VALUE,
    "Column from 0: number, constant or WORD cell",
    "Sloupec od 0: číslo, konstanta nebo buňka WORD",
);

const ERRORS: Bilingual = text(
    "RLO 1 with DR other than 0: no such table, line or column, or a column of another type. Test it behind \
     EX0 by EQ CNST.0 and JL0. The manual gives no numbers of errors; here they are 1 no such table, 2 line, 3 \
     column, 4 another type (this implementation).",
    "RLO 1 s nenulovým DR: tabulka, řádek nebo sloupec neexistuje nebo má sloupec jiný typ. Otestujte to za \
     EX0 pomocí EQ CNST.0 a JL0. Čísla chyb příručka neuvádí; zde jsou to 1 chybí tabulka, 2 řádek, 3 sloupec, 4 \
     jiný typ (tato implementace).",
);

/// An instruction of this chapter.
pub(super) const PLC_TABLE: Entry = Entry { chapter: "17.4", errors: ERRORS, executable: true, ..TRANSFER };

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "PLCT_COL_INDEX",
        forms: &[form("PLCT_COL_INDEX table, 'identifier', target")],
        operands: &[
            TABLE,
            operand(
                "identifier",
                OperandKind::Identifier(ConfigElement::Column),
                "ColID of the column in apostrophes, or a text that holds it",
                "ColID sloupce v apostrofech, nebo text, který ho obsahuje",
            ),
            operand(
                "target",
                RESULT,
                "Cell for the index of the column, from 0",
                "Buňka pro index sloupce od 0",
            ),
        ],
        summary: text(
            "Finds the index of a column of a PLC table by its identifier.",
            "Najde index sloupce PLC tabulky podle identifikátoru.",
        ),
        description: text(
            concat!(
                "Stores the index of the column whose ColID in the definition of the table is the given one. A \
                 program that asks for its columns by name does not depend on their order. Letters must agree \
                 also in case (this implementation).",
                en_result!()
            ),
            concat!(
                "Uloží index sloupce, jehož ColID v definici tabulky je zadaný identifikátor. Program, který si \
                 sloupce hledá podle jména, nezávisí na jejich pořadí. Písmena se musí shodovat i velikostí \
                 (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        PLCT_COL_INDEX 0,'Pitch',COL\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_COLUMN"
            ),
            "NO_COLUMN is reached when the table has no such column.",
            "Na NO_COLUMN se skočí, když tabulka takový sloupec nemá.",
        )],
        related: &["PLCT_COL_ID", "PLCT_COL_TYPE", "PLCT_GET_REAL"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_COL_ID",
        forms: &[form("PLCT_COL_ID table, text")],
        operands: &[
            TABLE,
            operand(
                "text",
                OperandKind::Text(Access::ReadWrite),
                "Text declared by STR: before the call its first bytes hold the index of the column",
                "Text deklarovaný STR: před provedením obsahují jeho první bajty index sloupce",
            ),
        ],
        summary: text(
            "Finds the identifier of a column of a PLC table by its index.",
            "Najde identifikátor sloupce PLC tabulky podle indexu.",
        ),
        description: text(
            concat!(
                "The index is stored beforehand at the beginning of the text, for instance by `STO DWRD.`; the \
                 text receives the ColID of that column, cut to its length. The index is read once, when the \
                 transfer starts, as 32 bits, of which a fresh text has the upper ones zero (this \
                 implementation).",
                en_result!()
            ),
            concat!(
                "Index se předem uloží na začátek textu, například pomocí `STO DWRD.`; do textu se pak zapíše \
                 ColID tohoto sloupce zkrácený na jeho délku. Index se čte jednou, při zahájení přenosu, jako \
                 32 bitů, z nichž jsou v nepoužitém textu horní nulové (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.3\n",
                "        STO  DWRD.TITLE\n",
                "        PLCT_COL_ID 0,TITLE\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_COLUMN"
            ),
            "TITLE becomes the identifier of the column 3.",
            "TITLE bude obsahovat identifikátor sloupce 3.",
        )],
        related: &["PLCT_COL_INDEX", "PLCT_COL_TYPE", "STR"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_COL_TYPE",
        forms: &[form("PLCT_COL_TYPE table, column, target")],
        operands: &[
            TABLE,
            COLUMN,
            operand("target", RESULT, "Cell for the type, 1 to 4", "Buňka pro typ 1 až 4"),
        ],
        summary: text(
            "Reads the data type of a column of a PLC table.",
            "Zjistí datový typ sloupce PLC tabulky.",
        ),
        description: text(
            concat!(
                "Stores PlcTabType_Int (1), PlcTabType_Real (2), PlcTabType_Str (3) or PlcTabType_Bin (4). The \
                 numbers 1 to 3 follow the order of the types in the manual (this implementation).",
                en_result!()
            ),
            concat!(
                "Uloží PlcTabType_Int (1), PlcTabType_Real (2), PlcTabType_Str (3) nebo PlcTabType_Bin (4). Čísla \
                 1 až 3 odpovídají pořadí typů v příručce (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        PLCT_COL_TYPE 0,COL,KIND\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_COLUMN\n",
                "        LOD  KIND\n",
                "        EQ   PLCTABTYPE_REAL\n",
                "        JL0  NOT_REAL"
            ),
            "Goes on only with a column of real numbers.",
            "Pokračuje jen se sloupcem reálných čísel.",
        )],
        related: &["PLCT_COL_INDEX", "PLCT_COL_ID", "PLCT_GET_INT", "PLCT_GET_REAL"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_GET_SELLINE",
        forms: &[form("PLCT_GET_SELLINE table, target")],
        operands: &[TABLE, operand("target", RESULT, "Cell for the line, from 0", "Buňka pro řádek od 0")],
        summary: text("Reads the selected line of a PLC table.", "Zjistí vybraný řádek PLC tabulky."),
        description: text(
            concat!(
                "Stores the number of the line that the operator or PLCT_SET_SELLINE selected. Lines count from \
                 0 (this implementation).",
                en_result!()
            ),
            concat!(
                "Uloží číslo řádku, který vybrala obsluha nebo PLCT_SET_SELLINE. Řádky se číslují od 0 (tato \
                 implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        PLCT_GET_SELLINE 0,LINE_NO\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_LINE"
            ),
            "With no line selected it ends at NO_LINE.",
            "Není-li vybrán žádný řádek, skončí na NO_LINE.",
        )],
        related: &["PLCT_SET_SELLINE", "PLCT_GET_LINESCOUNT", "PLCT_CHANGED"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_SET_SELLINE",
        forms: &[form("PLCT_SET_SELLINE table, line")],
        operands: &[
            TABLE,
            operand(
                "line",
                source(VALUES, VALUES),
                "Line from 0: number, constant or cell",
                "Řádek od 0: číslo, konstanta nebo buňka",
            ),
        ],
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text("Selects a line of a PLC table.", "Vybere řádek PLC tabulky."),
        description: text(
            concat!("Makes `line` the selected one, on the screen too.", en_result!()),
            concat!("Řádek `line` se stane vybraným, a to i na obrazovce.", cs_result!()),
        ),
        examples: &[example(
            concat!(
                "        PLCT_SET_SELLINE 0,4\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_LINE"
            ),
            "Selects the fifth line.",
            "Vybere pátý řádek.",
        )],
        related: &["PLCT_GET_SELLINE", "PLCT_GET_LINESCOUNT"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_CHANGED",
        forms: &[form("PLCT_CHANGED table, target")],
        operands: &[TABLE, operand("target", RESULT, "Cell for the kind of change", "Buňka pro druh změny")],
        summary: text(
            "Tells whether a PLC table or its selected line has changed.",
            "Zjistí, zda se PLC tabulka nebo její vybraný řádek změnily.",
        ),
        description: text(
            concat!(
                "Stores PlctItemChanged (1) when an item has changed, PlctSellLineChanged (2) when another line \
                 has been selected, 0 when nothing has changed since the last question; of both changes the \
                 item is told first (this implementation). Writes of the program itself do not count (this \
                 implementation).",
                en_result!()
            ),
            concat!(
                "Uloží PlctItemChanged (1), když se změnil prvek tabulky, PlctSellLineChanged (2), když byl \
                 vybrán jiný řádek, a 0, když se od minulého dotazu nezměnilo nic; z obou změn se nejprve ohlásí \
                 prvek (tato implementace). Zápisy samotného programu se nepočítají (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        PLCT_CHANGED 0,KIND\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_TABLE\n",
                "        LOD  KIND\n",
                "        EQ   PLCTITEMCHANGED\n",
                "        FL1  1,READ_AGAIN"
            ),
            "A changed item starts the mechanism that reads the table.",
            "Změna prvku spustí mechanismus, který tabulku přečte.",
        )],
        related: &["PLCT_GET_SELLINE", "PLCT_GET_INT"],
        ..PLC_TABLE
    },
    Entry {
        name: "PLCT_GET_LINESCOUNT",
        forms: &[form("PLCT_GET_LINESCOUNT table, target")],
        operands: &[
            TABLE,
            operand("target", RESULT, "Cell for the number of lines", "Buňka pro počet řádků"),
        ],
        summary: text("Reads the number of lines of a PLC table.", "Zjistí počet řádků PLC tabulky."),
        description: text(
            concat!(
                "Stores how many lines the table has now; the operator may add and remove lines. The last line \
                 has the number one less.",
                en_result!()
            ),
            concat!(
                "Uloží, kolik řádků tabulka právě má; obsluha může řádky přidávat i odebírat. Poslední řádek má \
                 číslo o jedničku menší.",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        PLCT_GET_LINESCOUNT 0,LINES\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_TABLE\n",
                "        LOD  LINE_NO\n",
                "        GE   LINES\n",
                "        JL1  PAST_END"
            ),
            "Guards an access against a line that is no more.",
            "Hlídá přístup na řádek, který už není.",
        )],
        related: &["PLCT_GET_SELLINE", "PLCT_SET_SELLINE"],
        ..PLC_TABLE
    },
];
