//! Chapter 14: messages of the PLC program.

use super::entry::{Effect, Entry, Equation, OperandKind, OperandSpec, Place, Prefix, PrefixSet};
use super::pattern::{INSTRUCTION, MESSAGE, MESSAGE_VALUE, NAMED_BIT, example, form, operand, source, text};

const ERROR: OperandSpec = operand(
    "error",
    OperandKind::Value(MESSAGE),
    "Number of the message: WORD cell or constant; without it DR",
    "Číslo hlášení: buňka WORD nebo konstanta; bez operandu se bere DR",
)
.or_dash()
.or_nothing();
const SUBID: OperandSpec = operand(
    "subid",
    OperandKind::Value(MESSAGE_VALUE),
    "Supplementary number: DWORD cell or constant",
    "Doplňkové číslo: buňka DWORD nebo konstanta",
)
.or_dash()
.or_nothing();
const SET: OperandSpec = operand(
    "set",
    OperandKind::Number { min: 0, max: 1 },
    "Persistent messages only: 1 shows the message, 0 removes it",
    "Jen u trvalých hlášení: 1 hlášení zobrazí, 0 odstraní",
)
.or_dash()
.or_nothing();
const PAR1: OperandSpec = operand(
    "par1",
    OperandKind::Value(MESSAGE_VALUE),
    "Value 1 for the text of the message: DWORD cell or constant",
    "Hodnota 1 do textu hlášení: buňka DWORD nebo konstanta",
)
.or_dash()
.or_nothing();
const PAR2: OperandSpec = operand(
    "par2",
    OperandKind::Value(MESSAGE_VALUE),
    "Value 2 for the text of the message: DWORD cell or constant",
    "Hodnota 2 do textu hlášení: buňka DWORD nebo konstanta",
)
.or_dash()
.or_nothing();
const PAR3: OperandSpec = operand(
    "par3",
    OperandKind::Value(MESSAGE_VALUE),
    "Value 3 for the text of the message: DWORD cell or constant",
    "Hodnota 3 do textu hlášení: buňka DWORD nebo konstanta",
)
.or_dash()
.or_nothing();

/// EDEF: what begins a message in bits 0 and 1, what ends it in bits 2 and 3; never both edges.
const EDGES: &[i64] = &[0b0000, 0b0001, 0b0010, 0b0100, 0b0101, 0b0110, 0b1000, 0b1001, 0b1010];

const fn watched(name: &'static str, en: &'static str, cs: &'static str) -> OperandSpec {
    let cell = source(PrefixSet::of(&[Prefix::Dwrd]), PrefixSet::of(&[Prefix::Dwrd]));
    operand(name, cell, en, cs).or_dash().or_nothing()
}

