//! Structures of the control: CAN-BUS units, time, the display of the wheel panel (manual 8.4.2, 8.4.3 and 9.5).
//!
//! A member is an offset with a type; the name of the structure stands for its length.

use super::Direction::{self, Both, CncToPlc, PlcToCnc};
use super::space::symbol;
use super::{SystemKind, SystemSymbol, generated};
use crate::catalogue::entry::{Bilingual, Prefix};
use crate::catalogue::pattern::text;

/// Members in the order of their offsets.
struct Structure {
    name: &'static str,
    direction: Direction,
    chapter: &'static str,
    /// What the structure describes.
    summary: Bilingual,
    /// Name (empty for bytes without one), type, number, meaning.
    members: &'static [(&'static str, Prefix, u32, Bilingual)],
}

/// Length of a CAN packet.
const PACKET: u32 = 12;
/// Words of a far pointer.
const POINTER: u32 = 2;

const BYTE: Prefix = Prefix::Byte;
const WORD: Prefix = Prefix::Word;
const DWORD: Prefix = Prefix::Dwrd;

const STRUCTURES: &[Structure] = &[
    Structure {
        name: "TIME_INFOS",
        direction: CncToPlc,
        chapter: "8.4.2",
        summary: text("time of day", "denní čas"),
        members: &[
            ("TIME_MIN", BYTE, 1, text("minutes", "minuty")),
            ("TIME_HOUR", BYTE, 1, text("hours", "hodiny")),
            ("TIME_HUND", BYTE, 1, text("hundredths of a second", "setiny sekundy")),
            ("TIME_SEC", BYTE, 1, text("seconds", "sekundy")),
        ],
    },
    Structure {
        name: "DATE_INFOS",
        direction: CncToPlc,
        chapter: "8.4.2",
        summary: text("date", "datum"),
        members: &[
            ("DATE_YEAR", WORD, 1, text("year", "rok")),
            ("DATE_DAY", BYTE, 1, text("day", "den")),
            ("DATE_MON", BYTE, 1, text("month", "měsíc")),
        ],
    },
    Structure {
        name: "FILETIME_INFOS",
        direction: CncToPlc,
        chapter: "8.4.2",
        summary: text("64-bit FILETIME", "64bitový FILETIME"),
        members: &[
            ("LOW_FILETIME", DWORD, 1, text("lower half", "spodní polovina")),
            ("HIGH_FILETIME", DWORD, 1, text("upper half", "horní polovina")),
        ],
    },
    Structure {
        name: "TOC_DISPLS",
        direction: PlcToCnc,
        chapter: "8.4.3",
        summary: text("display of the wheel panel", "displej panelu s kolečkem"),
        members: &[
            ("TOC_ROW", BYTE, 1, text("row in pixels", "řádek v bodech")),
            ("TOC_COLUMN", BYTE, 1, text("column in pixels", "sloupec v bodech")),
            (
                "TOC_CHAR1",
                BYTE,
                1,
                text("first character; 0FFh leaves what is shown", "první znak; 0FFh ponechá zobrazený"),
            ),
            ("TOC_CHAR2", BYTE, 1, text("second character", "druhý znak")),
            ("TOC_CHAR3", BYTE, 1, text("third character", "třetí znak")),
            ("TOC_CHAR4", BYTE, 1, text("fourth character", "čtvrtý znak")),
            ("TOC_SIZE", BYTE, 1, text("size of the characters", "velikost znaků")),
            ("TOC_INV", BYTE, 1, text("inversion", "inverze")),
        ],
    },
];

