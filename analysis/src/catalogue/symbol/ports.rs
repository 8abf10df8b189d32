//! Input and output ports with their forcing masks and short-circuit bits (manual 9.2 and 9.3).

use technol_image::op::Addr;
use technol_image::system;

use super::space::symbol;
use super::{Direction, SystemKind, SystemSymbol, generated};
use crate::catalogue::entry::{Bilingual, Prefix};

/// One byte for every port of a kind.
struct Family {
    before: &'static str,
    after: &'static str,
    first: u32,
    count: u32,
    addr: Addr,
    direction: Direction,
    chapter: &'static str,
    /// What stands before the number.
    summary: Bilingual,
}

const FAMILIES: &[Family] = &[
    Family {
        before: "P",
        after: "IN",
        first: 1,
        count: system::IN_PORT_COUNT,
        addr: system::IN_PORTS,
        direction: Direction::CncToPlc,
        chapter: "9.2",
        summary: Bilingual { en: "Input port", cs: "Vstupní port" },
    },
    Family {
        before: "P",
        after: "OUT",
        first: 0,
        count: system::OUT_PORT_COUNT,
        addr: system::OUT_PORTS,
        direction: Direction::PlcToCnc,
        chapter: "9.2",
        summary: Bilingual { en: "Output port", cs: "Výstupní port" },
    },
    Family {
        before: "SETL_P",
        after: "IN",
        first: 1,
        count: system::IN_PORT_COUNT,
        addr: system::IN_FORCE_LOW,
        direction: Direction::Both,
        chapter: "9.3",
        summary: Bilingual {
            en: "Bits forced to 0 (wins over SETH_) in input port",
            cs: "Bity držené v 0 (mají přednost před SETH_) ve vstupním portu",
        },
    },
    Family {
        before: "SETH_P",
        after: "IN",
        first: 1,
        count: system::IN_PORT_COUNT,
        addr: system::IN_FORCE_HIGH,
        direction: Direction::Both,
        chapter: "9.3",
        summary: Bilingual {
            en: "Bits forced to 1 in input port", cs: "Bity držené v 1 ve vstupním portu"
        },
    },
    Family {
        before: "SETL_P",
        after: "OUT",
        first: 0,
        count: system::OUT_PORT_COUNT,
        addr: system::OUT_FORCE_LOW,
        direction: Direction::Both,
        chapter: "9.3",
        summary: Bilingual {
            en: "Bits forced to 0 (wins over SETH_) in output port",
            cs: "Bity držené v 0 (mají přednost před SETH_) ve výstupním portu",
        },
    },
    Family {
        before: "SETH_P",
        after: "OUT",
        first: 0,
        count: system::OUT_PORT_COUNT,
        addr: system::OUT_FORCE_HIGH,
        direction: Direction::Both,
        chapter: "9.3",
        summary: Bilingual {
            en: "Bits forced to 1 in output port",
            cs: "Bity držené v 1 ve výstupním portu",
        },
    },
    Family {
        before: "ERRLI_P",
        after: "OUT",
        first: 0,
        count: system::OUT_PORT_COUNT,
        addr: system::OUT_SHORTED,
        direction: Direction::Both,
        chapter: "9.3",
        summary: Bilingual {
            en: "Short-circuited bits of output port",
            cs: "Zkratované bity výstupního portu",
        },
    },
];

pub(super) fn list(symbols: &mut Vec<SystemSymbol>) {
    for family in FAMILIES {
        symbols.extend((0..family.count).map(|index| {
            let number = family.first + index;
            symbol(
                generated(format!("{}{number}{}", family.before, family.after)),
                SystemKind::Cell { addr: family.addr + index, prefix: Prefix::Byte },
                family.direction,
                family.chapter,
                Bilingual {
                    en: generated(format!("{} {number}.", family.summary.en)),
                    cs: generated(format!("{} {number}.", family.summary.cs)),
                },
            )
        }));
    }
}
