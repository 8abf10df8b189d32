//! Fused data operations: up to three on plain cells of at most 32 bits, done together. They fetch their operands without
//! a branch: a cell is four bytes of which some are cut off, a constant is a cell that nothing is taken from.

use technol_image::op::{Arith, Compare, Cond, Logic, Op, Place, Source, Width};

use crate::equation::{BitWrite, combine};
use crate::fused::{Kind, Witness};
use crate::memory::Window;
use crate::registers::Registers;

/// Bytes that a cell is read in, whatever its width.
const READ: usize = 4;

/// How a calculation takes DR and its operand together; -1 is yes and 0 no.
///
/// `DR + x` is `(DR ^ x) + 2 * (DR & x)`, and with other factors the same sum is each of the logic functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Function {
    /// The operand is taken with the other sign.
    negates: i8,
    /// Bits that differ count.
    different: i8,
    /// How often bits that both have count.
    common: i8,
    /// It is their product instead, in all bits of DR.
    product: i8,
}

impl Function {
    const ADD: Function = Function { negates: 0, different: -1, common: 2, product: 0 };
    const SUBTRACT: Function = Function { negates: -1, ..Function::ADD };
    const AND: Function = Function { negates: 0, different: 0, common: 1, product: 0 };
    const OR: Function = Function { negates: 0, different: -1, common: 1, product: 0 };
    const XOR: Function = Function { negates: 0, different: -1, common: 0, product: 0 };
    const MULTIPLY: Function = Function { negates: 0, different: 0, common: 0, product: -1 };
}

/// A cell or a constant.
#[derive(Clone, Copy, Debug)]
struct Operand {
    /// The constant; 0 for a cell.
    value: i64,
    at: u16,
    /// Bits by which it is less than 32 bits wide.
    shift: u8,
    /// -1 for a cell, 0 for a constant.
    cell: i8,
}

impl Operand {
    const NONE: Operand = Operand { value: 0, at: 0, shift: 0, cell: 0 };

    /// `None` for what has to be done the long way: indexed, longer than 32 bits, real, out of the window.
    fn new(source: &Source, width: Width) -> Option<Operand> {
        let shift = match width {
            Width::Byte | Width::Word | Width::DWord => 32 - width.bits() as u8,
            Width::QWord | Width::Real => return None,
        };
        match *source {
            Source::Mem(Place { indexed: true, .. }) => None,
            Source::Mem(Place { addr, .. }) => {
                let at = u16::try_from(addr).ok()?;
                Some(Operand { value: 0, at, shift, cell: -1 })
            }
            Source::Int(value) => Some(Operand { value, at: 0, shift, cell: 0 }),
            Source::Real(_) => None,
        }
    }

    /// This and that function do something to DR.
    fn calculates(&self, function: Function) -> bool {
        function != Function::ADD || self.cell != 0 || self.value != 0
    }

    /// Sign-extended.
    #[inline]
    fn get(&self, memory: &Window) -> i64 {
        signed(read(memory, self.at), self.shift) & i64::from(self.cell) | self.value
    }
}

/// Of a term that is no equation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Data {
    load: Operand,
    operand: Operand,
    write: BitWrite,
    /// Where DR, or what is moved, goes; for either RLO: which bits of it.
    to: u16,
    stored: [u32; 2],
    /// What a calculation does; the bits of DR that it changes.
    function: Function,
    changes: i64,
    /// Of a comparison or of what is taken from the equation stack, see [`Kind`].
    select: u8,
    /// -1: DR is kept; 0: `load` is put there first.
    keep: i8,
}

/// A term that may still become part of a longer one.
#[derive(Clone, Copy, Debug)]
struct Draft {
    kind: Kind,
    operations: u8,
    /// It begins with LOD.
    loads: bool,
    data: Data,
}

impl Draft {
    fn new(kind: Kind) -> Draft {
        let data = Data {
            load: Operand::NONE,
            operand: Operand::NONE,
            write: BitWrite::none(0),
            to: 0,
            stored: [0; 2],
            function: Function::ADD,
            changes: 0,
            select: 0,
            keep: -1,
        };
        Draft { kind, operations: 1, loads: false, data }
    }

    /// With something else in its data.
    fn with(mut self, change: impl FnOnce(&mut Data)) -> Draft {
        change(&mut self.data);
        self
    }

