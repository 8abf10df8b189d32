//! Gives one operation its final addresses.

use technol_image::assembler;
use technol_image::op::{Addr, BitRef, Op, Pc, Place, Source, Width};
use technol_image::program::{Message, RegionKind, Timed};
use technol_image::service::{Arg, ServiceCall};

use super::addresses::Addresses;
use super::section_code::{ClearRange, ProblemKind, SectionCode, Slot};
use crate::semantics::hir::SymbolKey;

/// Relocation of the operations of one section.
pub(super) struct Relocation<'a> {
    /// The section.
    pub(super) code: &'a SectionCode,
    /// Addresses of everything.
    pub(super) addresses: &'a Addresses<'a>,
    /// Place of each own operation, and of the end.
    pub(super) pcs: &'a [Pc],
    /// First automatic counter of the section.
    pub(super) counters: Addr,
    /// First hidden byte of the section.
    pub(super) states: Addr,
    /// Index of its first TEX or TIM.
    pub(super) timed: usize,
    /// Index of its first message.
    pub(super) messages: usize,
    /// Index of its first call of a service.
    pub(super) services: usize,
    /// Its sequence; 0 when it is none.
    pub(super) sequence: u16,
    /// File in execution order.
    pub(super) file: u8,
    /// 1-based source line of the operation at hand, saturated.
    pub(super) line: u16,
}

type Relocated = Result<(), ProblemKind>;

