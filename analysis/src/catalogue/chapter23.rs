//! Chapter 23: serial ports.

use super::entry::{Access, Effect, Entry, Equation, OperandKind, OperandSpec, Prefix, PrefixSet};
use super::pattern::{BYTE_CELL, COUNTERS, INSTRUCTION, example, form, operand, source, text};

const COM: OperandSpec = operand(
    "com",
    OperandKind::Number { min: 0, max: 255 },
    "Logical channel: No of a ComChannel, not the number of a port",
    "Logický kanál: No prvku ComChannel, ne číslo portu",
);
/// A byte that is sent.
const CHARACTER: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: -0x80, max: 0xFF }, BYTE_CELL]);
/// A byte that is received.
const RECEIVED: OperandKind = OperandKind::Data {
    access: Access::Write,
    prefixes: PrefixSet::of(&[Prefix::Byte]),
    declared: PrefixSet::of(&[Prefix::Byte]),
    negatable: false,
};
/// How many characters are sent.
const COUNT: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: 0, max: 0xFFFF }, source(COUNTERS, COUNTERS)]);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "COM_SEND",
        chapter: "23.3",
        forms: &[form("COM_SEND com"), form("COM_SEND com, value")],
        operands: &[
            COM,
            operand(
                "value",
                CHARACTER,
                "Character: BYTE cell or constant; otherwise DR8",
                "Znak: buňka BYTE nebo konstanta; jinak DR8",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Queues a character for a serial port; RLO 0 means success.",
            "Zařadí znak k odeslání sériovým portem; RLO 0 znamená úspěch.",
        ),
        description: text(
            "Puts one character into the transmit queue of the logical channel; the control sends it by \
             itself. Speed, format and physical port of the channel are in its ComChannel of the channel \
             configuration. Characters queued one by one may have gaps between them; COM_SEND_STR sends \
             without gaps.\n\n\
             RLO is overwritten without a push. A constant may stand instead of a cell, DR stays (this \
             implementation).",
            "Zařadí jeden znak do vysílací fronty logického kanálu; systém ho odešle sám. Rychlost, formát \
             a fyzický port kanálu určuje jeho ComChannel v konfiguraci kanálu. Mezi znaky zařazovanými po \
             jednom mohou být mezery; bez mezer vysílá COM_SEND_STR.\n\n\
             RLO se přepíše bez uložení na zásobník. Místo buňky smí stát konstanta, DR se nemění (tato \
             implementace).",
        ),
        errors: text(
            "RLO 1: the character was not queued, usually because the queue is full; try again in a later \
             cycle. COM_CONTROL STATE tells more.",
            "RLO 1: znak se nezařadil, zpravidla proto, že je fronta plná; zkuste to v některém z dalších \
             cyklů. Více řekne COM_CONTROL STATE.",
        ),
        examples: &[example(
            concat!("        LOD  LETTER\n", "        COM_SEND 1\n", "        JL1  LATER"),
            "Sends the character in DR; with a full queue it goes to LATER.",
            "Odešle znak z DR; je-li fronta plná, pokračuje na LATER.",
        )],
        related: &["COM_SEND_STR", "COM_RECV", "COM_CONTROL"],
        ..INSTRUCTION
    },
    Entry {
        name: "COM_SEND_STR",
        chapter: "23.3",
        forms: &[form("COM_SEND_STR com, buffer, length")],
        operands: &[
            COM,
            operand(
                "buffer",
                OperandKind::Address(Access::Read),
                "Text declared by STR, cell or area, with an optional offset",
                "Text deklarovaný STR, buňka nebo oblast, s případným posunem",
            ),
            operand(
                "length",
                COUNT,
                "Number of characters: number, constant, BYTE or WORD cell",
                "Počet znaků: číslo, konstanta, buňka BYTE nebo WORD",
            ),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Queues a text for a serial port, sent without gaps; RLO 0 means success.",
            "Zařadí text k odeslání sériovým portem bez mezer mezi znaky; RLO 0 znamená úspěch.",
        ),
        description: text(
            "Copies `length` bytes to the transmit queue of the logical channel, all or none (this \
             implementation); the control sends them in one piece. A terminating zero does not end the \
             text. RLO is overwritten without a push, DR stays (this implementation).",
            "Zkopíruje `length` bajtů do vysílací fronty logického kanálu, buď všechny, nebo žádný (tato \
             implementace); systém je odešle vcelku. Koncová nula text neukončí. RLO se přepíše bez uložení \
             na zásobník, DR se nemění (tato implementace).",
        ),
        errors: text(
            "RLO 1: nothing was queued, usually because the queue has not enough room.",
            "RLO 1: nezařadilo se nic, zpravidla proto, že ve frontě není dost místa.",
        ),
        examples: &[example(
            concat!("HELLO:  STR  12,'READY'\n", "        COM_SEND_STR 1,HELLO,5\n", "        JL1  LATER"),
            "Sends five letters, the zero behind them stays.",
            "Odešle pět písmen, nula za nimi zůstane.",
        )],
        related: &["COM_SEND", "COM_RECV", "STR"],
        ..INSTRUCTION
    },
    Entry {
        name: "COM_RECV",
        chapter: "23.3",
        forms: &[form("COM_RECV com"), form("COM_RECV com, cell")],
        operands: &[
            COM,
            operand(
                "cell",
                RECEIVED,
                "BYTE cell for the character; otherwise DR",
                "Buňka BYTE pro znak; jinak DR",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Takes a character received by a serial port; RLO 1 when there is none.",
            "Vyzvedne znak přijatý sériovým portem; RLO je 1, když žádný není.",
        ),
        description: text(
            "Takes the oldest character from the receive queue of the logical channel. Without `cell` it is \
             in DR, with zeros above it; with `cell` it goes there and DR stays (this implementation). RLO \
             is overwritten without a push: 0 when there was a character. One execution takes one \
             character, a further one comes with the next.",
            "Vyzvedne nejstarší znak z přijímací fronty logického kanálu. Bez operandu `cell` je v DR a nad \
             ním nuly; s ním se uloží tam a DR se nemění (tato implementace). RLO se přepíše bez uložení na \
             zásobník: 0, když znak byl. Jedno provedení vyzvedne jeden znak, další přijde \
             na řadu při příštím.",
        ),
        errors: text(
            "RLO 1: the queue is empty; the cell and DR stay. Lost characters show as PLC_COM_RECV_OVER in \
             COM_CONTROL STATE.",
            "RLO 1: fronta je prázdná; buňka ani DR se nemění. Ztracené znaky ohlásí PLC_COM_RECV_OVER v \
             COM_CONTROL STATE.",
        ),
        examples: &[example(
            concat!(
                "        COM_RECV 1,LETTER\n",
                "        JL1  EMPTY\n",
                "        LOD  LETTER\n",
                "        EQ   CNST.13\n",
                "        FL1  1,LINE_READY\n",
                "EMPTY:"
            ),
            "One character per cycle; carriage return ends the line.",
            "Jeden znak za cyklus; řádek končí návratem vozíku.",
        )],
        related: &["COM_CONTROL", "COM_SEND", "STO"],
        ..INSTRUCTION
    },
    Entry {
        name: "COM_CONTROL",
        chapter: "23.3",
        forms: &[form("COM_CONTROL com, CLEAR|RECEIVED|STATE")],
        operands: &[
            COM,
            operand(
                "mode",
                OperandKind::Keyword(&["CLEAR", "RECEIVED", "STATE"]),
                "CLEAR empties the receive queue, RECEIVED counts it, STATE reads the flags of the channel",
                "CLEAR vyprázdní přijímací frontu, RECEIVED spočítá její znaky, STATE přečte příznaky kanálu",
            ),
        ],
        writes: &[Effect::Dr],
        summary: text(
            "Clears the receive queue of a serial port or reads its state into DR.",
            "Vyprázdní přijímací frontu sériového portu nebo přečte jeho stav do DR.",
        ),
        description: text(
            "RECEIVED and STATE leave their 32-bit result in DR, CLEAR leaves DR alone; RLO stays (this \
             implementation). STATE is a sum of flags: PLC_COM_ERROR (1) the channel is in error, \
             PLC_COM_REQ (2) it is not configured, PLC_COM_SEND_OVER (4) the transmit queue overflowed, \
             PLC_COM_RECV_OVER (8) the receive queue did.",
            "RECEIVED a STATE nechají 32bitový výsledek v DR, CLEAR DR nemění; RLO zůstává (tato \
             implementace). STATE je součet příznaků: PLC_COM_ERROR (1) kanál je v chybě, PLC_COM_REQ (2) \
             není nakonfigurován, PLC_COM_SEND_OVER (4) přetekla vysílací fronta, PLC_COM_RECV_OVER (8) \
             přijímací.",
        ),
        errors: text(
            "STATE tells the errors of the channel; the instruction itself cannot fail.",
            "Chyby kanálu říká STATE; sama instrukce selhat nemůže.",
        ),
        examples: &[example(
            concat!(
                "        COM_CONTROL 1,STATE\n",
                "        ANDB CNST.PLC_COM_ERROR\n",
                "        EQ   CNST.0\n",
                "        JL0  LINE_DOWN"
            ),
            "Goes to LINE_DOWN when the channel is in error.",
            "Je-li kanál v chybě, pokračuje na LINE_DOWN.",
        )],
        related: &["COM_RECV", "COM_SEND", "ANDB"],
        ..INSTRUCTION
    },
];
