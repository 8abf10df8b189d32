//! Chapter 13: regulators and drives.

use super::entry::{Effect, Entry, Example, Form, OperandKind, OperandSpec};
use super::pattern::{INSTRUCTION, example, form, operand, text};

const SET: OperandSpec = operand(
    "set",
    OperandKind::Number { min: 1, max: 4 },
    "Number of the set, 1 to 4: number or EQUI constant",
    "Číslo sady 1 až 4: číslo nebo konstanta EQUI",
);

/// REGUL_x of one axis: its letter or digit, its number, its fellows.
macro_rules! regulator {
    ($axis:literal, $number:literal, $related:expr) => {
        Entry {
            name: concat!("REGUL_", $axis),
            chapter: "13.1",
            forms: &[Form { syntax: concat!("REGUL_", $axis, " set") }],
            operands: &[SET],
            writes: &[Effect::Memory],
            summary: text(
                concat!("Activates a set of regulator parameters for axis ", $number, "."),
                concat!("Zvolí sadu parametrů regulátoru pro ", $number, ". osu."),
            ),
            description: text(
                concat!(
                    "Each axis has four sets of regulator parameters, the elements ServoParamSet of its Servo in \
                     the channel configuration. After power-on set 1 is active; MODULE_INIT may choose another \
                     one before the position loop starts. Later the set of axis ",
                    $number,
                    " should be changed only while the axis is at rest and its position loop is open: clear \
                     VAZBA_",
                    $axis,
                    ", choose the set, then set VAZBA_",
                    $axis,
                    " again. Axes 7 to 16 have no such instruction. RLO and DR stay (this implementation)."
                ),
                concat!(
                    "Každá osa má čtyři sady parametrů regulátoru, prvky ServoParamSet jejího Servo v konfiguraci \
                     kanálu. Po zapnutí je aktivní sada 1; v MODULE_INIT lze zvolit jinou ještě před spuštěním \
                     polohové smyčky. Později se má sada ",
                    $number,
                    ". osy měnit, jen když osa stojí a její polohová vazba je rozpojená: vynulujte VAZBA_",
                    $axis,
                    ", zvolte sadu a VAZBA_",
                    $axis,
                    " opět nastavte. Osy 7 až 16 takovou instrukci nemají. RLO ani DR se nemění (tato \
                     implementace)."
                ),
            ),
            examples: &[Example {
                code: concat!(
                    "        FL   0,VAZBA_", $axis, "\n",
                    "        EX\n",
                    "        REGUL_", $axis, " 2\n",
                    "        FL   1,VAZBA_", $axis
                ),
                note: text(
                    "Set 2 for the heavy gear, changed with the position loop open.",
                    "Sada 2 pro těžký převod, změněná při rozpojené polohové vazbě.",
                ),
            }],
            related: $related,
            ..INSTRUCTION
        }
    };
}

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    regulator!("X", "1", &["REGUL_Y", "REGUL_Z", "REGUL_4", "REGUL_5", "REGUL_6"]),
    regulator!("Y", "2", &["REGUL_X", "REGUL_Z", "REGUL_4", "REGUL_5", "REGUL_6"]),
    regulator!("Z", "3", &["REGUL_X", "REGUL_Y", "REGUL_4", "REGUL_5", "REGUL_6"]),
    regulator!("4", "4", &["REGUL_X", "REGUL_Y", "REGUL_Z", "REGUL_5", "REGUL_6"]),
    regulator!("5", "5", &["REGUL_X", "REGUL_Y", "REGUL_Z", "REGUL_4", "REGUL_6"]),
    regulator!("6", "6", &["REGUL_X", "REGUL_Y", "REGUL_Z", "REGUL_4", "REGUL_5"]),
    Entry {
        name: "CAN_AX_SEND",
        chapter: "13.14",
        forms: &[form("CAN_AX_SEND axis")],
        operands: &[operand(
            "axis",
            OperandKind::Number { min: 1, max: 16 },
            "Number of the axis, for a drive in speed mode number of its output channel, 1 to 16",
            "Číslo osy, u pohonu v rychlostním režimu číslo výstupního kanálu, 1 až 16",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Sends an SDO packet to the CAN drive of an axis.", "Pošle SDO paket CAN pohonu osy."),
        description: text(
            "Sends CAN_AX_SEND_PACKET to the drive without waiting; the answer appears in \
             CAN_AX_RECV_PACKET. Both have the layout TCANMSGS of 12 bytes. The instruction fills CAN_ID, \
             CAN_RTR and CAN_LEN from the axis and the configuration, the program only the up to eight \
             bytes from CAN_DATA: command, index (WORD), subindex, data.\n\n\
             The packet is copied when the instruction runs, and a packet that still waits for its answer \
             is replaced (this implementation). CAN_AX_BUSY becomes 0FFh and the control clears it when \
             the answer arrives; as a BYTE it can be tested as a whole or by one of its bits. RLO and DR \
             stay (this implementation).",
            "Odešle CAN_AX_SEND_PACKET pohonu a nečeká; odpověď se objeví v CAN_AX_RECV_PACKET. Obě pole \
             mají uspořádání TCANMSGS o 12 bajtech. CAN_ID, CAN_RTR a CAN_LEN vyplní instrukce podle osy a \
             konfigurace, program jen nejvýše osm bajtů od CAN_DATA: povel, index (WORD), subindex, data.\n\n\
             Paket se zkopíruje při provedení instrukce a paket, který ještě čeká na odpověď, se nahradí \
             (tato implementace). CAN_AX_BUSY se nastaví na 0FFh a systém ho vynuluje po příchodu \
             odpovědi; lze testovat celý bajt i jeden jeho bit. RLO ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "A drive that does not answer leaves CAN_AX_BUSY at 0FFh: send the packet again after a while. \
             An error told by the drive stands in CAN_AX_RECV_PACKET.",
            "Když pohon neodpoví, zůstane CAN_AX_BUSY na 0FFh: po chvíli paket pošlete znovu. Chyba hlášená \
             pohonem je v CAN_AX_RECV_PACKET.",
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.2Fh\n",
                "        STO  BYTE.CAN_AX_SEND_PACKET.CAN_DATA\n",
                "        LOD  CNST.6060h\n",
                "        STO  WORD.CAN_AX_SEND_PACKET.CAN_DATA_1\n",
                "        LOD  CNST.0\n",
                "        STO  BYTE.CAN_AX_SEND_PACKET.CAN_DATA_3\n",
                "        LOD  CNST.6\n",
                "        STO  BYTE.CAN_AX_SEND_PACKET.CAN_DATA_4\n",
                "        CAN_AX_SEND 2\n",
                "        EX\n",
                "        LOD  CAN_AX_BUSY\n",
                "        EQ   CNST.0\n",
                "        TEX0 -,50,FAULT"
            ),
            "Writes 6 to object 6060h of the drive of axis 2 and waits up to a second for the answer.",
            "Zapíše 6 do objektu 6060h pohonu osy 2 a na odpověď čeká nejvýše sekundu.",
        )],
        related: &["TEX0", "EX"],
        ..INSTRUCTION
    },
];
