//! Members of a prepared block, `BLK[n].member` (manual 8.3).
//!
//! They are a structure of their own: the addresses here are offsets in the record of one block, whose places
//! are this implementation's choice.

use super::Direction::CncToPlc;
use super::SystemSymbol;
use super::space::{DWORD, Numbered, REAL, Row, Shape, Space};
use crate::catalogue::entry::{Bilingual, Prefix};
use crate::catalogue::pattern::text;

/// Groups of M functions; group 0 has a place too.
const M_GROUPS: u32 = 15;
/// Axes of the control.
const AXES: u32 = 16;
/// Parameters of each type for the program.
const PARAMETERS: u32 = 5;

const fn numbered(
    (before, after): (&'static str, &'static str),
    count: u32,
    en: &'static str,
    cs: &'static str,
) -> Numbered {
    let summary: Bilingual = text(en, cs);
    Numbered {
        before,
        after,
        first: 0,
        count,
        shape: Shape::Bit,
        direction: CncToPlc,
        chapter: "8.3.1",
        summary,
    }
}

const FAMILIES: &[Numbered] = &[
    numbered(
        ("M", ""),
        M_GROUPS,
        "An M function is programmed in the block, of group",
        "V bloku je programována funkce M skupiny",
    ),
    numbered(("AxNC", "Move"), AXES, "The block moves NC axis", "Blok pohybuje NC osou"),
    numbered(
        ("IPlc", ""),
        PARAMETERS,
        "The block changes the integer parameter for the PLC",
        "Blok mění celočíselný parametr pro PLC",
    ),
    numbered(
        ("RPlc", ""),
        PARAMETERS,
        "The block changes the real parameter for the PLC",
        "Blok mění reálný parametr pro PLC",
    ),
];

/// Name, shape, manual chapter, meaning; all are read only.
const fn row(
    name: &'static str,
    shape: Shape,
    chapter: &'static str,
    en: &'static str,
    cs: &'static str,
) -> Row {
    (name, shape, CncToPlc, chapter, text(en, cs))
}

const BITS: &str = "8.3.1";
const NUMBERS: &str = "8.3.3";
const REALS: &str = "8.3.4";

