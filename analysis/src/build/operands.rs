//! Operands of the meaning turned into operands of operations; addresses become slots.

use technol_image::op::{Addr, BitRef, Op, Place, Source, Width};
use technol_image::service::Arg;
use technol_image::system;

use super::section_code::{SectionCode, Slot};
use crate::catalogue;
use crate::semantics::hir::{Address, BlockNumber, Operand, SymbolKey, SymbolScope};
use crate::semantics::layout::system_addr;

impl SectionCode {
    fn slot(&mut self, slot: Slot) -> u32 {
        self.slots.push(slot);
        (self.slots.len() - 1) as u32
    }

    pub(super) fn address(&mut self, address: &Address) -> Place {
        let slot = Slot::Symbol { key: address.symbol.clone(), offset: address.offset };
        Place { addr: self.slot(slot), indexed: address.indexed }
    }

    /// A new hidden state byte.
    pub(super) fn state(&mut self) -> u32 {
        let slot = self.slot(Slot::State(self.states));
        self.states += 1;
        slot
    }

    /// A new automatic counter.
    fn counter(&mut self) -> Place {
        let addr = self.slot(Slot::Counter(self.counters));
        self.counters += 1;
        Place { addr, indexed: false }
    }

    /// The number of a procedure or mechanism among the names of the section.
    pub(super) fn name(&mut self, key: &SymbolKey) -> usize {
        self.names.iter().position(|known| known == key).unwrap_or_else(|| {
            self.names.push(key.clone());
            self.names.len() - 1
        })
    }

    /// A bit and whether it is negated. A mechanism stands for its activation bit; its number comes with the layout.
    pub(super) fn bit(&mut self, operand: Option<&Operand>) -> Option<(BitRef, bool)> {
        match operand? {
            Operand::Bit { address, bit, negated } => {
                let place = self.address(address);
                Some((BitRef { addr: place.addr, bit: *bit, indexed: place.indexed }, *negated))
            }
            Operand::Mechanism(key) => {
                let addr = self.slot(Slot::Symbol { key: key.clone(), offset: 0 });
                Some((BitRef { addr, bit: 0, indexed: false }, false))
            }
            Operand::Block { number, member } => {
                let Operand::Bit { address, bit, negated } = &**member else { return None };
                let addr = self.slot(Slot::Fixed(in_block(*number, address)?));
                Some((BitRef { addr, bit: *bit, indexed: false }, *negated))
            }
            _ => None,
        }
    }

    /// A bit that cannot be negated.
    pub(super) fn plain_bit(&mut self, operand: Option<&Operand>) -> Option<BitRef> {
        self.bit(operand).filter(|(_, negated)| !negated).map(|(bit, _)| bit)
    }

    /// A cell with its width and whether its value is negated.
    pub(super) fn cell(&mut self, operand: Option<&Operand>) -> Option<(Place, Width, bool)> {
        match operand? {
            Operand::Cell { address, width, negated } => Some((self.address(address), *width, *negated)),
            Operand::Block { number, member } => {
                let Operand::Cell { address, width, negated } = &**member else { return None };
                let addr = self.slot(Slot::Fixed(in_block(*number, address)?));
                Some((Place { addr, indexed: false }, *width, *negated))
            }
            _ => None,
        }
    }

    /// A cell whose value is not negated.
    pub(super) fn plain_cell(&mut self, operand: Option<&Operand>) -> Option<(Place, Width)> {
        self.cell(operand).filter(|(.., negated)| !negated).map(|(place, width, _)| (place, width))
    }

    /// A value: a cell or a constant.
    pub(super) fn value(&mut self, operand: Option<&Operand>) -> Option<(Source, Width, bool)> {
        match operand? {
            Operand::Integer { value, width } => Some((Source::Int(*value), *width, false)),
            Operand::Real(value) => Some((Source::Real(*value), Width::Real, false)),
            cell => self.cell(Some(cell)).map(|(place, width, negated)| (Source::Mem(place), width, negated)),
        }
    }

    /// A value that is not negated.
    pub(super) fn plain_value(&mut self, operand: Option<&Operand>) -> Option<(Source, Width)> {
        self.value(operand).filter(|(.., negated)| !negated).map(|(source, width, _)| (source, width))
    }

