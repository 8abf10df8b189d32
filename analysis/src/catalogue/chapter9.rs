//! Chapter 9: the CAN bus, shared with the control; LDR_LIC of chapter 8.

use super::entry::{Access, Effect, Entry, Equation, OperandKind, OperandSpec, Prefix, PrefixSet};
use super::pattern::{INSTRUCTION, example, form, operand, text};

const CAN: OperandSpec = operand(
    "can",
    OperandKind::Number { min: 1, max: 2 },
    "Logical CAN channel: 1 is CAN1, 2 is CAN2",
    "Logický CAN kanál: 1 je CAN1, 2 je CAN2",
);
const HANDLE: OperandSpec = operand(
    "handle",
    OperandKind::Data {
        access: Access::Read,
        prefixes: PrefixSet::of(&[Prefix::Dwrd]),
        declared: PrefixSet::of(&[Prefix::Dwrd]),
        negatable: false,
    },
    "DWORD cell with the handle that CAN_RECV_REQ left in DR",
    "Buňka DWORD s číslem požadavku, které vrátila CAN_RECV_REQ v DR",
);

/// Highest function part of an 11-bit identifier: bits 7 to 10.
const LAST_OBJECT: i64 = 0x780;
/// Highest NODE-ID: bits 0 to 6.
const LAST_NODE: i64 = 0x7F;

const fn packet(access: Access, en: &'static str, cs: &'static str) -> OperandSpec {
    operand("packet", OperandKind::Text(access), en, cs)
}