/// State of a CAN-BUS unit. Its members are operands of CAN_SYSIO_READ and CAN_SYSIO_WRITE and nothing else, so
/// that a program may call its cells `COUNT` or `ERROR`.
const UNIT: Structure = Structure {
    name: "INOUTS",
    direction: Both,
    chapter: "9.5",
    summary: text("state of a CAN-BUS unit", "stav jednotky CAN-BUS"),
    members: &[
        ("SIZE", WORD, 1, text("length of the structure", "délka struktury")),
        ("PRESENT", BYTE, 1, text("the unit is present", "jednotka je přítomna")),
        (
            "MODE",
            BYTE,
            1,
            text("mode: 0 standard, 1 analogue, 2 matrix", "režim: 0 standardní, 1 analogový, 2 maticový"),
        ),
        ("VENDORID", DWORD, 1, text("vendor, object 1018h", "výrobce, objekt 1018h")),
        ("DEVICENAME", DWORD, 1, text("name of the device, object 1008h", "jméno zařízení, objekt 1008h")),
        ("HWVERSION", DWORD, 1, text("hardware version, object 1009h", "verze hardwaru, objekt 1009h")),
        ("SWVERSION", DWORD, 1, text("software version, object 100Ah", "verze softwaru, objekt 100Ah")),
        ("IN0", BYTE, 1, text("input byte IP0", "vstupní bajt IP0")),
        ("IN1", BYTE, 1, text("input byte IP1", "vstupní bajt IP1")),
        ("IN2", BYTE, 1, text("input byte IP2", "vstupní bajt IP2")),
        ("IN3", BYTE, 1, text("input byte IP3", "vstupní bajt IP3")),
        ("OUT0", BYTE, 1, text("output byte OP0", "výstupní bajt OP0")),
        ("OUT1", BYTE, 1, text("output byte OP1", "výstupní bajt OP1")),
        ("OUT2", BYTE, 1, text("output byte OP2", "výstupní bajt OP2")),
        ("", BYTE, 1, NO_MEANING),
        ("ANL0", BYTE, 1, text("analogue input 0", "analogový vstup 0")),
        ("ANL1", BYTE, 1, text("analogue input 1", "analogový vstup 1")),
        ("ANL2", BYTE, 1, text("analogue input 2", "analogový vstup 2")),
        ("ANL3", BYTE, 1, text("analogue input 3", "analogový vstup 3")),
        ("ANL4", BYTE, 1, text("analogue input 4", "analogový vstup 4")),
        ("ANL5", BYTE, 1, text("analogue input 5", "analogový vstup 5")),
        ("ANL6", BYTE, 1, text("analogue input 6", "analogový vstup 6")),
        ("ANL7", BYTE, 1, text("analogue input 7", "analogový vstup 7")),
        (
            "ERROR",
            BYTE,
            1,
            text("error register 1001h, bits ERR_IO8_…", "chybový registr 1001h, bity ERR_IO8_…"),
        ),
        ("ERR_CODE", BYTE, 1, text("last error, bits ERR_IO8_…", "poslední chyba, bity ERR_IO8_…")),
        ("ERR_STAT", BYTE, 1, text("error state, bits IO_ER_…", "stav chyb, bity IO_ER_…")),
        ("CONTROL", BYTE, 1, text("control, bits IO_DIS_…", "řízení, bity IO_DIS_…")),
        ("COUNT", WORD, 1, text("counter of the time-out", "čítač výpadku odezvy")),
        ("SEND_REQ", BYTE, 1, text("request to send the packet SEND", "žádost o vyslání paketu SEND")),
        ("RESP_COUNT", BYTE, 1, text("counter of answers", "čítač odpovědí")),
        (
            "SHORT_SEND_REQ",
            BYTE,
            1,
            text("request for short-circuit information", "žádost o informaci o zkratu"),
        ),
        ("SHORT_OUT0", BYTE, 1, text("short-circuited outputs of OP0", "zkratované výstupy OP0")),
        ("SHORT_OUT1", BYTE, 1, text("short-circuited outputs of OP1", "zkratované výstupy OP1")),
        ("SHORT_OUT2", BYTE, 1, text("short-circuited outputs of OP2", "zkratované výstupy OP2")),
        ("SEND", BYTE, PACKET, text("packet to send", "paket k vyslání")),
        ("RESP", BYTE, PACKET, text("packet with the answer", "paket s odpovědí")),
        ("RPDO_COUNT", WORD, 1, text("counter of RPDO packets queued", "čítač zařazených paketů RPDO")),
        ("TPDO_COUNT", WORD, 1, text("counter of TPDO packets received", "čítač přijatých paketů TPDO")),
        (
            "PxIN",
            WORD,
            1,
            text("number of the first input port, 1 is P1IN", "číslo vstupního portu, 1 je P1IN"),
        ),
        (
            "PxOUT",
            WORD,
            1,
            text("number of the first output port, 1 is P1OUT", "číslo výstupního portu, 1 je P1OUT"),
        ),
        ("lpINOUT_PxIN", WORD, POINTER, text("pointer to the input port", "ukazatel na vstupní port")),
        ("lpINOUT_PxOUT", WORD, POINTER, text("pointer to the output port", "ukazatel na výstupní port")),
        (
            "lpINOUT_ERRHI_PxOUT",
            WORD,
            POINTER,
            text("pointer to the errors of the output port", "ukazatel na chyby výstupního portu"),
        ),
        (
            "lpINOUT_SETH_PxOUT",
            WORD,
            POINTER,
            text("pointer to the mask of the output port", "ukazatel na masku výstupního portu"),
        ),
        (
            "lpINOUT_SETH_PxIN",
            WORD,
            POINTER,
            text("pointer to the mask of the input port", "ukazatel na masku vstupního portu"),
        ),
        ("MODE_ACT", BYTE, 1, text("actual mode", "skutečný režim")),
        ("MODE_FAZE", BYTE, 1, text("phase of switching the mode", "fáze přepínání režimu")),
        ("TL0", BYTE, 1, text("matrix key code 0", "kód tlačítka matice 0")),
        ("TL1", BYTE, 1, text("matrix key code 1", "kód tlačítka matice 1")),
        ("TL2", BYTE, 1, text("matrix key code 2", "kód tlačítka matice 2")),
        ("TL3", BYTE, 1, text("matrix key code 3", "kód tlačítka matice 3")),
        ("IRC0", WORD, 1, text("encoder counter 0", "čítač snímače 0")),
        ("IRC1", WORD, 1, text("encoder counter 1", "čítač snímače 1")),
    ],
};

