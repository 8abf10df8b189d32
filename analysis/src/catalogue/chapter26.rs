//! Chapter 26: EtherCAT.

use super::entry::{Access, Bilingual, Entry, OperandKind, OperandSpec, Prefix, PrefixSet};
use super::pattern::{BYTE_VALUE, WORD_VALUE, example, form, operand, text};
use super::transfer::{TRANSFER, cs_result, en_result};

/// The predefined names of commands, offered where a command is typed; their values are checked as numbers.
const COMMANDS: &[&str] = &[
    "ECATCMD_MASTER_INIT",
    "ECATCMD_MASTER_PREOPERATIONAL",
    "ECATCMD_MASTER_BOOTSTRAP",
    "ECATCMD_MASTER_SAFEOPERATIONAL",
    "ECATCMD_MASTER_OPERATIONAL",
    "ECATCMD_SLAVE_INIT",
    "ECATCMD_SLAVE_PREOPERATIONAL",
    "ECATCMD_SLAVE_BOOTSTRAP",
    "ECATCMD_SLAVE_SAFEOPERATIONAL",
    "ECATCMD_SLAVE_OPERATIONAL",
    "ECATCMD_MASTER_STATE",
    "ECATCMD_SLAVE_STATE",
];

const MASTER: OperandSpec = operand(
    "master",
    BYTE_VALUE,
    "Master from 0; 0 with a single one: number, constant or BYTE cell",
    "Master od 0; jediný má 0: číslo, konstanta nebo buňka BYTE",
);
const SLAVE: OperandSpec = operand(
    "slave",
    WORD_VALUE,
    "Slave from 0 in the order of wiring: number, constant or WORD cell",
    "Slave od 0 v pořadí zapojení: číslo, konstanta nebo buňka WORD",
);
const INDEX: OperandSpec = operand(
    "index",
    WORD_VALUE,
    "Index of the object: number, constant or WORD cell",
    "Index objektu: číslo, konstanta nebo buňka WORD",
);
const SUBINDEX: OperandSpec = operand(
    "subindex",
    BYTE_VALUE,
    "Subindex of the object: number, constant or BYTE cell",
    "Subindex objektu: číslo, konstanta nebo buňka BYTE",
);
const DRIVE: OperandSpec = operand(
    "drive",
    BYTE_VALUE,
    "Drive inside the slave, from 0: number, constant or BYTE cell",
    "Pohon uvnitř zařízení od 0: číslo, konstanta nebo buňka BYTE",
);
const FLAGS: OperandSpec = operand(
    "flags",
    cell(Access::ReadWrite, Prefix::Byte),
    "BYTE cell with the ElementFlags, 40h for the value; the flags of the answer come back in it",
    "Buňka BYTE s ElementFlags, 40h pro hodnotu; vrátí se v ní příznaky odpovědi",
);
const IDN: OperandSpec = operand(
    "idn",
    WORD_VALUE,
    "Number of the register (IDN): number, constant or WORD cell",
    "Číslo registru (IDN): číslo, konstanta nebo buňka WORD",
);
const TARGET: OperandSpec = operand(
    "target",
    OperandKind::Address(Access::Write),
    "Cell, area or text with an optional offset, as long as the longest answer",
    "Buňka, oblast nebo text s případným posunem, dlouhé jako nejdelší odpověď",
);
const SOURCE: OperandSpec = operand(
    "source",
    OperandKind::Address(Access::Read),
    "Cell, area or text with an optional offset that holds the data",
    "Buňka, oblast nebo text s případným posunem, kde jsou data",
);
const LENGTH: OperandSpec = operand(
    "length",
    cell(Access::ReadWrite, Prefix::Dwrd),
    "DWORD cell: bytes wanted before, bytes transferred afterwards",
    "Buňka DWORD: před provedením požadovaný, po něm skutečný počet bajtů",
);

/// A cell handed by reference, of one type.
const fn cell(access: Access, prefix: Prefix) -> OperandKind {
    let only = PrefixSet::of(&[prefix]);
    OperandKind::Data { access, prefixes: only, declared: only, negatable: false }
}

const ERRORS: Bilingual = text(
    "RLO 1 with DR other than 0: no such slave or object, a refused access, a slave that does not answer. \
     Test it behind EX0 by EQ CNST.0 and JL0. The manual gives no numbers of errors.",
    "RLO 1 s nenulovým DR: zařízení nebo objekt neexistuje, přístup byl odmítnut nebo zařízení neodpovídá. \
     Otestujte to za EX0 pomocí EQ CNST.0 a JL0. Čísla chyb příručka neuvádí.",
);

