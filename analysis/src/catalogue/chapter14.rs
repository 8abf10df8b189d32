//! Chapter 14: messages of the PLC program.

use super::entry::{Effect, Entry, Equation, OperandKind, OperandSpec, Place};
use super::pattern::{
    ANY_OPERANDS, INSTRUCTION, MESSAGE, MESSAGE_VALUE, UNMODELLED, example, form, operand, text,
};

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
             one exists. RLO and DR stay, unless that procedure changes them (this implementation). ESET \
             does not look at RLO and does not close an equation.",
            "Hlášení se vydá při každém provedení instrukce, musí ho proto hlídat podmínka nebo hrana. \
             Jeho druh, platnost a text určuje soubor hlášení projektu; 12 se zobrazí jako PLC00012. Bez \
             prvního operandu se číslo bere z DR16, kde ho mohlo nechat TEX0 nebo TEX1.\n\n\
             `subid` rozlišuje výskyty téhož hlášení, `set` (1 zobrazí, 0 odstraní, bez zadání 1) má \
             význam u trvalých hlášení, `par1` až `par3` se dosadí za `%d` a `%X` v textu. `-` přeskočí \
             vnitřní operand, koncové se vynechávají. Existuje-li procedura _ON_ESET, zavolá se. RLO ani \
             DR se nemění, pokud je nezmění tato procedura (tato implementace). ESET se na RLO neohlíží \
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
             one exists. RLO and DR stay, unless that procedure changes them (this implementation). \
             ESET1 does all this only when RLO is 1. Terminal instruction (this implementation).",
            "Hlášení se vydá při každém provedení instrukce, musí ho proto hlídat podmínka nebo hrana. \
             Jeho druh, platnost a text určuje soubor hlášení projektu; 12 se zobrazí jako PLC00012. Bez \
             prvního operandu se číslo bere z DR16, kde ho mohlo nechat TEX0 nebo TEX1.\n\n\
             `subid` rozlišuje výskyty téhož hlášení, `set` (1 zobrazí, 0 odstraní, bez zadání 1) má \
             význam u trvalých hlášení, `par1` až `par3` se dosadí za `%d` a `%X` v textu. `-` přeskočí \
             vnitřní operand, koncové se vynechávají. Existuje-li procedura _ON_ESET, zavolá se. RLO ani \
             DR se nemění, pokud je nezmění tato procedura (tato implementace). ESET1 se provede jen při \
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
        forms: &[form("EDEF [cell], bit, error, [subid], mode, [par1], [par2], [par3]")],
        operands: ANY_OPERANDS,
        place: Place::Init,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Binds a message to the edges of a bit; the control then reports it by itself.",
            "Naváže hlášení na hrany bitu; systém je pak vydává sám.",
        ),
        ..UNMODELLED
    },
];