    /// Of one data operation.
    fn of(op: &Op) -> Option<Draft> {
        let with = |kind, source: &Source, width| {
            let operand = Operand::new(source, width)?;
            Some(Draft::new(kind).with(|data| data.operand = operand))
        };
        match op {
            Op::Load { src, width, neg: false } => {
                let load = Operand::new(src, *width)?;
                let draft = Draft { loads: true, ..Draft::new(Kind::CALCULATE) };
                Some(draft.with(|data| data.load = load))
            }
            Op::Arith { op, src, width } => {
                let function = match op {
                    Arith::Add => Function::ADD,
                    Arith::Sub => Function::SUBTRACT,
                    Arith::And => Function::AND,
                    Arith::Xor => Function::XOR,
                    Arith::Or => Function::OR,
                    Arith::Mul => Function::MULTIPLY,
                    Arith::Div => return None,
                };
                let draft = with(Kind::CALCULATE, src, *width)?;
                Some(draft.with(|data| data.calculates(function)))
            }
            Op::Compare { op, src, width, if_rlo } => {
                let relation = match op {
                    Compare::Eq => 0b010,
                    Compare::Lt => 0b001,
                    Compare::Gt => 0b100,
                    Compare::Le => 0b011,
                    Compare::Ge => 0b110,
                };
                let select = relation | u8::from(*if_rlo) << 7;
                Some(with(Kind::COMPARE, src, *width)?.with(|data| data.select = select))
            }
            Op::Store { dst, width, cond } => {
                let to = Operand::new(&Source::Mem(*dst), *width)?;
                Some(Draft::new(Kind::CALCULATE).with(|data| data.goes(to, *cond)))
            }
            Op::Move { dst, src, width, cond } => {
                let from = with(Kind::MOVE, &Source::Mem(*src), *width)?;
                let to = Operand::new(&Source::Mem(*dst), *width)?;
                Some(from.with(|data| data.goes(to, *cond)))
            }
            Op::LogicPop(op) => Some(Draft::new(Kind::POP).with(|data| data.select = *op as u8)),
            _ => BitWrite::of(op).map(|write| Draft::new(Kind::WRITE).with(|data| data.write = write)),
        }
    }

    /// Both in one, if that is possible.
    fn joined(self, next: Draft) -> Option<Draft> {
        let operations = self.operations + next.operations;
        let (mine, its) = (&self.data, &next.data);
        let (stores, calculates) = (mine.stores(), mine.operand.calculates(mine.function));
        match (self.kind, next.kind) {
            // LOD, then what does not begin with one.
            (Kind::CALCULATE, Kind::CALCULATE | Kind::COMPARE) if !stores && !calculates && !next.loads => {
                let joined = Draft { operations, loads: self.loads, ..next };
                Some(joined.with(|data| data.load = mine.load))
            }
            // A calculation, then STO alone.
            (Kind::CALCULATE, Kind::CALCULATE)
                if !stores && !next.loads && !its.operand.calculates(its.function) =>
            {
                let joined = Draft { operations, ..self };
                Some(joined.with(|data| (data.to, data.stored) = (its.to, its.stored)))
            }
            (Kind::COMPARE, Kind::WRITE) if !mine.write.is_one() => {
                let joined = Draft { operations, ..self };
                Some(joined.with(|data| data.write = its.write))
            }
            _ => None,
        }
    }

    /// What it will execute. A store or a write that is missing is one that changes nothing, at a place that is looked
    /// at anyway: at another one the next term would have to wait for it.
    fn finished(self) -> Data {
        let spare = if self.data.load.cell != 0 { self.data.load.at } else { self.data.operand.at };
        let mut data = self.data;
        data.keep = if self.loads { 0 } else { -1 };
        if !data.stores() {
            data.to = spare;
        }
        if self.kind == Kind::COMPARE && !data.write.is_one() {
            data.write = BitWrite::none(spare);
        }
        data
    }
}

/// Bit 0: acts when RLO is 0; bit 1: when it is 1.
pub(crate) fn acts(cond: Cond) -> u8 {
    match cond {
        Cond::Always => 0b11,
        Cond::IfRlo => 0b10,
        Cond::IfNotRlo => 0b01,
    }
}

/// The low bits of a width.
#[inline]
fn mask(shift: u8) -> u32 {
    u32::MAX >> (shift & 31)
}

/// The low bits of `value` as a signed number.
#[inline]
fn signed(value: u32, shift: u8) -> i64 {
    i64::from(((value << (shift & 31)) as i32) >> (shift & 31))
}

#[inline]
fn read(memory: &Window, at: u16) -> u32 {
    let at = usize::from(at);
    u32::from_le_bytes([memory[at], memory[at + 1], memory[at + 2], memory[at + 3]])
}