/// An instruction of this chapter.
const MAILBOX: Entry = Entry { chapter: "26.4", errors: ERRORS, executable: true, ..TRANSFER };

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ECAT_COE_READ",
        forms: &[form("ECAT_COE_READ master, slave, index, subindex, target, length")],
        operands: &[MASTER, SLAVE, INDEX, SUBINDEX, TARGET, LENGTH],
        summary: text(
            "Reads a CANopen object of an EtherCAT slave.",
            "Přečte objekt CANopen zařízení na EtherCAT.",
        ),
        description: text(
            concat!(
                "One access through the mailbox (SDO) to an object of the profile of the slave. `length` must \
                 hold the number of bytes wanted, at most the room at `target`; it then tells how many came. \
                 Give it before the instruction each time, because it is overwritten.",
                en_result!()
            ),
            concat!(
                "Jeden přístup přes mailbox (SDO) k objektu profilu zařízení. V `length` musí být požadovaný \
                 počet bajtů, nejvýše tolik, kolik je místa v `target`; pak řekne, kolik jich přišlo. Protože \
                 se přepisuje, nastavte ho před instrukcí pokaždé.",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.2\n",
                "        STO  ECAT_LEN\n",
                "        ECAT_COE_READ 0,1,603Fh,0,ERR_CODE,ECAT_LEN\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_ANSWER"
            ),
            "Reads the error code, two bytes, of the second slave.",
            "Přečte chybový kód, dva bajty, druhého zařízení.",
        )],
        related: &["ECAT_COE_WRITE", "ECAT_SOE_READ", "ECAT_COMMAND", "EX0"],
        ..MAILBOX
    },
    Entry {
        name: "ECAT_COE_WRITE",
        forms: &[form("ECAT_COE_WRITE master, slave, index, subindex, source, length")],
        operands: &[MASTER, SLAVE, INDEX, SUBINDEX, SOURCE, LENGTH],
        summary: text(
            "Writes a CANopen object of an EtherCAT slave.",
            "Zapíše objekt CANopen zařízení na EtherCAT.",
        ),
        description: text(
            concat!(
                "One access through the mailbox (SDO) to an object of the profile of the slave. `length` must \
                 hold the number of bytes to write, which is the size of the object; it then tells how many \
                 were written (this implementation).",
                en_result!()
            ),
            concat!(
                "Jeden přístup přes mailbox (SDO) k objektu profilu zařízení. V `length` musí být počet \
                 zapisovaných bajtů, tedy velikost objektu; pak řekne, kolik jich bylo zapsáno (tato \
                 implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.8\n",
                "        STO  DRIVE_MODE\n",
                "        LOD  CNST.1\n",
                "        STO  ECAT_LEN\n",
                "        ECAT_COE_WRITE 0,1,6060h,0,DRIVE_MODE,ECAT_LEN\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_ANSWER"
            ),
            "Switches the second slave to cyclic positions, an object of one byte.",
            "Přepne druhé zařízení na cyklické polohy, objekt o jednom bajtu.",
        )],
        related: &["ECAT_COE_READ", "ECAT_SOE_WRITE", "ECAT_COMMAND"],
        ..MAILBOX
    },
    Entry {
        name: "ECAT_SOE_READ",
        forms: &[form("ECAT_SOE_READ master, slave, drive, flags, idn, target, length")],
        operands: &[MASTER, SLAVE, DRIVE, FLAGS, IDN, TARGET, LENGTH],
        summary: text(
            "Reads a SERCOS register of an EtherCAT slave.",
            "Přečte registr SERCOS zařízení na EtherCAT.",
        ),
        description: text(
            concat!(
                "One access through the mailbox to a register of the S or P class. `flags` chooses the element \
                 of the register, 40h its value, and returns the flags of the answer; `length` holds the number \
                 of bytes wanted and then how many came. Both are overwritten, give them before the instruction \
                 each time. Registers of the P class have bit 15 of the number set (this implementation).",
                en_result!()
            ),
            concat!(
                "Jeden přístup přes mailbox k registru třídy S nebo P. `flags` určuje prvek registru, 40h jeho \
                 hodnotu, a vrátí příznaky odpovědi; v `length` je požadovaný a pak skutečný počet bajtů. Obojí \
                 se přepisuje, nastavte je před instrukcí pokaždé. Registry třídy P mají nastaven bit 15 čísla \
                 (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.40h\n",
                "        STO  ELEMENT\n",
                "        LOD  CNST.4\n",
                "        STO  ECAT_LEN\n",
                "        ECAT_SOE_READ 0,0,0,ELEMENT,51,DRIVE_POS,ECAT_LEN\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_ANSWER"
            ),
            "Reads the position feedback S-0-0051 of the first slave.",
            "Přečte polohu S-0-0051 prvního zařízení.",
        )],
        related: &["ECAT_SOE_WRITE", "ECAT_COE_READ", "ECAT_COMMAND"],
        ..MAILBOX
    },
    Entry {
        name: "ECAT_SOE_WRITE",
        forms: &[form("ECAT_SOE_WRITE master, slave, drive, flags, idn, source, length")],
        operands: &[MASTER, SLAVE, DRIVE, FLAGS, IDN, SOURCE, LENGTH],
        summary: text(
            "Writes a SERCOS register of an EtherCAT slave.",
            "Zapíše registr SERCOS zařízení na EtherCAT.",
        ),
        description: text(
            concat!(
                "One access through the mailbox to a register of the S or P class. `flags` chooses the element \
                 of the register, 40h its value, and returns the flags of the answer; `length` holds the number \
                 of bytes to write and then how many were written (this implementation).",
                en_result!()
            ),
            concat!(
                "Jeden přístup přes mailbox k registru třídy S nebo P. `flags` určuje prvek registru, 40h jeho \
                 hodnotu, a vrátí příznaky odpovědi; v `length` je počet zapisovaných a pak skutečně zapsaných \
                 bajtů (tato implementace).",
                cs_result!()
            ),
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.40h\n",
                "        STO  ELEMENT\n",
                "        LOD  CNST.2\n",
                "        STO  ECAT_LEN\n",
                "        ECAT_SOE_WRITE 0,0,0,ELEMENT,32,DRIVE_MODE,ECAT_LEN\n",
                "        EX0\n",
                "        EQ   CNST.0\n",
                "        JL0  NO_ANSWER"
            ),
            "Writes the WORD DRIVE_MODE to the operation mode S-0-0032.",
            "Zapíše WORD DRIVE_MODE do provozního režimu S-0-0032.",
        )],
        related: &["ECAT_SOE_READ", "ECAT_COE_WRITE", "ECAT_COMMAND"],
        ..MAILBOX
    },
    Entry {
        name: "ECAT_COMMAND",
        forms: &[
            form("ECAT_COMMAND master, slave, command"),
            form("ECAT_COMMAND master, slave, command, target, length"),
        ],
        operands: &[
            MASTER,
            SLAVE,
            operand(
                "command",
                OperandKind::OneOf(&[
                    OperandKind::Number { min: 1, max: 21 },
                    OperandKind::Keyword(COMMANDS),
                ]),
                "Command, one of the predefined ECATCMD_ constants",
                "Příkaz, jedna z předdefinovaných konstant ECATCMD_",
            ),
            TARGET.or_nothing(),
            LENGTH.or_nothing(),
        ],
        summary: text(
            "Sends a command to the EtherCAT master: change or query of a state.",
            "Pošle příkaz EtherCAT masteru: změnu nebo dotaz na stav.",
        ),
        description: text(
            concat!(
                "ECATCMD_MASTER_INIT (1), _PREOPERATIONAL (2), _BOOTSTRAP (3), _SAFEOPERATIONAL (4) and \
                 _OPERATIONAL (8) lead the master with all its slaves to that state, the same names with \
                 ECATCMD_SLAVE_ (11, 12, 13, 14, 18) one slave. ECATCMD_MASTER_STATE (20) and \
                 ECATCMD_SLAVE_STATE (21) store the state at `target`; only they need `target` and `length`. \
                 The first byte of the answer is ECAT_INIT (1), ECAT_PREOPERATIONAL (2), ECAT_BOOTSTRAP (3), \
                 ECAT_SAFEOPERATIONAL (4) or ECAT_OPERATIONAL (8).\n\nFor a command to the master give 0 as \
                 slave (this implementation). Other commands ignore `target` and `length` (this \
                 implementation).",
                en_result!()
            ),
            concat!(
                "ECATCMD_MASTER_INIT (1), _PREOPERATIONAL (2), _BOOTSTRAP (3), _SAFEOPERATIONAL (4) a \
                 _OPERATIONAL (8) převedou do daného stavu master se všemi zařízeními, táž jména s \
                 ECATCMD_SLAVE_ (11, 12, 13, 14, 18) jedno zařízení. ECATCMD_MASTER_STATE (20) a \
                 ECATCMD_SLAVE_STATE (21) uloží stav do `target`; jen tyto dva potřebují `target` a `length`. \
                 První bajt odpovědi je ECAT_INIT (1), ECAT_PREOPERATIONAL (2), ECAT_BOOTSTRAP (3), \
                 ECAT_SAFEOPERATIONAL (4) nebo ECAT_OPERATIONAL (8).\n\nU příkazu pro master se jako slave \
                 uvádí 0 (tato implementace). Ostatní příkazy si `target` a `length` nevšímají (tato \
                 implementace).",
                cs_result!()
            ),
        ),
        examples: &[
            example(
                concat!(
                    "        ECAT_COMMAND 0,2,ECATCMD_SLAVE_OPERATIONAL\n",
                    "        EX0\n",
                    "        EQ   CNST.0\n",
                    "        JL0  NO_ANSWER"
                ),
                "Leads the third slave to OPERATIONAL.",
                "Převede třetí zařízení do stavu OPERATIONAL.",
            ),
            example(
                concat!(
                    "        LOD  CNST.4\n",
                    "        STO  ECAT_LEN\n",
                    "        ECAT_COMMAND 0,0,ECATCMD_MASTER_STATE,STATE,ECAT_LEN\n",
                    "        EX0\n",
                    "        EQ   CNST.0\n",
                    "        JL0  NO_ANSWER\n",
                    "        LOD  BYTE.STATE\n",
                    "        EQ   CNST.ECAT_OPERATIONAL\n",
                    "        WR   BUS_RUNS"
                ),
                "BUS_RUNS tells whether the master exchanges data.",
                "BUS_RUNS říká, zda master vyměňuje data.",
            ),
        ],
        related: &["ECAT_COE_READ", "ECAT_SOE_READ", "EX0"],
        ..MAILBOX
    },
];