const ROWS: &[Row] = &[
    row("FirstBlock", Shape::Bit, BITS, "First block of the NC program.", "První blok NC programu."),
    row("LastBlock", Shape::Bit, BITS, "Last block of the NC program.", "Poslední blok NC programu."),
    row("Stop", Shape::Bit, BITS, "A stop (M00) is programmed.", "Je programován stop (M00)."),
    row(
        "CondStop",
        Shape::Bit,
        BITS,
        "A conditional stop (M01) is programmed.",
        "Je programován podmíněný stop (M01).",
    ),
    row("Backward", Shape::Bit, BITS, "The block runs backwards.", "Blok se provádí pozpátku."),
    row("SelBlock", Shape::Bit, BITS, "The block was selected.", "Blok byl zvolen volbou bloku."),
    row(
        "Cont",
        Shape::Bit,
        BITS,
        "The block approaches from a place off the path.",
        "Blok najíždí z místa mimo dráhu.",
    ),
    row(
        "TchlOff",
        Shape::Bit,
        BITS,
        "The block runs without technology.",
        "Blok se provádí bez technologie.",
    ),
    row(
        "Partial",
        Shape::Bit,
        BITS,
        "The block starts in its middle, after a stop.",
        "Blok začíná uprostřed, po stopu.",
    ),
    row("HProg", Shape::Bit, BITS, "Function H is programmed.", "Je programována funkce H."),
    row("TProg", Shape::Bit, BITS, "Function T is programmed.", "Je programována funkce T."),
    row(
        "RevFeed",
        Shape::Bit,
        BITS,
        "Feed per revolution (G95) is programmed.",
        "Je programován posuv na otáčku (G95).",
    ),
    row(
        "ContinuousMode",
        Shape::Bit,
        BITS,
        "Continuous run (G23) is programmed.",
        "Je programována plynulá jízda (G23).",
    ),
    row(
        "ConstCutSpeed",
        Shape::Bit,
        BITS,
        "Constant cutting speed (G96) is programmed.",
        "Je programována konstantní řezná rychlost (G96).",
    ),
    row(
        "M",
        Shape::Array(Prefix::Dwrd, M_GROUPS),
        NUMBERS,
        "M function of each group in BCD; the index is the group.",
        "Funkce M každé skupiny v BCD; index je skupina.",
    ),
    row(
        "IPlcParams",
        Shape::Array(Prefix::Dwrd, PARAMETERS),
        NUMBERS,
        "Integer parameters for the PLC.",
        "Celočíselné parametry pro PLC.",
    ),
    row(
        "AxG",
        Shape::Array(Prefix::Dwrd, 3),
        NUMBERS,
        "NC axes that are the geometric axes.",
        "NC osy, které jsou geometrickými osami.",
    ),
    row("T", DWORD, NUMBERS, "Programmed value of T.", "Programovaná hodnota T."),
    row("H", REAL, REALS, "Programmed value of H.", "Programovaná hodnota H."),
    row(
        "RPlcParams",
        Shape::Array(Prefix::Real, PARAMETERS),
        REALS,
        "Real parameters for the PLC.",
        "Reálné parametry pro PLC.",
    ),
    row("Delay", REAL, REALS, "Programmed dwell.", "Programovaná prodleva."),
    row(
        "AxNC",
        Shape::Array(Prefix::Real, AXES),
        REALS,
        "Absolute positions of the NC axes in space POS0 in mm.",
        "Absolutní polohy NC os v prostoru POS0 v mm.",
    ),
    row(
        "BlockLen",
        REAL,
        REALS,
        "Length of the path in space POS0 in mm; times Scale it is the true one.",
        "Délka dráhy v prostoru POS0 v mm; skutečná je vynásobená Scale.",
    ),
    row(
        "Scale",
        REAL,
        REALS,
        "Scale of the block; valid when it is the same in all axes.",
        "Měřítko bloku; platí, je-li ve všech osách stejné.",
    ),
    row("FeedProgr", REAL, REALS, "Programmed feed in mm/min.", "Programovaný posuv v mm/min."),
    row("FeedMax", REAL, REALS, "Largest feed in mm/min.", "Největší posuv v mm/min."),
    row(
        "FeedCriterial",
        REAL,
        REALS,
        "Criterion feed at the beginning of the block.",
        "Kriteriální rychlost na začátku bloku.",
    ),
    row("ParabAccel", REAL, REALS, "Parabolic acceleration.", "Parabolické zrychlení."),
    row("LinearAccel", REAL, REALS, "Linear acceleration.", "Lineární zrychlení."),
    row("SpindleSpeed", REAL, REALS, "Spindle speed in rev/min.", "Otáčky vřetene v ot/min."),
    row(
        "SpindleSpeedLimit",
        REAL,
        REALS,
        "Largest spindle speed at constant cutting speed in rev/min.",
        "Nejvyšší otáčky při konstantní řezné rychlosti v ot/min.",
    ),
    row(
        "ConstCuttingSpeed",
        REAL,
        REALS,
        "Constant cutting speed in mm/min.",
        "Konstantní řezná rychlost v mm/min.",
    ),
];