const RECEIVED: OperandSpec =
    packet(Access::Write, "Room for a packet: label of a STR 12", "Místo na paket: návěští textu STR 12");

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CAN_SEND",
        chapter: "9.4",
        forms: &[form("CAN_SEND can, packet")],
        operands: &[
            CAN,
            packet(
                Access::Read,
                "Packet to send: label of a STR 12",
                "Paket k odeslání: návěští textu STR 12",
            ),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Dr64],
        summary: text(
            "Queues a CAN packet of 12 bytes for sending; DR holds the result.",
            "Zařadí 12bajtový CAN paket k odeslání; výsledek je v DR.",
        ),
        description: text(
            "Copies the packet to the transmit queue of the channel and goes on at once; queue, set-up of the \
             controller and the transfer itself are the business of the control, which uses the same channel.\n\n\
             A packet has 12 bytes: `CAN_ID` (WORD, +0) is the 11-bit identifier, `CAN_RTR` (BYTE, +2) asks for \
             a remote frame when it is not 0, `CAN_LEN` (BYTE, +3) is the number of valid data bytes, 0 to 8, \
             and `CAN_DATA` (+4) holds up to 8 data bytes. RLO stays, all of DR is written (this implementation).",
            "Zkopíruje paket do vysílací fronty kanálu a ihned pokračuje; frontu, nastavení řadiče i vlastní přenos \
             obstará systém, který tentýž kanál používá také.\n\n\
             Paket má 12 bajtů: `CAN_ID` (WORD, +0) je 11bitový identifikátor, nenulový `CAN_RTR` (BYTE, +2) žádá \
             o vzdálený rámec, `CAN_LEN` (BYTE, +3) udává počet platných datových bajtů 0 až 8 a `CAN_DATA` (+4) \
             obsahuje až 8 datových bajtů. RLO se nemění, zapíše se celý DR (tato implementace).",
        ),
        errors: text(
            "DR is 0 (`CAN_ERR_OK`) when the packet was queued, 1 (`CAN_ERR_XMTFULL`) when the queue is full and \
             the packet was not taken: send it again later.",
            "DR je 0 (`CAN_ERR_OK`), když byl paket zařazen, a 1 (`CAN_ERR_XMTFULL`), když je fronta plná a paket \
             nebyl přijat: pošlete ho znovu později.",
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.10h\n",
                "        STO  WORD.PACKET\n",
                "        LOD  CNST.2\n",
                "        STO  BYTE.(PACKET+3)\n",
                "        CAN_SEND 2,PACKET\n",
                "        EQ   CNST.0\n",
                "        WR   QUEUED"
            ),
            "Sends two data bytes to the identifier 10h; QUEUED is 1 when the packet was taken.",
            "Pošle dva datové bajty na identifikátor 10h; QUEUED je 1, když byl paket přijat.",
        )],
        related: &["CAN_RECV_REQ", "CAN_RECV", "STR"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_RECV",
        chapter: "9.4",
        forms: &[form("CAN_RECV can, packet")],
        operands: &[CAN, RECEIVED],
        writes: &[Effect::Dr64, Effect::Memory],
        summary: text(
            "Takes a CAN packet from the receive queue; DR holds the result. CAN_RECV_REQ is preferred.",
            "Vyzvedne CAN paket z přijímací fronty; výsledek je v DR. Vhodnější je CAN_RECV_REQ.",
        ),
        description: text(
            "Moves the oldest packet meant for the program from the receive queue of the channel to the 12 bytes \
             of `packet`, laid out as for CAN_SEND. Kept for older programs; in new ones CAN_RECV_REQ calls a \
             procedure for the packets that matter. An empty queue leaves `packet` as it was; RLO stays, all of \
             DR is written (this implementation).",
            "Přesune nejstarší paket určený programu z přijímací fronty kanálu do 12 bajtů `packet`; uspořádání je \
             stejné jako u CAN_SEND. Zůstává kvůli starším programům; v nových volá CAN_RECV_REQ proceduru pro \
             pakety, na kterých záleží. Je-li fronta prázdná, `packet` se nezmění; RLO se nemění, zapíše se celý \
             DR (tato implementace).",
        ),
        errors: text(
            "DR is 0 (`CAN_ERR_OK`) when a packet was read, 2 (`CAN_ERR_RCVEMPTY`) when none was waiting.",
            "DR je 0 (`CAN_ERR_OK`), když byl paket přečten, a 2 (`CAN_ERR_RCVEMPTY`), když žádný nečekal.",
        ),
        examples: &[example(
            concat!(
                "        CAN_RECV 2,PACKET\n",
                "        EQ   CNST.0\n",
                "        JL0  NOTHING\n",
                "        LOD  BYTE.(PACKET+4)\n",
                "        STO  LEVEL\n",
                "NOTHING:"
            ),
            "LEVEL gets the first data byte of a packet, if one came.",
            "LEVEL dostane první datový bajt paketu, pokud nějaký přišel.",
        )],
        related: &["CAN_RECV_REQ", "CAN_SEND"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_RECV_REQ",
        chapter: "9.4",
        forms: &[form("CAN_RECV_REQ can, objl, [objh], idl, [idh], proc, packet")],
        operands: &[
            CAN,
            operand(
                "objl",
                OperandKind::Number { min: 0, max: LAST_OBJECT },
                "Lowest message object to accept, in place: bits 7 to 10 of the identifier, for instance 580h",
                "Nejnižší přijímaný objekt zprávy na svém místě: bity 7 až 10 identifikátoru, například 580h",
            ),
            operand(
                "objh",
                OperandKind::Number { min: 0, max: LAST_OBJECT },
                "Highest object; `-` accepts `objl` alone",
                "Nejvyšší objekt; `-` přijímá jen `objl`",
            )
            .or_dash(),
            operand(
                "idl",
                OperandKind::Number { min: 0, max: LAST_NODE },
                "Lowest NODE-ID to accept, bits 0 to 6 of the identifier",
                "Nejnižší přijímané NODE-ID, bity 0 až 6 identifikátoru",
            ),
            operand(
                "idh",
                OperandKind::Number { min: 0, max: LAST_NODE },
                "Highest NODE-ID; `-` accepts `idl` alone",
                "Nejvyšší NODE-ID; `-` přijímá jen `idl`",
            )
            .or_dash(),
            operand(
                "proc",
                OperandKind::Procedure { declares: false },
                "Procedure called for each packet, with the number of the channel in DR",
                "Procedura volaná pro každý paket; v DR má číslo kanálu",
            ),
            RECEIVED,
        ],
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Asks that a procedure be called for every CAN packet with an identifier in the given range.",
            "Požádá o volání procedury po příchodu každého CAN paketu s identifikátorem v zadaném \
             rozsahu.",
        ),
        description: text(
            "From now on each packet of the channel whose object lies within `objl` to `objh` and whose NODE-ID \
             lies within `idl` to `idh` is copied to `packet`, and `proc` is called. The procedures run at the \
             start of the next cycle, before MODULE_INPUT, once per packet in the order of arrival (this \
             implementation).\n\n\
             One request lasts until CAN_RECV_END, so it belongs into MODULE_INIT. DR returns its handle, a \
             DWORD to keep when the request is to be cancelled.",
            "Od této chvíle se každý paket kanálu, jehož objekt leží mezi `objl` a `objh` a NODE-ID mezi `idl` a \
             `idh`, zkopíruje do `packet` a zavolá se `proc`. Procedury se provedou na začátku příštího cyklu před \
             MODULE_INPUT, pro každý paket jednou a v pořadí příchodu (tato implementace).\n\n\
             Požadavek trvá až do CAN_RECV_END, patří proto do MODULE_INIT. V DR se vrací jeho číslo typu DWORD, \
             které je třeba uschovat, má-li se požadavek později zrušit.",
        ),
        errors: text(
            "RLO is 1 when the request was accepted and DR holds its handle; RLO is 0 when it was not, for \
             instance because the channel is not active.",
            "RLO je 1, když byl požadavek přijat a v DR je jeho číslo; RLO je 0, když přijat nebyl, například \
             proto, že kanál není aktivní.",
        ),
        examples: &[example(
            concat!(
                "        CAN_RECV_REQ 2,580h,-,21h,24h,ANSWER,PACKET\n",
                "        STO  DWRD.HANDLE\n",
                "        WR   LISTENING"
            ),
            "The procedure ANSWER runs for every packet 5A1h to 5A4h.",
            "Procedura ANSWER se provede pro každý paket 5A1h až 5A4h.",
        )],
        related: &["CAN_RECV_END", "CAN_SEND", "PROC_BEGIN"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_RECV_END",
        chapter: "9.4",
        forms: &[form("CAN_RECV_END handle")],
        operands: &[HANDLE],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Cancels a request made by CAN_RECV_REQ.",
            "Zruší požadavek zadaný instrukcí CAN_RECV_REQ.",
        ),
        description: text(
            "Packets that come later no longer call the procedure. DR stays (this implementation).",
            "Později přijaté pakety už proceduru nevolají. DR se nemění (tato implementace).",
        ),
        errors: text(
            "RLO is 1 when the request was cancelled, 0 when there is none with this handle.",
            "RLO je 1, když byl požadavek zrušen, a 0, když žádný s tímto číslem neexistuje.",
        ),
        examples: &[example(
            concat!("        CAN_RECV_END HANDLE\n", "        WR   SILENT"),
            "Stops listening to the packets asked for by CAN_RECV_REQ.",
            "Ukončí příjem paketů vyžádaných pomocí CAN_RECV_REQ.",
        )],
        related: &["CAN_RECV_REQ", "CAN_RECV_DEL"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_RECV_DEL",
        chapter: "9.4",
        forms: &[form("CAN_RECV_DEL handle")],
        operands: &[HANDLE],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text("Another name of CAN_RECV_END.", "Jiné jméno instrukce CAN_RECV_END."),
        description: text(
            "Means the same as CAN_RECV_END, which the examples of the manual use; both names are taken (this \
             implementation).",
            "Znamená totéž co CAN_RECV_END, kterou používají příklady příručky; přijímají se obě jména (tato \
             implementace).",
        ),
        errors: text(
            "RLO is 1 when the request was cancelled, 0 when there is none with this handle.",
            "RLO je 1, když byl požadavek zrušen, a 0, když žádný s tímto číslem neexistuje.",
        ),
        examples: &[example(
            concat!("        CAN_RECV_DEL HANDLE\n", "        WR   SILENT"),
            "Write CAN_RECV_END in new programs.",
            "V nových programech pište CAN_RECV_END.",
        )],
        related: &["CAN_RECV_END", "CAN_RECV_REQ"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_SYSIO_READ",
        chapter: "9.5",
        forms: &[form("CAN_SYSIO_READ can, group, board, item")],
        operands: SYSTEM_UNIT,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64],
        summary: text(
            "Reads a value of a system CAN unit into DR; RLO 0 means success.",
            "Přečte údaj systémové CAN jednotky do DR; RLO 0 znamená úspěch.",
        ),
        description: text(
            concat!(
                "Reads one member of the structure INOUTS that the control keeps for each of its own units; the \
                 unit is found by group and number, not by its NODE-ID, which is 20h, 40h or 44h plus `board` for \
                 the groups 1, 2 and 3.\n\n",
                "BYTE members are `PRESENT` (the unit answers), `MODE` (0 standard, 1 analogue, 2 \
                 matrix), `IN0` to `IN3`, `OUT0` to `OUT2`, `ANL0` to `ANL7`, `ERROR` (error register at this \
                 moment), `ERR_CODE` (the error that came), `ERR_STAT`, `CONTROL`, `SEND_REQ`, `RESP_COUNT`, \
                 `SHORT_SEND_REQ`, `SHORT_OUT0` to `SHORT_OUT2`, `MODE_ACT`, `MODE_FAZE` and the buttons `TL0` to \
                 `TL3`; WORD members `SIZE`, `COUNT` (time-out), `RPDO_COUNT`, `TPDO_COUNT`, `PxIN` and `PxOUT` (numbers \
                 of the ports), `IRC0` and `IRC1`; DWORD members `VENDORID`, `DEVICENAME`, `HWVERSION` and \
                 `SWVERSION`.\n\n",
                "A member is loaded without sign into the whole DR (this implementation)."
            ),
            concat!(
                "Přečte jednu položku struktury INOUTS, kterou systém vede pro každou ze svých jednotek; jednotku \
                 určuje skupina a pořadí, nikoli NODE-ID, které je 20h, 40h nebo 44h plus `board` pro skupiny 1, 2 \
                 a 3.\n\n",
                "Položky typu BYTE jsou `PRESENT` (jednotka odpovídá), `MODE` (0 standard, 1 analog, 2 \
                 matice), `IN0` až `IN3`, `OUT0` až `OUT2`, `ANL0` až `ANL7`, `ERROR` (okamžitý stav registru \
                 chyb), `ERR_CODE` (chyba, která nastala), `ERR_STAT`, `CONTROL`, `SEND_REQ`, `RESP_COUNT`, \
                 `SHORT_SEND_REQ`, `SHORT_OUT0` až `SHORT_OUT2`, `MODE_ACT`, `MODE_FAZE` a tlačítka `TL0` až \
                 `TL3`; typu WORD `SIZE`, `COUNT` (time-out), `RPDO_COUNT`, `TPDO_COUNT`, `PxIN` a `PxOUT` (čísla portů), \
                 `IRC0` a `IRC1`; typu DWORD `VENDORID`, `DEVICENAME`, `HWVERSION` a `SWVERSION`.\n\n",
                "Položka se načte bez znaménka do celého DR (tato implementace)."
            ),
        ),
        errors: text(
            "RLO is 0 on success. RLO is 1 when the unit or member was not found; DR then stays (this \
             implementation) and must not be used. Mind that other CAN instructions say success with 1.",
            "RLO je 0 při úspěchu. RLO je 1, když se jednotka nebo položka nenašla; DR pak zůstává (tato \
             implementace) a nesmí se použít. Pozor, ostatní CAN instrukce hlásí úspěch hodnotou 1.",
        ),
        examples: &[example(
            concat!(
                "        CAN_SYSIO_READ 2,1,3,ANL0\n",
                "        JL1  NO_UNIT\n",
                "        STO  BYTE.LEVEL\n",
                "NO_UNIT:"
            ),
            "Analogue input 0 of the third INOUT08 unit, NODE-ID 23h.",
            "Analogový vstup 0 třetí jednotky INOUT08, NODE-ID 23h.",
        )],
        related: &["CAN_SYSIO_WRITE", "MAP_AIN"],
        ..INSTRUCTION
    },
    Entry {
        name: "CAN_SYSIO_WRITE",
        chapter: "9.5",
        forms: &[form("CAN_SYSIO_WRITE can, group, board, item")],
        operands: SYSTEM_UNIT,
        equation: Equation::Overwrite,
        reads: &[Effect::Dr],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Writes DR to a value of a system CAN unit; RLO 0 means success.",
            "Zapíše DR do údaje systémové CAN jednotky; RLO 0 znamená úspěch.",
        ),
        description: text(
            "Writes DR8, DR16 or DR32, whichever the member takes, to the structure INOUTS of the unit; members and \
             units are those of CAN_SYSIO_READ. Members that the control itself fills, such as `IN0` or `PRESENT`, \
             may be written, but the next cycle brings their true value back (this implementation). DR stays.",
            "Zapíše DR8, DR16 nebo DR32, podle typu položky, do struktury INOUTS jednotky; položky a jednotky jsou \
             stejné jako u CAN_SYSIO_READ. Položky, které plní sám systém, například `IN0` nebo `PRESENT`, zapsat \
             lze, příští cyklus ale vrátí jejich skutečnou hodnotu (tato implementace). DR se nemění.",
        ),
        errors: text(
            "RLO is 0 on success, 1 when the unit or member was not found and nothing was written.",
            "RLO je 0 při úspěchu a 1, když se jednotka nebo položka nenašla a nic se nezapsalo.",
        ),
        examples: &[example(
            concat!("        LOD  CNST.1\n", "        CAN_SYSIO_WRITE 2,1,4,MODE\n", "        WR   NO_UNIT"),
            "Switches the fourth INOUT08 unit to analogue inputs.",
            "Přepne čtvrtou jednotku INOUT08 na analogové vstupy.",
        )],
        related: &["CAN_SYSIO_READ"],
        ..INSTRUCTION
    },
    Entry {
        name: "LDR_LIC",
        chapter: "8.4.7",
        forms: &[form("LDR_LIC feature")],
        operands: &[operand(
            "feature",
            OperandKind::Keyword(&[
                "HwKeyConnected",
                "FeaturePlc0",
                "FeaturePlc1",
                "FeaturePlc2",
                "FeaturePlc3",
                "FeaturePlc4",
                "FeaturePlc5",
                "FeaturePlc6",
                "FeaturePlc7",
                "FeaturePlc8",
                "FeaturePlc9",
            ]),
            "Licence of the program, or the presence of the hardware key",
            "Licence programu, nebo přítomnost hardwarového klíče",
        )],
        equation: Equation::Open,
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text(
            "Sets RLO when a licence is valid or the hardware key is connected.",
            "Nastaví RLO, když platí licence nebo je připojen hardwarový klíč.",
        ),
        description: text(
            "Loads 1 into RLO when the licence is valid or, for `HwKeyConnected`, when the key is plugged in; \
             otherwise 0. Licences of the program are bound to the hardware key. Apart from its operand it acts \
             like LDR: it opens an equation, or pushes RLO when one is open (this implementation).",
            "Naplní RLO hodnotou 1, když licence platí nebo, u `HwKeyConnected`, když je klíč zasunut; jinak 0. \
             Licence programu jsou vázány na hardwarový klíč. Až na operand se chová jako LDR: rovnici otevře, je-li \
             už některá otevřená, uloží RLO na zásobník (tato implementace).",
        ),
        examples: &[example(
            concat!("        LDR_LIC FeaturePlc0\n", "        LA   DOOR\n", "        WR   ROBOT_ALLOWED"),
            "The robot may run only with the licence for feature 0.",
            "Robot smí pracovat jen s licencí funkce 0.",
        )],
        related: &["LDR", "LA"],
        ..INSTRUCTION
    },
];

