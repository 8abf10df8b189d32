//! Fused code: stretches of bit logic and of data operations on plain cells, executed in a loop of their own.
//!
//! A *term* stands for an equation, or for up to three data operations. Terms need no address to be looked at again, no
//! fault and no break-point, and they fetch their operands without a branch, so that what is left to mispredict is one
//! jump for each term. A *stretch* is a list of terms; every operation at which a term begins has one for the rest of
//! it.

use alloc::vec;
use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Arith, Compare, Cond, Logic, Op, Place, STACK_DEPTH, Source, Width};

use crate::code::Fast;
use crate::equation::{BitWrite, MAX_NESTING, Table, combine};
use crate::memory::Window;
use crate::registers::Registers;

/// Longest stretch in operations.
pub(crate) const MAX_LEN: usize = 64;
/// Values that a stretch may push, not counting what a table pushes and pops.
const MAX_PUSHES: u8 = 2;
/// Values that may be on the equation stack when it begins.
pub(crate) const MOST_PUSHED: u8 = STACK_DEPTH as u8 - MAX_PUSHES - MAX_NESTING;
/// Bytes that a cell is read in, whatever its width.
const READ: usize = 4;

/// What a term does with `x`, its operand, or with RLO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Table `to`.
    Bits,
    /// What LDR does first when an equation is open.
    Push,
    /// LA, LO, LX without operand; `select` is a [`Logic`].
    Pop,
    /// WR, FL, FL1 that no other term could take along.
    Write,
    /// LOD, which is done before anything else in every term.
    Load,
    /// AD, SU: `select` is 1 for SU.
    Sum,
    /// ANDB, ORB, XORB: bit 0 of `select` takes (DR and x), bit 1 (DR xor x); both together are (DR or x).
    Bitwise,
    /// MULB.
    Product,
    /// EQ … GE: RLO is bit 0, 1 or 2 of `select` when DR is less, equal or greater; bit 7: only if RLO. Then a write.
    Compare,
    /// STO, STO0, STO1: bit RLO of `select` says whether.
    Store,
    /// MOVE, MOVE1: from the operand to `to`; bit RLO of `select` says whether.
    Move,
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

    /// Sign-extended.
    #[inline]
    fn get(&self, memory: &Window) -> i64 {
        signed(read(memory, self.at), self.shift) & i64::from(self.cell) | self.value
    }
}

/// One step of a stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    load: Operand,
    operand: Operand,
    write: BitWrite,
    to: u32,
    kind: Kind,
    select: u8,
    /// -1: DR is kept; 0: `load` is put there first.
    keep: i8,
    operations: u8,
}

impl Term {
    fn new(kind: Kind, select: u8) -> Term {
        let (load, operand) = (Operand::NONE, Operand::NONE);
        Term { load, operand, write: BitWrite::none(0), to: 0, kind, select, keep: -1, operations: 1 }
    }

    /// Of one data operation.
    fn of(op: &Op) -> Option<Term> {
        let with = |kind, source: &Source, width, select| {
            let operand = Operand::new(source, width)?;
            Some(Term { operand, ..Term::new(kind, select) })
        };
        match op {
            Op::Load { src, width, neg: false } => {
                let load = Operand::new(src, *width)?;
                Some(Term { load, keep: 0, ..Term::new(Kind::Load, 0) })
            }
            Op::Arith { op, src, width } => {
                let (kind, select) = match op {
                    Arith::Add => (Kind::Sum, 0),
                    Arith::Sub => (Kind::Sum, 1),
                    Arith::And => (Kind::Bitwise, 0b01),
                    Arith::Xor => (Kind::Bitwise, 0b10),
                    Arith::Or => (Kind::Bitwise, 0b11),
                    Arith::Mul => (Kind::Product, 0),
                    Arith::Div => return None,
                };
                with(kind, src, *width, select)
            }
            Op::Compare { op, src, width, if_rlo } => {
                let relation = match op {
                    Compare::Eq => 0b010,
                    Compare::Lt => 0b001,
                    Compare::Gt => 0b100,
                    Compare::Le => 0b011,
                    Compare::Ge => 0b110,
                };
                with(Kind::Compare, src, *width, relation | u8::from(*if_rlo) << 7)
            }
            Op::Store { dst, width, cond } => with(Kind::Store, &Source::Mem(*dst), *width, acts(*cond)),
            Op::Move { dst, src, width, cond } => {
                let from = with(Kind::Move, &Source::Mem(*src), *width, acts(*cond))?;
                let to = Operand::new(&Source::Mem(*dst), *width)?.at;
                Some(Term { to: u32::from(to), ..from })
            }
            Op::LogicPop(op) => Some(Term::new(Kind::Pop, *op as u8)),
            _ => BitWrite::of(op).map(|write| Term { write, ..Term::new(Kind::Write, 0) }),
        }
    }

