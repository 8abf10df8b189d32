//! Programs as PLC programmers write them, in stretches, from a fixed sequence of numbers.

use crate::support::{Builder, GLOBAL, bit, cell, mem};
use technol_image::op::{Addr, Arith, Compare, Cond, Logic, Op, Source, Width};

/// Input ports that change from cycle to cycle.
pub(crate) const PORTS: usize = 16;
/// Bytes of bit cells at [`GLOBAL`].
const BITS: u32 = 0x80;
/// Data cells behind them, 8 bytes each.
const CELLS: u32 = 32;

/// Shares of what is in a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    /// Percent of the stretches that work on data.
    pub(crate) data_percent: u64,
}

/// An operation, or a jump over the ones that follow.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Item {
    Op(Op),
    /// JL1 over so many items.
    Over(usize),
}

/// xorshift64*.
fn next(seed: &mut u64) -> u64 {
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    seed.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32
}

/// Inputs of the next cycle: a bit or two change, as they do at a machine. The C program does the same.
pub(crate) fn next_inputs(seed: &mut u64, inputs: &mut [u8]) {
    for _ in 0..2 {
        let number = next(seed);
        inputs[(number & 15) as usize] ^= 1 << (number >> 4 & 7);
    }
}

struct Writer {
    seed: u64,
    items: Vec<Item>,
}

impl Writer {
    fn below(&mut self, bound: u64) -> u64 {
        next(&mut self.seed) % bound
    }

    fn push(&mut self, op: Op) {
        self.items.push(Item::Op(op));
    }

    /// An input or a bit cell.
    fn any_bit(&mut self) -> technol_image::BitRef {
        let n = self.below(8) as u8;
        let addr = if self.below(4) == 0 {
            technol_image::system::IN_PORTS + self.below(PORTS as u64) as Addr
        } else {
            GLOBAL + self.below(u64::from(BITS)) as Addr
        };
        bit(addr, n)
    }

    fn bit_cell(&mut self) -> technol_image::BitRef {
        bit(GLOBAL + self.below(u64::from(BITS)) as Addr, self.below(8) as u8)
    }

    fn data_cell(&mut self) -> Addr {
        GLOBAL + BITS + 8 * self.below(u64::from(CELLS)) as Addr
    }

    fn neg(&mut self) -> bool {
        self.below(3) == 0
    }

    fn ldr(&mut self, push: bool) {
        let (bit, neg) = (self.any_bit(), self.neg());
        self.push(Op::Ldr { bit, neg, push });
    }

    fn logic(&mut self) {
        let op =
            [Logic::And, Logic::And, Logic::And, Logic::Or, Logic::Or, Logic::Xor][self.below(6) as usize];
        let (bit, neg) = (self.any_bit(), self.neg());
        self.push(Op::Logic { op, bit, neg });
    }

    /// Bit logic: mostly LDR … WR, some with a bracket, some with a conditional flag or jump.
    fn bits(&mut self) {
        self.ldr(false);
        for _ in 0..=self.below(5) {
            self.logic();
        }
        if self.below(5) == 0 {
            self.ldr(true);
            for _ in 0..=self.below(2) {
                self.logic();
            }
            let op = if self.neg() { Logic::And } else { Logic::Or };
            self.push(Op::LogicPop(op));
        }
        match self.below(10) {
            0 => {
                let op = Op::Flag { value: self.neg(), bit: self.bit_cell(), cond: Cond::IfRlo };
                self.push(op);
            }
            1 => {
                let at = self.items.len();
                self.items.push(Item::Over(0));
                self.ldr(false);
                self.logic();
                let bit = self.bit_cell();
                self.push(Op::Write(bit));
                self.items[at] = Item::Over(self.items.len() - at - 1);
            }
            n => {
                for _ in 0..if n == 2 { 2 } else { 1 } {
                    let bit = self.bit_cell();
                    self.push(Op::Write(bit));
                }
            }
        }
    }

    fn load(&mut self, width: Width) {
        let src = mem(self.data_cell());
        self.push(Op::Load { src, width, neg: false });
    }

    fn store(&mut self, width: Width, cond: Cond) {
        let dst = cell(self.data_cell());
        self.push(Op::Store { dst, width, cond });
    }

    fn source(&mut self) -> Source {
        if self.neg() { mem(self.data_cell()) } else { Source::Int(self.below(1_000) as i64) }
    }

    /// Data: arithmetic on a cell, a comparison, a move, a count.
    fn data(&mut self) {
        let width = [Width::Byte, Width::Word, Width::Word, Width::DWord][self.below(4) as usize];
        match self.below(6) {
            0 | 1 => {
                self.load(width);
                for _ in 0..=self.below(2) {
                    let op = [Arith::Add, Arith::Add, Arith::Sub, Arith::And, Arith::Or, Arith::Mul];
                    let op = op[self.below(6) as usize];
                    let src = self.source();
                    self.push(Op::Arith { op, src, width });
                }
                self.store(width, Cond::Always);
            }
            2 | 3 => {
                self.load(width);
                let op =
                    [Compare::Eq, Compare::Lt, Compare::Gt, Compare::Le, Compare::Ge][self.below(5) as usize];
                let src = self.source();
                self.push(Op::Compare { op, src, width, if_rlo: false });
                let bit = self.bit_cell();
                self.push(Op::Write(bit));
            }
            4 => {
                let (dst, src) = (cell(self.data_cell()), cell(self.data_cell()));
                self.push(Op::Move { dst, src, width, cond: Cond::Always });
            }
            _ => {
                self.ldr(false);
                let value = Source::Int(self.below(100) as i64);
                self.push(Op::Load { src: value, width, neg: false });
                self.store(width, Cond::IfRlo);
            }
        }
    }
}

impl Mixture {
    /// About so many operations.
    pub(crate) fn generate(self, operations: usize) -> Vec<Item> {
        let mut writer = Writer { seed: 0x7EC4_0010, items: Vec::new() };
        while writer.items.len() < operations {
            if writer.below(100) < self.data_percent { writer.data() } else { writer.bits() }
        }
        writer.items
    }
}

/// Into a program for the runtime.
pub(crate) fn write(items: &[Item], builder: &mut Builder) {
    let mut open = Vec::new();
    for (at, item) in items.iter().enumerate() {
        open.retain(|(end, label)| {
            if *end == at {
                builder.place(*label);
            }
            *end != at
        });
        match item {
            Item::Op(op) => drop(builder.op(*op)),
            Item::Over(count) => {
                let label = builder.label();
                builder.jump(label, Cond::IfRlo);
                open.push((at + 1 + count, label));
            }
        }
    }
    for (_, label) in open {
        builder.place(label);
    }
}