/// Lists the members; gives the length of the record.
pub(super) fn list(symbols: &mut Vec<SystemSymbol>) -> u32 {
    let mut record = Space::of_structure();
    for family in FAMILIES {
        record.numbered(family, symbols);
    }
    record.rows(ROWS, symbols);
    record.end()
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use crate::catalogue::{SystemKind, SystemSymbol, block_member, block_members, block_record_len, symbol};

    #[test]
    fn a_block_has_its_change_bits_numbers_and_reals() {
        let bit = |name: &str| matches!(block_member(name).unwrap().kind, SystemKind::Bit { .. });
        for name in ["M0", "m14", "AxNC15Move", "IPlc4", "RPLC0", "FIRSTBLOCK", "TchlOff"] {
            assert!(bit(name), "{name}");
        }
        for (name, len) in [("M", 15), ("IPlcParams", 5), ("AxG", 3), ("RPlcParams", 5), ("AxNC", 16)] {
            let kind = block_member(name).unwrap().kind;
            assert!(matches!(kind, SystemKind::Array { len: found, .. } if found == len), "{name}: {kind:?}");
        }
        assert!(block_member("M15").is_none() && block_member("IPlc5").is_none());
        assert_eq!(block_members().count(), 15 + 16 + 5 + 5 + 32);
    }

    #[test]
    fn members_do_not_overlap_and_lie_in_the_record() {
        let mut bits = HashSet::new();
        for member in block_members() {
            let (addr, len) = match member.kind {
                SystemKind::Bit { addr, bit } => {
                    assert!(bits.insert((addr, bit)), "{}", member.name);
                    continue;
                }
                SystemKind::Cell { addr, prefix } => (addr, prefix.bytes()),
                SystemKind::Array { addr, element, len } => (addr, element.bytes() * len),
                other => panic!("{}: {other:?}", member.name),
            };
            for byte in addr..addr + len {
                assert!((0..8).all(|bit| bits.insert((byte, bit))), "{}", member.name);
            }
        }
        assert!(bits.iter().all(|(addr, _)| *addr < block_record_len()));
    }

    #[test]
    fn members_lie_where_the_target_writes_them() {
        use technol_image::system::{SUPERVISOR_END, block_record as record};
        let at = |name: &str| match block_member(name).unwrap().kind {
            SystemKind::Bit { addr, bit } => (addr, u32::from(bit)),
            SystemKind::Cell { addr, .. } | SystemKind::Array { addr, .. } => (addr, 0),
            other => panic!("{name}: {other:?}"),
        };
        for (name, offset) in [
            ("M0", record::M_CHANGED),
            ("AxNC0Move", record::AXES_MOVE),
            ("IPlc0", record::INTEGERS_CHANGED),
            ("RPlc0", record::REALS_CHANGED),
            ("M", record::M),
            ("IPlcParams", record::INTEGERS),
            ("AxG", record::GEOMETRIC_AXES),
            ("T", record::T),
            ("H", record::H),
            ("RPlcParams", record::REALS),
            ("Delay", record::DELAY),
            ("AxNC", record::AXES),
        ] {
            assert_eq!(at(name), (offset, 0), "{name}");
        }
        let flags = [
            "FirstBlock",
            "LastBlock",
            "Stop",
            "CondStop",
            "Backward",
            "SelBlock",
            "Cont",
            "TchlOff",
            "Partial",
            "HProg",
            "TProg",
            "RevFeed",
            "ContinuousMode",
            "ConstCutSpeed",
        ];
        for (n, name) in (record::FIRST_FLAG..).zip(flags) {
            assert_eq!(at(name), (record::REALS_CHANGED + n / 8, n % 8), "{name}");
        }
        let reals = [
            "BlockLen",
            "Scale",
            "FeedProgr",
            "FeedMax",
            "FeedCriterial",
            "ParabAccel",
            "LinearAccel",
            "SpindleSpeed",
            "SpindleSpeedLimit",
            "ConstCuttingSpeed",
        ];
        for (n, name) in (0..).zip(reals) {
            assert_eq!(at(name), (record::BLOCK_LEN + 8 * n, 0), "{name}");
        }
        assert_eq!(block_record_len(), record::LEN);
        let bits = |member: &&SystemSymbol| matches!(member.kind, SystemKind::Bit { .. });
        assert!(block_members().filter(bits).all(|member| at(member.name).0 < record::BITS_LEN));
        const { assert!(SUPERVISOR_END <= technol_image::system::LEN) };
    }

    #[test]
    fn the_status_lies_where_the_target_writes_it() {
        use technol_image::system;
        for (name, place) in [
            ("SF_RUN", system::SF_RUN),
            ("SF_BLOCKINPROGR", system::SF_BLOCKINPROGR),
            ("SF_BLOCKFINISHED", system::SF_BLOCKFINISHED),
            ("SF_STOP", system::SF_STOP),
            ("SF_NOTINPOS", system::SF_NOTINPOS),
            ("SF_DELAYINPROGR", system::SF_DELAYINPROGR),
            ("SF_CONDSTOPMODE", system::SF_CONDSTOPMODE),
            ("SF_BACKWARD", system::SF_BACKWARD),
            ("PRODLEVA", system::PRODLEVA),
            ("G23ACT", system::G23ACT),
        ] {
            let kind = symbol(name).unwrap().kind;
            assert_eq!(kind, SystemKind::Bit { addr: place.addr, bit: place.bit }, "{name}");
        }
        assert_eq!(symbol("TIME_DIST").unwrap().kind.bytes(), Some((system::TIME_DIST, 4)));
    }

    #[test]
    fn predefined_symbols_end_before_the_records_of_the_blocks() {
        use technol_image::system::BLOCK_RECORDS;
        let end = |symbol: &SystemSymbol| match symbol.kind {
            SystemKind::Bit { addr, .. } => addr + 1,
            kind => kind.bytes().map_or(0, |(addr, len)| addr + len),
        };
        let last = crate::catalogue::symbols().map(end).max().unwrap();
        assert!(last <= BLOCK_RECORDS, "{last:#x}");
    }

    #[test]
    fn names_of_members_stay_free_for_the_program() {
        for name in ["T", "H", "M", "M1", "STOP", "SCALE", "DELAY"] {
            assert!(symbol(name).is_none(), "{name}");
        }
    }
}
