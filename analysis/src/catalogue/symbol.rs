//! Predefined symbols: ports, their masks, the block interface, constants.

use std::collections::HashMap;
use std::sync::LazyLock;

use technol_image::op::Addr;

use super::entry::{Bilingual, Prefix};
use super::look_up;

mod axes;
mod block;
mod cutting;
mod defaults;
mod drives;
mod ethercat;
mod interface;
mod jog;
mod manual;
mod motion;
mod panels;
mod peripherals;
mod ports;
mod referencing;
mod registers;
mod serial;
mod space;
mod spindle;
mod state;
mod structures;
mod tables;

/// Who writes a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The control writes it, the program reads it.
    CncToPlc,
    /// The program writes it, the control reads it.
    PlcToCnc,
    /// Both write it.
    Both,
}

/// What a symbol is and where it lies in the system region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SystemKind {
    /// A bit.
    Bit {
        /// Its byte.
        addr: Addr,
        /// Its number, 0 to 7.
        bit: u8,
    },
    /// A bit position without a cell of its own, for `ADR.bit`.
    FormalBit {
        /// The position, 0 to 7.
        bit: u8,
    },
    /// A cell of the type a prefix names.
    Cell {
        /// Its first byte.
        addr: Addr,
        /// Its type: Byte, Word, Dwrd, Qwrd or Real.
        prefix: Prefix,
    },
    /// Cells of one type in a row; `name[n]` is the n-th.
    Array {
        /// First byte of element 0.
        addr: Addr,
        /// Type of an element.
        element: Prefix,
        /// Number of elements.
        len: u32,
    },
    /// Bytes without a type.
    Area {
        /// Its first byte.
        addr: Addr,
        /// Its length in bytes.
        len: u32,
    },
    /// A member of a structure: a typed offset from a base (`base.MEMBER`); it has no memory of its own.
    Member {
        /// Byte offset in the structure.
        offset: u32,
        /// Type of an element.
        element: Prefix,
        /// Number of elements; 1 for a plain member.
        len: u32,
    },
    /// An integer.
    Constant(i64),
}

impl SystemKind {
    /// First byte and length of its cells; `None` for bits and for what has no memory.
    #[must_use]
    pub const fn bytes(&self) -> Option<(Addr, u32)> {
        match *self {
            SystemKind::Cell { addr, prefix } => Some((addr, prefix.bytes())),
            SystemKind::Array { addr, element, len } => Some((addr, element.bytes() * len)),
            SystemKind::Area { addr, len } => Some((addr, len)),
            SystemKind::Bit { .. }
            | SystemKind::FormalBit { .. }
            | SystemKind::Member { .. }
            | SystemKind::Constant(_) => None,
        }
    }
}

/// A predefined symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SystemSymbol {
    /// Its name in upper case: the key of the symbol.
    pub name: &'static str,
    /// Its name as the manual spells it.
    pub spelling: &'static str,
    /// What it is.
    pub kind: SystemKind,
    /// Who writes it.
    pub direction: Direction,
    /// Its value at power-on where the manual tells one; `None` otherwise (memory then starts as 0).
    pub default: Option<i64>,
    /// What it means.
    pub summary: Bilingual,
    /// Manual chapter.
    pub chapter: &'static str,
}

struct Table {
    symbols: Vec<SystemSymbol>,
    by_name: HashMap<&'static str, usize>,
    /// First byte behind them.
    len: Addr,
}