const SYSTEM_UNIT: &[OperandSpec] = &[
    CAN,
    operand(
        "group",
        OperandKind::Number { min: 1, max: 3 },
        "Group of units: 1 is INOUT08, 2 is KLA50, 3 is a hand panel with wheel and display",
        "Skupina jednotek: 1 je INOUT08, 2 je KLA50, 3 je panýlek s točítkem a displejem",
    ),
    operand(
        "board",
        OperandKind::Number { min: 1, max: 32 },
        "Ordinal number of the unit in its group",
        "Pořadové číslo jednotky ve skupině",
    ),
    operand(
        "item",
        OperandKind::Keyword(&[
            "SIZE",
            "PRESENT",
            "MODE",
            "VENDORID",
            "DEVICENAME",
            "HWVERSION",
            "SWVERSION",
            "IN0",
            "IN1",
            "IN2",
            "IN3",
            "OUT0",
            "OUT1",
            "OUT2",
            "ANL0",
            "ANL1",
            "ANL2",
            "ANL3",
            "ANL4",
            "ANL5",
            "ANL6",
            "ANL7",
            "ERROR",
            "ERR_CODE",
            "ERR_STAT",
            "CONTROL",
            "COUNT",
            "SEND_REQ",
            "RESP_COUNT",
            "SHORT_SEND_REQ",
            "SHORT_OUT0",
            "SHORT_OUT1",
            "SHORT_OUT2",
            "RPDO_COUNT",
            "TPDO_COUNT",
            "PxIN",
            "PxOUT",
            "MODE_ACT",
            "MODE_FAZE",
            "TL0",
            "TL1",
            "TL2",
            "TL3",
            "IRC0",
            "IRC1",
        ]),
        "Member of the unit's structure INOUTS, which also decides the width",
        "Položka struktury INOUTS dané jednotky; určuje i šířku údaje",
    ),
];
