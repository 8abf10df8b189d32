//! Allocates the predefined symbols that have no fixed place: in the order of the tables, from
//! [`system::FREE`] on, so that the same catalogue always gives the same addresses.

use technol_image::op::Addr;
use technol_image::system;

use super::{Direction, SystemKind, SystemSymbol, generated};
use crate::catalogue::entry::{Bilingual, Prefix};

/// What a row of a table asks for.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    /// A bit; bits in a row share bytes.
    Bit,
    /// A cell of this type.
    Cell(Prefix),
    /// A number of cells of this type.
    Array(Prefix, u32),
    /// A number of bytes.
    Area(u32),
    /// Another name of the symbol of the row before.
    Alias,
    /// A bit of the BYTE in the row before that is a `Cell`.
    BitOf(u8),
    /// A position without a cell.
    Formal(u8),
    /// A member of a structure: offset in bytes, type and number of its elements. It takes no memory; what has
    /// the structure is an `Area`.
    Member(u32, Prefix, u32),
    /// A number.
    Constant(i64),
    /// Another name of bytes of the array that came last: offset in bytes and type.
    Within(u32, Prefix),
}

pub(super) const BYTE: Shape = Shape::Cell(Prefix::Byte);
pub(super) const WORD: Shape = Shape::Cell(Prefix::Word);
pub(super) const DWORD: Shape = Shape::Cell(Prefix::Dwrd);
pub(super) const REAL: Shape = Shape::Cell(Prefix::Real);

/// A symbol: name as the manual spells it, what it is, who writes it, chapter, meaning.
pub(super) type Row = (&'static str, Shape, Direction, &'static str, Bilingual);

/// One bit for every axis, X, Y, Z, 4 … `axes`.
pub(super) struct AxisBits {
    /// What stands before the axis in the name.
    pub(super) before: &'static str,
    /// What stands after it.
    pub(super) after: &'static str,
    /// Number of axes.
    pub(super) axes: u32,
    /// The BYTE that holds the first six axes and the WORD that holds the others, when they have names.
    pub(super) cells: (Option<&'static str>, Option<&'static str>),
    /// Who writes them.
    pub(super) direction: Direction,
    /// Manual chapter.
    pub(super) chapter: &'static str,
    /// Value of every bit at power-on, where the manual tells it.
    pub(super) default: Option<bool>,
    /// What the bit means; the axis is added.
    pub(super) summary: Bilingual,
}

/// Symbols `before0after`, `before1after` … of one kind, one behind the other.
pub(super) struct Numbered {
    /// What stands before the number in the name.
    pub(super) before: &'static str,
    /// What stands after it.
    pub(super) after: &'static str,
    /// The first number.
    pub(super) first: u32,
    /// How many there are.
    pub(super) count: u32,
    /// `Bit`, `Cell`, or `Constant` with the value of the first.
    pub(super) shape: Shape,
    /// Who writes them.
    pub(super) direction: Direction,
    /// Manual chapter.
    pub(super) chapter: &'static str,
    /// What stands before the number in the meaning.
    pub(super) summary: Bilingual,
}

/// Axes whose bits lie in the first byte.
const FIRST_AXES: u32 = 6;

/// The part of the system region not yet given away.
pub(super) struct Space {
    next: Addr,
    /// The byte of the last bit and the number of the next one.
    open: Option<(Addr, u8)>,
}

impl Space {
    pub(super) const fn new() -> Space {
        Space { next: system::FREE, open: None }
    }

    /// Offsets in a structure instead of addresses.
    pub(super) const fn of_structure() -> Space {
        Space { next: 0, open: None }
    }

    /// The first byte not given away.
    pub(super) const fn end(&self) -> Addr {
        self.next
    }