/// Of bytes without a name.
const NO_MEANING: Bilingual = text("", "");

impl Structure {
    fn len(&self) -> u32 {
        self.members.iter().map(|(_, element, len, _)| element.bytes() * len).sum()
    }

    /// The name, which stands for the length.
    fn name(&self) -> SystemSymbol {
        let Structure { name, direction, chapter, summary, .. } = self;
        let len = self.len();
        let summary = Bilingual {
            en: generated(format!(
                "Structure ({}); the name stands for its length, {len} bytes (this implementation).",
                summary.en
            )),
            cs: generated(format!(
                "Struktura ({}); jméno znamená její délku, {len} bajtů (tato implementace).",
                summary.cs
            )),
        };
        symbol(name, SystemKind::Constant(i64::from(len)), *direction, chapter, summary)
    }

    fn members(&self, symbols: &mut Vec<SystemSymbol>) {
        let Structure { name, direction, chapter, summary, members } = self;
        let mut offset = 0;
        for &(member, element, len, meaning) in *members {
            if !member.is_empty() {
                let summary = Bilingual {
                    en: generated(format!("Member of {name} ({}): {}.", summary.en, meaning.en)),
                    cs: generated(format!("Položka {name} ({}): {}.", summary.cs, meaning.cs)),
                };
                let kind = SystemKind::Member { offset, element, len };
                symbols.push(symbol(member, kind, *direction, chapter, summary));
            }
            offset += element.bytes() * len;
        }
    }
}

/// Structures with their members, and the name of INOUTS.
pub(super) fn list(symbols: &mut Vec<SystemSymbol>) {
    for structure in STRUCTURES {
        structure.members(symbols);
        symbols.push(structure.name());
    }
    symbols.push(UNIT.name());
}

/// Lists the members of INOUTS; gives its length.
pub(super) fn list_unit(symbols: &mut Vec<SystemSymbol>) -> u32 {
    UNIT.members(symbols);
    UNIT.len()
}

#[cfg(test)]
mod tests {
    use super::{BYTE, DWORD, STRUCTURES, SystemKind, UNIT, WORD};
    use crate::catalogue::{symbol, unit_member, unit_members};

    #[test]
    fn members_lie_where_the_listing_of_the_manual_puts_them() {
        for (name, at, bytes, count) in [
            ("TIME_SEC", 3, BYTE, 1),
            ("DATE_MON", 3, BYTE, 1),
            ("HIGH_FILETIME", 4, DWORD, 1),
            ("TOC_INV", 7, BYTE, 1),
            ("VENDORID", 4, DWORD, 1),
            ("ANL0", 28, BYTE, 1),
            ("COUNT", 40, WORD, 1),
            ("SEND", 48, BYTE, 12),
            ("IRC1", 108, WORD, 1),
        ] {
            let kind = symbol(name).or_else(|| unit_member(name)).map(|symbol| symbol.kind);
            assert_eq!(kind, Some(SystemKind::Member { offset: at, element: bytes, len: count }), "{name}");
        }
    }

    #[test]
    fn the_name_of_a_structure_is_its_length() {
        for (name, len) in
            [("TIME_INFOS", 4), ("DATE_INFOS", 4), ("FILETIME_INFOS", 8), ("TOC_DISPLS", 8), ("INOUTS", 110)]
        {
            assert_eq!(symbol(name).map(|symbol| symbol.kind), Some(SystemKind::Constant(len)), "{name}");
        }
    }

    #[test]
    fn words_and_double_words_are_aligned() {
        for structure in STRUCTURES.iter().chain([&UNIT]) {
            let mut offset = 0;
            for (name, element, len, _) in structure.members {
                assert_eq!(offset % element.bytes(), 0, "{name}");
                offset += element.bytes() * len;
            }
        }
    }

    #[test]
    fn names_of_a_unit_stay_free_for_the_program() {
        assert_eq!(unit_members().count(), 52);
        for member in unit_members() {
            assert!(symbol(member.name).is_none(), "{}", member.name);
        }
    }
}