const WATCHED1: OperandSpec = watched(
    "par1",
    "DWORD cell with value 1 for the text, read when the message comes",
    "Buňka DWORD s hodnotou 1 do textu, čte se při vydání hlášení",
);
const WATCHED2: OperandSpec = watched(
    "par2",
    "DWORD cell with value 2 for the text, read when the message comes",
    "Buňka DWORD s hodnotou 2 do textu, čte se při vydání hlášení",
);
const WATCHED3: OperandSpec = watched(
    "par3",
    "DWORD cell with value 3 for the text, read when the message comes",
    "Buňka DWORD s hodnotou 3 do textu, čte se při vydání hlášení",
);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ESET",
        chapter: "14.3",
        forms: &[
            form("ESET"),
            form("ESET error"),
            form("ESET [error], [subid], [set], [par1], [par2], [par3]"),
        ],
        operands: &[ERROR, SUBID, SET, PAR1, PAR2, PAR3],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Reports a message of the PLC program.", "Vydá hlášení PLC programu."),
        description: text(
            "The message appears each time the instruction runs, so a condition or an edge must guard \
             it. Its type, validity and text come from the file of messages of the project; 12 is shown \
             as PLC00012. Without the first operand the number is taken from DR16, where TEX0 or TEX1 \
             may have left it.\n\n\
             `subid` distinguishes occurrences of one message, `set` (1 shows, 0 removes, 1 when left \
             out) matters for persistent messages, `par1` to `par3` fill `%d` and `%X` of the text. `-` \
             skips an inner operand, trailing ones are left out. The procedure _ON_ESET is called when \
             one exists. RLO and DR stay, whatever that procedure does with them (this implementation). ESET \
             does not look at RLO and does not close an equation.",
            "Hlášení se vydá při každém provedení instrukce, musí ho proto hlídat podmínka nebo hrana. \
             Jeho druh, platnost a text určuje soubor hlášení projektu; 12 se zobrazí jako PLC00012. Bez \
             prvního operandu se číslo bere z DR16, kde ho mohlo nechat TEX0 nebo TEX1.\n\n\
             `subid` rozlišuje výskyty téhož hlášení, `set` (1 zobrazí, 0 odstraní, bez zadání 1) má \
             význam u trvalých hlášení, `par1` až `par3` se dosadí za `%d` a `%X` v textu. `-` přeskočí \
             vnitřní operand, koncové se vynechávají. Existuje-li procedura _ON_ESET, zavolá se. RLO ani \
             DR se nemění, ať s nimi tato procedura dělá cokoli (tato implementace). ESET se na RLO neohlíží \
             a rovnici neuzavírá.",
        ),
        examples: &[
            example(
                concat!(
                    "        BEX\n",
                    "        LDR  CLAMPED\n",
                    "        TEX0 -,150,FAULT,ERR_CLAMP\n",
                    "        JUM  DONE\n",
                    "FAULT:  ESET\n",
                    "DONE:"
                ),
                "The number comes in DR from TEX0.",
                "Číslo předá TEX0 v DR.",
            ),
            example(
                "        ESET ERR_TOOL,-,-,TOOL",
                "Message with the number of the tool in its text.",
                "Hlášení s číslem nástroje v textu.",
            ),
        ],
        related: &["ESET1", "_ON_ESET", "TEX0"],
        ..INSTRUCTION
    },
    Entry {
        name: "ESET1",
        chapter: "14.3",
        forms: &[
            form("ESET1"),
            form("ESET1 error"),
            form("ESET1 [error], [subid], [set], [par1], [par2], [par3]"),
        ],
        operands: &[ERROR, SUBID, SET, PAR1, PAR2, PAR3],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Reports a message of the PLC program when RLO is 1.",
            "Vydá hlášení PLC programu, když je RLO 1.",
        ),
        description: text(
            "The message appears each time the instruction runs, so a condition or an edge must guard \
             it. Its type, validity and text come from the file of messages of the project; 12 is shown \
             as PLC00012. Without the first operand the number is taken from DR16, where TEX0 or TEX1 \
             may have left it.\n\n\
             `subid` distinguishes occurrences of one message, `set` (1 shows, 0 removes, 1 when left \
             out) matters for persistent messages, `par1` to `par3` fill `%d` and `%X` of the text. `-` \
             skips an inner operand, trailing ones are left out. The procedure _ON_ESET is called when \
             one exists. RLO and DR stay, whatever that procedure does with them (this implementation). \
             ESET1 does all this only when RLO is 1. Terminal instruction (this implementation).",
            "Hlášení se vydá při každém provedení instrukce, musí ho proto hlídat podmínka nebo hrana. \
             Jeho druh, platnost a text určuje soubor hlášení projektu; 12 se zobrazí jako PLC00012. Bez \
             prvního operandu se číslo bere z DR16, kde ho mohlo nechat TEX0 nebo TEX1.\n\n\
             `subid` rozlišuje výskyty téhož hlášení, `set` (1 zobrazí, 0 odstraní, bez zadání 1) má \
             význam u trvalých hlášení, `par1` až `par3` se dosadí za `%d` a `%X` v textu. `-` přeskočí \
             vnitřní operand, koncové se vynechávají. Existuje-li procedura _ON_ESET, zavolá se. RLO ani \
             DR se nemění, ať s nimi tato procedura dělá cokoli (tato implementace). ESET1 se provede jen při \
             RLO = 1. Koncová instrukce (tato implementace).",
        ),
        examples: &[example(
            concat!("        EDGE_L OIL_OK\n", "        ESET1 ERR_OIL"),
            "One message when the pressure is lost.",
            "Jedno hlášení při ztrátě tlaku.",
        )],
        related: &["ESET", "EDGE_H", "FL1"],
        ..INSTRUCTION
    },
    Entry {
        name: "EDEF",
        chapter: "14.3",
        forms: &[
            form("EDEF [cell], bit, error, [subid], mode, [par1], [par2], [par3]"),
            form("EDEF -, bit, error, -, mode"),
        ],
        operands: &[
            operand(
                "cell",
                source(PrefixSet::of(&[Prefix::Byte]), PrefixSet::of(&[Prefix::Byte])),
                "BYTE cell in which the bit lies, with an offset `+n` if needed; `-` takes the byte of the bit itself",
                "Buňka BYTE, ve které bit leží, případně s posunem `+n`; `-` bere bajt samotného bitu",
            )
            .or_dash(),
            operand(
                "bit",
                NAMED_BIT,
                "Bit whose edges are watched, declared by DFM, MAP_IN or DEF_IN",
                "Bit, jehož hrany se sledují, deklarovaný pomocí DFM, MAP_IN nebo DEF_IN",
            ),
            operand(
                "error",
                OperandKind::Value(MESSAGE),
                "Number of the message: WORD cell or constant",
                "Číslo hlášení: buňka WORD nebo konstanta",
            ),
            SUBID.required(),
            operand(
                "mode",
                OperandKind::NumberOf(EDGES),
                "Bits 0 and 1 say what begins the message, bits 2 and 3 what ends it: 00b nothing, 01b the rising \
                 edge, 10b the falling edge",
                "Bity 0 a 1 určují, co hlášení začíná, bity 2 a 3, co ho končí: 00b nic, 01b náběžná hrana, 10b \
                 sestupná hrana",
            ),
            WATCHED1,
            WATCHED2,
            WATCHED3,
        ],
        place: Place::Init,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Binds a message to the edges of a bit; the control then reports it by itself.",
            "Naváže hlášení na hrany bitu; systém je pak vydává sám.",
        ),
        description: text(
            "Executed once, in MODULE_INIT of any file, it only announces the binding. The control then looks at \
             the bit after every MODULE_MAIN and reports the message when the chosen edge comes, with the numbers, \
             texts and parameters of ESET; a bit that is 1 already when the program starts gives no message (this \
             implementation).\n\n\
             `0001b` reports a transient message on the rising edge, `0010b` on the falling one; `1001b` shows a \
             persistent message while the bit is 1. Both edges in one pair, 11b, is an error (this \
             implementation). `subid` is fixed here; `par1` to `par3` are read when the message comes. The \
             procedure _ON_ESET is not called (this implementation). RLO and DR stay.",
            "Provede se jednou, v modulu MODULE_INIT kteréhokoli souboru, a vazbu jen ohlásí. Systém pak sleduje bit \
             po každém MODULE_MAIN, a když přijde zvolená hrana, vydá hlášení s čísly, texty a parametry jako u \
             ESET; bit, který je 1 už při startu programu, hlášení nevyvolá (tato implementace).\n\n\
             `0001b` vydá přechodné hlášení na náběžnou hranu, `0010b` na sestupnou; `1001b` zobrazuje trvalé \
             hlášení, dokud je bit 1. Obě hrany v jedné dvojici, 11b, jsou chyba (tato implementace). `subid` se \
             určí zde, `par1` až `par3` se čtou, až když hlášení přijde. Procedura _ON_ESET se nevolá (tato \
             implementace). RLO ani DR se nemění.",
        ),
        examples: &[
            example(
                concat!(
                    "MODULE_INIT\n",
                    "        EDEF -,AIR_LOW,ERR_AIR,-,1001b\n",
                    "        EDEF ALARMS+1,DOOR,ERR_DOOR,-,0001b\n",
                    "MODULE_INIT_END"
                ),
                "ERR_AIR is shown as long as AIR_LOW is 1; ERR_DOOR comes when the bit at the place of DOOR rises in \
                 the byte behind ALARMS.",
                "ERR_AIR se zobrazuje, dokud je AIR_LOW 1; ERR_DOOR se vydá, když v bajtu za ALARMS přejde na 1 bit \
                 na pozici DOOR.",
            ),
            example(
                concat!(
                    "MODULE_INIT\n",
                    "        EDEF -,OIL_OK,ERR_OIL,-,0010b,TOOL\n",
                    "MODULE_INIT_END"
                ),
                "A message with the number of the tool when the oil pressure is lost.",
                "Hlášení s číslem nástroje při ztrátě tlaku oleje.",
            ),
        ],
        related: &["ESET", "ESET1", "MAP_IN", "EDGE_H"],
        ..INSTRUCTION
    },
];