    /// Places the rows in order.
    pub(super) fn rows(&mut self, rows: &'static [Row], symbols: &mut Vec<SystemSymbol>) {
        let mut last = SystemKind::Constant(0);
        let mut cell = system::FREE;
        let mut array = system::FREE;
        for &(spelling, shape, direction, chapter, summary) in rows {
            let kind = match shape {
                Shape::Bit => self.bit(),
                Shape::Cell(prefix) => SystemKind::Cell { addr: self.bytes(prefix.bytes()), prefix },
                Shape::Array(element, len) => {
                    SystemKind::Array { addr: self.bytes(element.bytes() * len), element, len }
                }
                Shape::Area(len) => SystemKind::Area { addr: self.bytes(len), len },
                Shape::Alias => last,
                Shape::BitOf(bit) => SystemKind::Bit { addr: cell, bit },
                Shape::Formal(bit) => SystemKind::FormalBit { bit },
                Shape::Member(offset, element, len) => SystemKind::Member { offset, element, len },
                Shape::Constant(value) => SystemKind::Constant(value),
                Shape::Within(offset, prefix) => SystemKind::Cell { addr: array + offset, prefix },
            };
            if let SystemKind::Array { addr, .. } = kind {
                array = addr;
            }
            if let SystemKind::Cell { addr, .. } = kind {
                cell = addr;
            }
            last = kind;
            symbols.push(symbol(spelling, kind, direction, chapter, summary));
        }
    }

    /// Places one bit for every axis.
    pub(super) fn axis_bits(&mut self, family: &AxisBits, symbols: &mut Vec<SystemSymbol>) {
        let first = self.bytes(1);
        let others = if family.axes > FIRST_AXES { self.bytes(2) } else { first };
        let container = |name: Option<&'static str>, prefix, addr, en: &str, cs: &str| {
            name.map(|name| {
                let summary = Bilingual {
                    en: generated(format!("{}: {en}.", family.summary.en)),
                    cs: generated(format!("{}: {cs}.", family.summary.cs)),
                };
                symbol(name, SystemKind::Cell { addr, prefix }, family.direction, family.chapter, summary)
            })
        };
        let (first_name, others_name) = family.cells;
        symbols.extend(container(first_name, Prefix::Byte, first, "first six axes", "prvních šest os"));
        symbols.extend(container(others_name, Prefix::Word, others, "the other axes", "další osy"));
        for index in 0..family.axes {
            let (base, place) =
                if index < FIRST_AXES { (first, index) } else { (others, index - FIRST_AXES) };
            let axis = axis_name(index);
            let bit = symbol(
                generated(format!("{}{axis}{}", family.before, family.after)),
                SystemKind::Bit { addr: base + place / 8, bit: (place % 8) as u8 },
                family.direction,
                family.chapter,
                Bilingual {
                    en: generated(format!("{}: axis {axis}.", family.summary.en)),
                    cs: generated(format!("{}: osa {axis}.", family.summary.cs)),
                },
            );
            symbols.push(SystemSymbol { default: family.default.map(i64::from), ..bit });
        }
    }

    /// Places the symbols of a numbered family.
    pub(super) fn numbered(&mut self, family: &Numbered, symbols: &mut Vec<SystemSymbol>) {
        self.open = None;
        for number in family.first..family.first + family.count {
            let kind = match family.shape {
                Shape::Cell(prefix) => SystemKind::Cell { addr: self.bytes(prefix.bytes()), prefix },
                Shape::Constant(value) => SystemKind::Constant(value + i64::from(number - family.first)),
                _ => self.bit(),
            };
            symbols.push(symbol(
                generated(format!("{}{number}{}", family.before, family.after)),
                kind,
                family.direction,
                family.chapter,
                Bilingual {
                    en: generated(format!("{} {number}.", family.summary.en)),
                    cs: generated(format!("{} {number}.", family.summary.cs)),
                },
            ));
        }
    }

    fn bytes(&mut self, len: u32) -> Addr {
        self.open = None;
        let addr = self.next;
        self.next += len;
        addr
    }

    fn bit(&mut self) -> SystemKind {
        let (addr, bit) = match self.open {
            Some((addr, bit)) if bit < 8 => (addr, bit),
            _ => (self.bytes(1), 0),
        };
        self.open = Some((addr, bit + 1));
        SystemKind::Bit { addr, bit }
    }
}

/// A symbol with its key made from the spelling.
pub(super) fn symbol(
    spelling: &'static str,
    kind: SystemKind,
    direction: Direction,
    chapter: &'static str,
    summary: Bilingual,
) -> SystemSymbol {
    let name = if spelling.bytes().any(|byte| byte.is_ascii_lowercase()) {
        generated(spelling.to_ascii_uppercase())
    } else {
        spelling
    };
    SystemSymbol { name, spelling, kind, direction, default: None, summary, chapter }
}

/// X, Y, Z, then the number of the axis.
pub(super) fn axis_name(index: u32) -> String {
    match index {
        0 => "X".to_owned(),
        1 => "Y".to_owned(),
        2 => "Z".to_owned(),
        other => (other + 1).to_string(),
    }
}