    /// Both in one, if that is possible.
    fn joined(self, next: Term) -> Option<Term> {
        let operations = self.operations + next.operations;
        match (self.kind, next.kind) {
            (Kind::Load, Kind::Sum | Kind::Bitwise | Kind::Product | Kind::Compare | Kind::Store) => {
                Some(Term { load: self.load, keep: 0, operations, ..next })
            }
            (Kind::Compare, Kind::Write) => Some(Term { write: next.write, operations, ..self }),
            _ => None,
        }
    }
}

/// Bit 0: acts when RLO is 0; bit 1: when it is 1.
fn acts(cond: Cond) -> u8 {
    match cond {
        Cond::Always => 0b11,
        Cond::IfRlo => 0b10,
        Cond::IfNotRlo => 0b01,
    }
}

/// The fast entries of a program and the terms behind them.
pub(crate) struct Fused {
    pub(crate) fast: Vec<Fast>,
    pub(crate) terms: Vec<Term>,
    pub(crate) tables: Vec<Table>,
}

/// Fuses a validated program.
pub(crate) fn fuse(program: &Program) -> Fused {
    let code = &program.code;
    let targets = jump_targets(code);
    let mut fused = Fused { fast: vec![Fast::General; code.len()], terms: Vec::new(), tables: Vec::new() };
    let (mut pc, mut begins) = (0, Vec::new());
    while pc < code.len() {
        if let Op::Jump { target, cond } = code[pc] {
            fused.fast[pc] = Fast::Jump { target, cond };
        }
        // A jump to its middle ends a term, so that it is fast from there on too.
        let most = code.len().min(pc + MAX_LEN / 2);
        let end = (pc + 1..most).find(|at| targets[*at]).unwrap_or(most);
        let term = fused.equation(&code[pc..end], &mut begins, pc).or_else(|| data(&code[pc..end]));
        if let Some(term) = term {
            begins.push(pc);
            fused.terms.push(term);
        }
        pc += term.map_or(1, |term| usize::from(term.operations));
        if term.is_none() || pc == code.len() {
            fused.close(&begins);
            begins.clear();
        }
    }
    fused
}

/// The data operations that these begin with, as many as one term takes.
fn data(ops: &[Op]) -> Option<Term> {
    let mut terms = ops.iter().map_while(|op| Term::of(op));
    let first = terms.next()?;
    // Load, compare, write.
    let mut term = first;
    for next in terms {
        match term.joined(next) {
            Some(both) => term = both,
            None => break,
        }
    }
    Some(term)
}

impl Fused {
    /// The equation, or as much of it as a table takes, that these begin with.
    ///
    /// A bracket that the table does not close is opened by a term before it, which stands for no operation.
    fn equation(&mut self, ops: &[Op], begins: &mut Vec<usize>, pc: usize) -> Option<Term> {
        let (mut table, logic, pushes) = match Table::of(ops, false) {
            Some((table, len)) => (table, len, false),
            None => Table::of(ops, true).map(|(table, len)| (table, len, true))?,
        };
        if pushes {
            begins.push(pc);
            self.terms.push(Term { operations: 0, ..Term::new(Kind::Push, 0) });
        }
        let write = ops.get(logic).and_then(BitWrite::of);
        table.write = write.unwrap_or(table.write);
        let term = Term {
            to: self.tables.len() as u32,
            operations: logic as u8 + u8::from(write.is_some()),
            ..Term::new(Kind::Bits, 0)
        };
        self.tables.push(table);
        Some(term)
    }

    /// The last terms, which begin at these operations, are a stretch.
    fn close(&mut self, begins: &[usize]) {
        let first = self.terms.len() - begins.len();
        // The last first, so that an operation for which there are two terms gets the entry with both.
        for (n, pc) in begins.iter().enumerate().rev() {
            self.fast[*pc] = stretch(&self.terms[first + n..], first + n, MAX_LEN);
        }
    }
}