/// Writes the bits of `mask`.
#[inline]
fn write(memory: &mut Window, at: u16, mask: u32, value: u32) {
    let old = read(memory, at);
    let new = old ^ (old ^ value) & mask;
    let at = usize::from(at);
    memory[at..at + READ].copy_from_slice(&new.to_le_bytes());
}

/// What a term works on.
pub(crate) struct Machine<'a, W> {
    pub(crate) memory: &'a mut Window,
    pub(crate) regs: &'a mut Registers,
    pub(crate) witness: &'a mut W,
}

impl Data {
    /// The data operations that these begin with, as many as one term takes, and how many they are.
    pub(crate) fn of(ops: &[Op]) -> Option<(Kind, Data, u8)> {
        let mut drafts = ops.iter().map_while(Draft::of);
        let mut draft = drafts.next()?;
        while let Some(both) = drafts.next().and_then(|next| draft.joined(next)) {
            draft = both;
        }
        Some((draft.kind, draft.finished(), draft.operations))
    }

    fn goes(&mut self, to: Operand, cond: Cond) {
        self.to = to.at;
        self.stored = [0, 1].map(|rlo| if acts(cond) >> rlo & 1 != 0 { mask(to.shift) } else { 0 });
    }

    fn stores(&self) -> bool {
        self.stored != [0; 2]
    }

    fn calculates(&mut self, function: Function) {
        self.function = function;
        // Only those bits count, and a product is one of signed numbers.
        self.operand.value = signed(self.operand.value as u32, self.operand.shift);
        self.changes = i64::from(mask(self.operand.shift)) | i64::from(function.product);
    }

    /// RLO and DR afterwards.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "RLO and DR stay in registers; measured in benches/against_c")]
    pub(crate) fn execute<W: Witness>(
        &self,
        kind: Kind,
        mut on: Machine<'_, W>,
        rlo: bool,
        dr: i64,
    ) -> (bool, i64) {
        if kind.is(Kind::CALCULATE) {
            (rlo, self.calculate(&mut on, rlo, dr))
        } else if kind.is(Kind::COMPARE) {
            self.compare(&mut on, rlo, dr)
        } else {
            on.witness.term(rlo, 0, dr, 0, on.regs);
            let mut rlo = rlo;
            if kind.is(Kind::WRITE) {
                self.write.execute(on.memory, rlo);
            } else if kind.is(Kind::MOVE) {
                let value = read(on.memory, self.operand.at);
                write(on.memory, self.to, self.stored[usize::from(rlo)], value);
            } else {
                let value = on.regs.stack & 1;
                on.regs.stack >>= 1;
                on.regs.depth -= 1;
                let logic = [Logic::And, Logic::Or, Logic::Xor][usize::from(self.select)];
                rlo = combine(logic, rlo, value != 0);
            }
            (rlo, dr)
        }
    }

    /// DR afterwards.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "as `execute`")]
    fn calculate<W: Witness>(&self, on: &mut Machine<'_, W>, rlo: bool, dr: i64) -> i64 {
        let (function, shift) = (&self.function, self.operand.shift);
        let dr = dr & i64::from(self.keep) | self.load.get(on.memory);
        let x = self.operand.get(on.memory);
        on.witness.term(rlo, 0, dr, x, on.regs);
        let product = signed(dr as u32, shift).wrapping_mul(x);
        let negates = i64::from(function.negates);
        let x = (x ^ negates).wrapping_sub(negates);
        let common = (dr & x).wrapping_mul(i64::from(function.common));
        let sum = ((dr ^ x) & i64::from(function.different)).wrapping_add(common);
        let result = sum | product & i64::from(function.product);
        let dr = dr ^ (dr ^ result) & self.changes;
        write(on.memory, self.to, self.stored[usize::from(rlo)], dr as u32);
        dr
    }

    /// RLO and DR afterwards.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "as `execute`")]
    fn compare<W: Witness>(&self, on: &mut Machine<'_, W>, rlo: bool, dr: i64) -> (bool, i64) {
        let dr = dr & i64::from(self.keep) | self.load.get(on.memory);
        let (a, b) = (signed(dr as u32, self.operand.shift), self.operand.get(on.memory));
        on.witness.term(rlo, 0, dr, b, on.regs);
        let place = u8::from(a >= b) + u8::from(a > b);
        // Without branches.
        let rlo = self.select >> place & (u8::from(rlo) | !self.select >> 7) & 1 != 0;
        self.write.execute(on.memory, rlo);
        (rlo, dr)
    }
}