impl Table {
    fn of(symbols: Vec<SystemSymbol>, len: Addr) -> Table {
        let by_name = symbols.iter().enumerate().map(|(index, symbol)| (symbol.name, index)).collect();
        Table { symbols, by_name, len }
    }
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut symbols = Vec::new();
    ports::list(&mut symbols);
    interface::list(&mut symbols);
    let mut space = space::Space::new();
    for family in axes::FAMILIES {
        space.axis_bits(family, &mut symbols);
    }
    for rows in [motion::ROWS, spindle::ROWS, jog::ROWS, peripherals::ROWS, state::ROWS] {
        space.rows(rows, &mut symbols);
    }
    for rows in [panels::ROWS, ethercat::ROWS, tables::ROWS, cutting::ROWS, serial::ROWS] {
        space.rows(rows, &mut symbols);
    }
    registers::list(&mut symbols);
    structures::list(&mut symbols);
    for family in manual::FAMILIES {
        space.axis_bits(family, &mut symbols);
    }
    for rows in [drives::ROWS, manual::ROWS, referencing::ROWS] {
        space.rows(rows, &mut symbols);
    }
    for family in drives::FAMILIES.iter().chain(referencing::FAMILIES).chain([&state::LICENCES]) {
        space.numbered(family, &mut symbols);
    }
    for symbol in &mut symbols {
        symbol.default = symbol.default.or_else(|| defaults::of(symbol.name));
    }
    Table::of(symbols, space.end())
});

static BLOCK: LazyLock<Table> = LazyLock::new(|| {
    let mut symbols = Vec::new();
    let len = block::list(&mut symbols);
    Table::of(symbols, len)
});

static UNIT: LazyLock<Table> = LazyLock::new(|| {
    let mut symbols = Vec::new();
    let len = structures::list_unit(&mut symbols);
    Table::of(symbols, len)
});

/// The predefined symbol `name`, in any case.
#[must_use]
pub fn symbol(name: &str) -> Option<&'static SystemSymbol> {
    if let Some((block, member)) = name.split_once('.') {
        return if block.eq_ignore_ascii_case("BLK") { block_member(member) } else { None };
    }
    look_up(&TABLE.by_name, name).map(|&index| &TABLE.symbols[index])
}

/// Whether the bytes behind the cell `name`, up to `end` from its beginning, belong to cells of its family: names
/// that begin with the same letters, as BZH09 and BZH10.
#[must_use]
pub fn goes_on(name: &str, end: i64) -> bool {
    let family = |name: &'static str| name.split(|c: char| c.is_ascii_digit()).next().unwrap_or(name);
    let Some(own) = symbol(name) else { return false };
    let Some((start, len)) = own.kind.bytes() else { return false };
    (i64::from(len)..end).all(|at| {
        let at = i64::from(start) + at;
        symbols().filter(|other| family(other.name) == family(own.name)).any(|other| {
            other.kind.bytes().is_some_and(|(start, len)| {
                (i64::from(start)..i64::from(start) + i64::from(len)).contains(&at)
            })
        })
    })
}

/// Every predefined symbol, in the order of the manual.
pub fn symbols() -> impl Iterator<Item = &'static SystemSymbol> {
    TABLE.symbols.iter()
}

/// The member `name` of a prepared block, `BLK[n].name`, in any case. Members have names of their own, so that
/// a program may call its cells `T` or `M1`; the address in their kind is the offset in the block's record.
#[must_use]
pub fn block_member(name: &str) -> Option<&'static SystemSymbol> {
    look_up(&BLOCK.by_name, name).map(|&index| &BLOCK.symbols[index])
}

/// Every member of a prepared block, in the order of the manual.
pub fn block_members() -> impl Iterator<Item = &'static SystemSymbol> {
    BLOCK.symbols.iter()
}

/// Length of the record of a prepared block in bytes.
#[must_use]
pub fn block_record_len() -> u32 {
    BLOCK.len
}

/// The member `name` of INOUTS, the state of a CAN-BUS unit, in any case: an operand of CAN_SYSIO_READ and
/// CAN_SYSIO_WRITE. Members have names of their own, so that a program may call its cells `COUNT` or `ERROR`.
#[must_use]
pub fn unit_member(name: &str) -> Option<&'static SystemSymbol> {
    look_up(&UNIT.by_name, name).map(|&index| &UNIT.symbols[index])
}

/// Every member of INOUTS, in the order of their offsets.
pub fn unit_members() -> impl Iterator<Item = &'static SystemSymbol> {
    UNIT.symbols.iter()
}

/// A text that a family of symbols generates; the table is built once and lives as long as the process.
fn generated(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}