/// The longest entry for these terms that covers at most `most` operations.
fn stretch(terms: &[Term], first: usize, most: usize) -> Fast {
    let (mut seen, mut taken, mut ops, mut pops, mut depth) = (0, 0, 0, 0_u8, 0_i8);
    for term in terms {
        let pushes = term.kind == Kind::Push;
        let len = usize::from(term.operations);
        if ops + len > most || (pushes && depth == MAX_PUSHES as i8) || pops == MOST_PUSHED {
            break;
        }
        depth += i8::from(pushes);
        if term.kind == Kind::Pop {
            depth -= 1;
            pops = pops.max(depth.min(0).unsigned_abs());
        }
        seen += 1;
        ops += len;
        // A push alone would be done twice.
        taken = if pushes { taken } else { seen };
    }
    if taken == 0 {
        return Fast::General;
    }
    Fast::Stretch { first: first as u32, terms: taken, ops: ops as u8, pops }
}

/// The entry of an operation when a break-point lies `distance` operations behind it.
pub(crate) fn shortened(entry: Fast, distance: usize, terms: &[Term]) -> Fast {
    match entry {
        Fast::Stretch { first, terms: count, ops, .. } if usize::from(ops) > distance => {
            let first = first as usize;
            stretch(&terms[first..first + usize::from(count)], first, distance)
        }
        other => other,
    }
}

fn jump_targets(code: &[Op]) -> Vec<bool> {
    let mut targets = vec![false; code.len()];
    for op in code {
        if let Op::Jump { target, .. } = op {
            targets[*target as usize] = true;
        }
    }
    targets
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
    let new = read(memory, at) & !mask | value & mask;
    let at = usize::from(at);
    memory[at..at + READ].copy_from_slice(&new.to_le_bytes());
}

/// Executes a stretch.
#[inline(never)]
pub(crate) fn execute(terms: &[Term], tables: &[Table], memory: &mut Window, regs: &mut Registers) {
    let (mut rlo, mut dr) = (regs.rlo, regs.dr);
    for term in terms {
        if term.kind == Kind::Bits {
            rlo = tables[term.to as usize].evaluate(memory, rlo);
            continue;
        }
        dr = dr & i64::from(term.keep) | term.load.get(memory);
        let (select, operand, shift) = (term.select, &term.operand, term.operand.shift);
        let low = i64::from(mask(shift));
        let chosen = |rlo: bool| mask(shift) & 0_u32.wrapping_sub(u32::from(select >> u8::from(rlo) & 1));
        match term.kind {
            Kind::Sum => {
                let negative = -i64::from(select);
                let sum = dr.wrapping_add((operand.get(memory) ^ negative).wrapping_sub(negative));
                dr = dr & !low | sum & low;
            }
            Kind::Bitwise => {
                let x = operand.get(memory);
                let both = dr & x & -i64::from(select & 1);
                let result = both ^ (dr ^ x) & -i64::from(select >> 1);
                dr = dr & !low | result & low;
            }
            Kind::Product => {
                let x = signed(operand.get(memory) as u32, shift);
                dr = signed(dr as u32, shift).wrapping_mul(x);
            }
            Kind::Compare => {
                let (a, b) = (signed(dr as u32, shift), operand.get(memory));
                let place = u8::from(a >= b) + u8::from(a > b);
                rlo = (select >> place & 1 != 0) & (rlo | (select >> 7 == 0));
                term.write.execute(memory, rlo);
            }
            Kind::Store => write(memory, operand.at, chosen(rlo), dr as u32),
            Kind::Move => {
                let value = read(memory, operand.at);
                write(memory, term.to as u16, chosen(rlo), value);
            }
            Kind::Write => term.write.execute(memory, rlo),
            Kind::Pop => {
                let value = regs.stack & 1;
                regs.stack >>= 1;
                regs.depth -= 1;
                let logic = [Logic::And, Logic::Or, Logic::Xor][usize::from(select)];
                rlo = combine(logic, rlo, value != 0);
            }
            Kind::Push => {
                regs.stack = regs.stack << 1 | u8::from(rlo);
                regs.depth += 1;
            }
            Kind::Load | Kind::Bits => {}
        }
    }
    regs.rlo = rlo;
    regs.dr = dr;
}