impl Relocation<'_> {
    /// Replaces the numbers in `op` by addresses.
    pub(super) fn op(&self, op: &mut Op) -> Relocated {
        match op {
            Op::Ldr { bit, .. } | Op::Logic { bit, .. } | Op::Write(bit) | Op::Flag { bit, .. } => {
                self.bit(bit)
            }
            Op::Edge { bit, state, .. } => {
                *state = self.own(*state)?;
                self.bit(bit)
            }
            Op::MoveBit { dst, src, .. } => {
                self.bit(dst)?;
                self.bit(src)
            }
            Op::Jump { target, .. } | Op::AssemblerJump { target, .. } | Op::Raster { end: target, .. } => {
                self.target(target);
                Ok(())
            }
            Op::Load { src, width, .. } | Op::Arith { src, width, .. } | Op::Compare { src, width, .. } => {
                self.source(src, *width)
            }
            Op::Shift { count, .. } => self.source(count, Width::Byte),
            Op::Store { dst, width, .. } => self.place(dst, width.bytes()),
            Op::Move { dst, src, width, .. } => {
                self.place(dst, width.bytes())?;
                self.place(src, width.bytes())
            }
            Op::Timer { count, width } => self.place(count, width.bytes()),
            Op::Counter { count, width, state, .. } => {
                *state = self.own(*state)?;
                self.place(count, width.bytes())
            }
            Op::Copy { src, dst, len } => {
                self.place(src, *len)?;
                self.place(dst, *len)
            }
            Op::Assembler { width, to, from, .. } => {
                for operand in [to, from] {
                    if let assembler::Operand::Cell(place) = operand {
                        self.place(place, width.bytes())?;
                    }
                }
                Ok(())
            }
            Op::Clear { addr, len } => self.clear(addr, len),
            Op::Call(index) => self.named(index, |key| self.addresses.procedure(key)),
            Op::SeqInit(index) => self.named(index, |key| self.addresses.mechanism(key)),
            Op::SeqBegin(sequence) | Op::SeqEnd(sequence) => {
                *sequence = self.sequence;
                Ok(())
            }
            Op::Ex { line, .. } | Op::ExIf { line, .. } | Op::Bex { line, .. } => {
                *line = self.line;
                Ok(())
            }
            Op::Timed(index) => table_index(index, self.timed, "TEX and TIM instructions"),
            Op::Message { index, .. } => table_index(index, self.messages, "messages"),
            Op::Service(index) => table_index(index, self.services, "instructions of the control"),
            Op::InitFinished(file) | Op::DoneFinished(file) => {
                *file = self.file;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Replaces the numbers in the parameters of a TEX or TIM.
    pub(super) fn timed(&self, timed: &mut Timed) -> Relocated {
        timed.line = self.line;
        self.place(&mut timed.count, timed.width.bytes())?;
        self.source(&mut timed.time, timed.width)?;
        if let Some(error) = &mut timed.error {
            self.target(error);
        }
        match &mut timed.code {
            Some((source, width)) => self.source(source, *width),
            None => Ok(()),
        }
    }

    /// Replaces the slots in the parameters of a message.
    pub(super) fn message(&self, message: &mut Message) -> Relocated {
        let values = [&mut message.number, &mut message.sub_id].into_iter().chain(&mut message.parameters);
        for (source, width) in values.flatten() {
            self.source(source, *width)?;
        }
        Ok(())
    }

    /// Replaces the slots in the operands of a call.
    pub(super) fn service(&self, call: &mut ServiceCall) -> Relocated {
        for arg in &mut call.args {
            match arg {
                Arg::Cell { place, width, .. } => self.place(place, width.bytes())?,
                Arg::Bit { bit, .. } => self.bit(bit)?,
                Arg::Area { place, len } => self.place(place, *len)?,
                Arg::Procedure(index) => self.named(index, |key| self.addresses.procedure(key))?,
                Arg::Missing | Arg::Int(_) | Arg::Real(_) | Arg::Text(_) | Arg::Keyword(_) => {}
            }
        }
        Ok(())
    }

    /// Replaces the slot in a value.
    fn source(&self, source: &mut Source, width: Width) -> Relocated {
        match source {
            Source::Mem(place) => self.place(place, width.bytes()),
            _ => Ok(()),
        }
    }

    /// Replaces the slot in a place; `len` bytes are accessed there.
    fn place(&self, place: &mut Place, len: u32) -> Relocated {
        let (addr, _) = self.address(place.addr, len, place.indexed)?;
        place.addr = addr;
        Ok(())
    }

    /// Replaces a number of an own operation.
    fn target(&self, target: &mut Pc) {
        let end = self.pcs.last().copied().unwrap_or(0);
        *target = self.pcs.get(*target as usize).copied().unwrap_or(end);
    }

    fn bit(&self, bit: &mut BitRef) -> Relocated {
        let (addr, number) = self.address(bit.addr, 1, bit.indexed)?;
        bit.addr = addr;
        bit.bit = number.unwrap_or(bit.bit);
        Ok(())
    }

    /// Address of a hidden byte or automatic counter.
    fn own(&self, slot: u32) -> Result<Addr, ProblemKind> {
        self.address(slot, 1, false).map(|(addr, _)| addr)
    }

    fn address(&self, slot: u32, len: u32, indexed: bool) -> Result<(Addr, Option<u8>), ProblemKind> {
        match self.code.slots.get(slot as usize) {
            Some(Slot::Counter(n)) => Ok((self.counters + n * 2, None)),
            Some(Slot::State(n)) => Ok((self.states + n, None)),
            Some(Slot::Fixed(addr)) => Ok((*addr, None)),
            Some(Slot::Symbol { key, offset }) => {
                let found = self.addresses.symbol(key);
                let found = found.ok_or_else(|| ProblemKind::NoAddress(key.name.to_string()))?;
                let outside = || ProblemKind::OutsideArea(describe(key, *offset));
                let start = i64::from(found.base).saturating_add(*offset);
                let addr = Addr::try_from(start).map_err(|_| outside())?;
                let region = self.addresses.region(found.base).ok_or_else(outside)?;
                let end = i64::from(region.start) + i64::from(region.len);
                let inside = start >= i64::from(region.start) && start.saturating_add(i64::from(len)) <= end;
                // What BX makes of an indexed address is known at run time only.
                if inside || indexed { Ok((addr, found.bit)) } else { Err(outside()) }
            }
            None => Err(ProblemKind::NoAddress("an operand".to_owned())),
        }
    }

    fn clear(&self, addr: &mut Addr, len: &mut u32) -> Relocated {
        let range = self.code.clears.get(*addr as usize).copied().ok_or(ProblemKind::Clear)?;
        let ClearRange::Span { begin, end, tail } = range else {
            let kind = if range == ClearRange::Global { RegionKind::Global } else { RegionKind::Local };
            let region = self.addresses.whole(kind).ok_or(ProblemKind::Clear)?;
            (*addr, *len) = (region.start, region.len);
            return Ok(());
        };
        let (begin, _) = self.address(begin, 1, false)?;
        let (end, _) = self.address(end, tail, false)?;
        let same = self.addresses.region(begin).map(|r| r.kind) == self.addresses.region(end).map(|r| r.kind);
        if !same || begin > end {
            return Err(ProblemKind::Clear);
        }
        (*addr, *len) = (begin, end - begin + tail);
        Ok(())
    }

    fn named(&self, index: &mut u16, find: impl Fn(&SymbolKey) -> Option<u16>) -> Relocated {
        let key = self.code.names.get(usize::from(*index));
        let found = key.and_then(&find);
        let missing = || ProblemKind::Misplaced(key.map_or_else(String::new, |k| k.name.to_string()));
        *index = found.ok_or_else(missing)?;
        Ok(())
    }
}

fn describe(key: &SymbolKey, offset: i64) -> String {
    if offset == 0 { key.name.to_string() } else { format!("{}{offset:+}", key.name) }
}

fn table_index(index: &mut u16, base: usize, what: &'static str) -> Relocated {
    let limit = usize::from(u16::MAX);
    *index = u16::try_from(base + usize::from(*index)).map_err(|_| ProblemKind::TableFull(what, limit))?;
    Ok(())
}