    /// A counter of TM, TEX or TIM; `None` as width for an automatic one, which is a WORD.
    pub(super) fn counter_or_automatic(
        &mut self,
        operand: Option<&Operand>,
    ) -> Option<(Place, Option<Width>)> {
        match operand {
            None | Some(Operand::Skipped) => Some((self.counter(), None)),
            cell => self.plain_cell(cell).map(|(place, width)| (place, Some(width))),
        }
    }

    /// An address without access width and the length of what is declared there.
    pub(super) fn area(&mut self, operand: Option<&Operand>) -> Option<(Place, i64, u32)> {
        match operand? {
            Operand::Area { address, len } => Some((self.address(address), address.offset, *len)),
            Operand::Cell { address, width, negated: false } => {
                Some((self.address(address), address.offset, width.bytes()))
            }
            Operand::Bit { address, negated: false, .. } => Some((self.address(address), address.offset, 1)),
            _ => None,
        }
    }

    /// A predefined area that an instruction works on without an operand.
    pub(super) fn predefined(&mut self, name: &str, len: u32) -> Arg {
        let symbol = SymbolKey { scope: SymbolScope::System, name: name.into() };
        let addr = self.slot(Slot::Symbol { key: symbol, offset: 0 });
        Arg::Area { place: Place { addr, indexed: false }, len }
    }

    /// An operand of a service.
    pub(super) fn arg(&mut self, operand: Option<&Operand>) -> Option<Arg> {
        Some(match operand? {
            Operand::Skipped => Arg::Missing,
            Operand::Integer { value, .. } => Arg::Int(*value),
            Operand::Real(value) => Arg::Real(*value),
            Operand::Text(text) => Arg::Text(crate::semantics::collect::text_bytes(text)),
            Operand::Keyword(word) => Arg::Keyword((*word).to_owned()),
            Operand::Cell { address, width, negated } => {
                Arg::Cell { place: self.address(address), width: *width, neg: *negated }
            }
            Operand::Bit { .. } | Operand::Mechanism(_) => {
                let (bit, neg) = self.bit(operand)?;
                Arg::Bit { bit, neg }
            }
            Operand::Area { address, len } => {
                let behind = i64::from(*len) - address.offset;
                Arg::Area { place: self.address(address), len: u32::try_from(behind).unwrap_or(0) }
            }
            Operand::Procedure(key) => Arg::Procedure(u16::try_from(self.name(key)).ok()?),
            Operand::Label(_) | Operand::Block { .. } => return None,
        })
    }
}

/// Offset of a member in the record of a block.
fn offset_in_block(address: &Address) -> Option<u32> {
    let start = system_addr(&catalogue::symbol(&address.symbol.name)?.kind)?;
    u32::try_from(i64::from(start) + address.offset).ok()
}

/// Where a member of a prepared block is read. One whose number is in BX is brought there before.
fn in_block(number: BlockNumber, address: &Address) -> Option<Addr> {
    let offset = offset_in_block(address)?;
    Some(match number {
        BlockNumber::Indexed => system::BLOCK_WINDOW,
        BlockNumber::Fixed(n) if n < system::BLOCK_RECORD_COUNT => {
            system::BLOCK_RECORDS + n * system::block_record::LEN + offset
        }
        BlockNumber::Fixed(_) => system::NO_BLOCK,
    })
}

/// The operation that brings a member of the block whose number is in BX; `None` for other operands.
pub(super) fn block_selection(operand: &Operand) -> Option<Op> {
    let Operand::Block { number: BlockNumber::Indexed, member } = operand else { return None };
    let (address, len) = match &**member {
        Operand::Bit { address, .. } => (address, 1),
        Operand::Cell { address, width, .. } => (address, width.bytes()),
        _ => return None,
    };
    Some(Op::SelectBlock { offset: offset_in_block(address)?.try_into().ok()?, len: len as u8 })
}

/// The width a keyword operand asks for; `default` without one.
pub(super) fn keyword_width(operand: Option<&Operand>, default: Width) -> Option<Width> {
    match operand {
        None | Some(Operand::Skipped) => Some(default),
        Some(Operand::Keyword("BYTE")) => Some(Width::Byte),
        Some(Operand::Keyword("WORD")) => Some(Width::Word),
        Some(Operand::Keyword("DWRD")) => Some(Width::DWord),
        Some(Operand::Keyword("QWRD")) => Some(Width::QWord),
        Some(Operand::Keyword("REAL")) => Some(Width::Real),
        Some(_) => None,
    }
}
