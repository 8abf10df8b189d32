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

use crate::code::{Code, Fast};
use crate::equation::{BitWrite, MAX_NESTING, Table, combine};
use crate::memory::Window;
use crate::registers::Registers;

/// Longest stretch in operations.
pub(crate) const MAX_LEN: usize = 240;
/// Values that a stretch may push, not counting what a table pushes and pops.
const MAX_PUSHES: u8 = 2;
/// Values that may be on the equation stack when it begins.
pub(crate) const MOST_PUSHED: u8 = STACK_DEPTH as u8 - MAX_PUSHES - MAX_NESTING;
/// Bytes that a cell is read in, whatever its width.
const READ: usize = 4;

/// What a term does with `x`, its operand, or with RLO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// An equation.
    Bits,
    /// What LDR does first when an equation is open.
    Push,
    /// LA, LO, LX without operand; `select` is a [`Logic`].
    Pop,
    /// WR, FL, FL1 that no other term could take along.
    Write,
    /// LOD, then one of AD, SU, ANDB, ORB, XORB, MULB, then STO, STO0, STO1; each of them may be missing.
    Calculate,
    /// LOD, which may be missing, EQ … GE, then a write: RLO is bit 0, 1 or 2 of `select` when DR is less, equal or
    /// greater; bit 7: only if RLO.
    Compare,
    /// MOVE, MOVE1: from the operand to `to`; bit RLO of `when` says whether.
    Move,
    /// JUM, JL0, JL1 forward within the stretch, over terms that leave the equation stack alone.
    Skip,
}

/// What [`Kind::Calculate`] takes together: DR + x, DR - x, …
mod select {
    pub(super) const SUM: u8 = 1;
    pub(super) const NEGATIVE: u8 = 2;
    pub(super) const AND: u8 = 4;
    pub(super) const XOR: u8 = 8;
    pub(super) const PRODUCT: u8 = 16;
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
    fn calculates(&self, select: u8) -> bool {
        select != select::SUM || self.cell != 0 || self.value != 0
    }

    /// Sign-extended.
    #[inline]
    fn get(&self, memory: &Window) -> i64 {
        signed(read(memory, self.at), self.shift) & i64::from(self.cell) | self.value
    }
}

/// One step of a stretch; small, because all of them pass by in each cycle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    kind: Kind,
    pub(crate) operations: u8,
    /// Index of the table, or of the data; what is skipped, see [`Skip`].
    at: u32,
}

/// A jump within a stretch.
#[derive(Clone, Copy, Debug)]
struct Skip {
    terms: u8,
    operations: u8,
    /// Bit RLO: it jumps.
    when: u8,
}

impl Skip {
    fn of(term: Term) -> Skip {
        let [terms, operations, when, _] = term.at.to_le_bytes();
        Skip { terms, operations, when }
    }

    fn term(self) -> Term {
        let at = u32::from_le_bytes([self.terms, self.operations, self.when, 0]);
        Term { kind: Kind::Skip, operations: 1, at }
    }
}

/// Of a term that is no equation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Data {
    load: Operand,
    operand: Operand,
    write: BitWrite,
    /// Where DR, or what is moved, goes; bits by which that is less than 32 bits wide; bit RLO: it goes.
    to: u16,
    to_shift: u8,
    when: u8,
    select: u8,
    /// -1: DR is kept; 0: `load` is put there first.
    keep: i8,
}

/// A term that may still become part of a longer one.
#[derive(Clone, Copy, Debug)]
struct Draft {
    kind: Kind,
    operations: u8,
    data: Data,
}

impl Draft {
    fn new(kind: Kind, select: u8) -> Draft {
        let (load, operand, write) = (Operand::NONE, Operand::NONE, BitWrite::none(0));
        Draft {
            kind,
            operations: 1,
            data: Data { load, operand, write, to: 0, to_shift: 0, when: 0, select, keep: -1 },
        }
    }

    /// With something else in its data.
    fn with(mut self, change: impl FnOnce(&mut Data)) -> Draft {
        change(&mut self.data);
        self
    }

    /// Of one data operation.
    fn of(op: &Op) -> Option<Draft> {
        let with = |kind, source: &Source, width, select| {
            let operand = Operand::new(source, width)?;
            Some(Draft::new(kind, select).with(|data| data.operand = operand))
        };
        match op {
            Op::Load { src, width, neg: false } => {
                let load = Operand::new(src, *width)?;
                Some(Draft::new(Kind::Calculate, select::SUM).with(|data| (data.load, data.keep) = (load, 0)))
            }
            Op::Arith { op, src, width } => {
                let select = match op {
                    Arith::Add => select::SUM,
                    Arith::Sub => select::SUM | select::NEGATIVE,
                    Arith::And => select::AND,
                    Arith::Xor => select::XOR,
                    Arith::Or => select::AND | select::XOR,
                    Arith::Mul => select::PRODUCT,
                    Arith::Div => return None,
                };
                with(Kind::Calculate, src, *width, select)
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
            Op::Store { dst, width, cond } => {
                let to = Operand::new(&Source::Mem(*dst), *width)?;
                Some(Draft::new(Kind::Calculate, select::SUM).with(|data| data.goes(to, *cond)))
            }
            Op::Move { dst, src, width, cond } => {
                let from = with(Kind::Move, &Source::Mem(*src), *width, 0)?;
                let to = Operand::new(&Source::Mem(*dst), *width)?;
                Some(from.with(|data| data.goes(to, *cond)))
            }
            Op::LogicPop(op) => Some(Draft::new(Kind::Pop, *op as u8)),
            _ => BitWrite::of(op).map(|write| Draft::new(Kind::Write, 0).with(|data| data.write = write)),
        }
    }

    /// Both in one, if that is possible.
    fn joined(self, next: Draft) -> Option<Draft> {
        let operations = self.operations + next.operations;
        let (mine, its) = (&self.data, &next.data);
        let (stores, calculates) = (mine.when != 0, mine.operand.calculates(mine.select));
        match (self.kind, next.kind) {
            // LOD, then what does not begin with one.
            (Kind::Calculate, Kind::Calculate | Kind::Compare) if !stores && !calculates && its.keep != 0 => {
                let joined = Draft { operations, ..next };
                Some(joined.with(|data| (data.load, data.keep) = (mine.load, mine.keep)))
            }
            // A calculation, then STO alone.
            (Kind::Calculate, Kind::Calculate)
                if !stores && its.keep != 0 && !its.operand.calculates(its.select) =>
            {
                let joined = Draft { operations, ..self };
                Some(
                    joined
                        .with(|data| (data.to, data.to_shift, data.when) = (its.to, its.to_shift, its.when)),
                )
            }
            (Kind::Compare, Kind::Write) if !mine.write.is_one() => {
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
        if data.when == 0 {
            data.to = spare;
        }
        if self.kind == Kind::Compare && !data.write.is_one() {
            data.write = BitWrite::none(spare);
        }
        data
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
    pub(crate) data: Vec<Data>,
}

/// Fuses a validated program.
pub(crate) fn fuse(program: &Program) -> Fused {
    let code = &program.code;
    let targets = jump_targets(code);
    let mut fused = Fused {
        fast: vec![Fast::General; code.len()],
        terms: Vec::new(),
        tables: Vec::new(),
        data: Vec::new(),
    };
    let (mut pc, mut begins) = (0, Vec::new());
    while pc < code.len() {
        if let Op::Jump { target, cond } = code[pc] {
            fused.fast[pc] = Fast::Jump { target, cond };
        }
        // A jump to its middle ends a term, so that it is fast from there on too.
        let most = code.len().min(pc + MAX_LEN / 2);
        let end = (pc + 1..most).find(|at| targets[*at]).unwrap_or(most);
        let ops = &code[pc..end];
        let term = fused.equation(ops, &mut begins, pc).or_else(|| fused.data(ops)).or_else(|| skip(ops, pc));
        if let Some(term) = term {
            begins.push(pc);
            fused.terms.push(term);
        }
        pc += term.map_or(1, |term| usize::from(term.operations));
        if term.is_none() || pc == code.len() {
            let behind = if term.is_none() { pc - 1 } else { pc };
            fused.aim(code, &begins, behind);
            fused.close(&begins);
            begins.clear();
        }
    }
    fused
}

impl Fused {
    /// The data operations that these begin with, as many as one term takes.
    fn data(&mut self, ops: &[Op]) -> Option<Term> {
        let mut drafts = ops.iter().map_while(Draft::of);
        let mut draft = drafts.next()?;
        while let Some(both) = drafts.next().and_then(|next| draft.joined(next)) {
            draft = both;
        }
        let at = self.data.len() as u32;
        self.data.push(draft.finished());
        Some(Term { kind: draft.kind, operations: draft.operations, at })
    }

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
            self.terms.push(Term { kind: Kind::Push, operations: 0, at: 0 });
        }
        let write = ops.get(logic).and_then(BitWrite::of);
        table.write = write.unwrap_or(table.write);
        let operations = logic as u8 + u8::from(write.is_some());
        let term = Term { kind: Kind::Bits, operations, at: self.tables.len() as u32 };
        self.tables.push(table);
        Some(term)
    }

    /// Skips among the last terms, which begin at these operations and end before `end`, learn how much they skip.
    /// Those that cannot stay as they are: too long, so that no stretch holds them.
    fn aim(&mut self, code: &[Op], begins: &[usize], end: usize) {
        let first = self.terms.len() - begins.len();
        for (n, pc) in begins.iter().enumerate() {
            let Op::Jump { target, cond } = code[*pc] else { continue };
            let target = target as usize;
            let behind = begins.iter().position(|begin| *begin == target);
            let behind = behind.or((target == end).then_some(begins.len()));
            let skipped =
                behind.filter(|behind| *behind > n).map(|behind| &self.terms[first + n + 1..first + behind]);
            let balanced = |term: &Term| !matches!(term.kind, Kind::Push | Kind::Pop);
            let fits = |terms: &&[Term]| terms.len() <= MAX_LEN && terms.iter().all(balanced);
            if let Some(skipped) = skipped.filter(fits)
                && let Ok(operations) = u8::try_from(target - pc - 1)
            {
                let skip = Skip { terms: skipped.len() as u8, operations, when: acts(cond) };
                self.terms[first + n] = skip.term();
            }
        }
    }

    /// The last terms, which begin at these operations, are a stretch.
    fn close(&mut self, begins: &[usize]) {
        let first = self.terms.len() - begins.len();
        // The last first, so that an operation for which there are two terms gets the entry with both.
        for (n, pc) in begins.iter().enumerate().rev() {
            if let Some(entry) = stretch(&self.terms[first + n..], first + n, MAX_LEN) {
                self.fast[*pc] = entry;
            }
        }
    }
}

/// A jump whose target is not known yet.
fn skip(ops: &[Op], pc: usize) -> Option<Term> {
    let forward = matches!(ops[0], Op::Jump { target, .. } if target as usize > pc);
    forward.then(|| Skip { terms: u8::MAX, operations: u8::MAX, when: 0 }.term())
}

/// The longest entry for these terms that covers at most `most` operations.
fn stretch(terms: &[Term], first: usize, most: usize) -> Option<Fast> {
    let mut taken = None;
    let (mut ops, mut pops, mut depth, mut target) = (0, 0_u8, 0_i8, 0);
    for (n, term) in terms.iter().enumerate().take(usize::from(u8::MAX)) {
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
        ops += len;
        if term.kind == Kind::Skip {
            let skip = Skip::of(*term);
            if ops + usize::from(skip.operations) > most {
                break;
            }
            target = target.max(n + 1 + usize::from(skip.terms));
        }
        // A push alone would be done twice, and a skip has to arrive.
        if !pushes && n + 1 >= target {
            taken = Some(Fast::Stretch { first: first as u32, terms: n as u8 + 1, ops: ops as u8, pops });
        }
    }
    taken
}

/// The entry of an operation when a break-point lies `distance` operations behind it.
pub(crate) fn shortened(entry: Fast, distance: usize, terms: &[Term]) -> Fast {
    match entry {
        Fast::Stretch { first, terms: count, ops, .. } if usize::from(ops) > distance => {
            let first = first as usize;
            stretch(&terms[first..first + usize::from(count)], first, distance).unwrap_or(Fast::General)
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

/// Who sees what terms work with.
pub(crate) trait Witness {
    /// A term is about to act. `bits`: those of its equation; `dr`: behind its LOD.
    fn term(&mut self, rlo: bool, bits: u8, dr: i64, operand: i64, regs: &Registers);
    /// So many terms are skipped.
    fn skip(&mut self, terms: usize);
}

/// Nobody.
pub(crate) struct Unseen;

impl Witness for Unseen {
    #[inline(always)]
    fn term(&mut self, _: bool, _: u8, _: i64, _: i64, _: &Registers) {}

    #[inline(always)]
    fn skip(&mut self, _: usize) {}
}

/// Executes a stretch of the terms of `code`. Gives the number of operations that it skipped.
#[inline(never)]
pub(crate) fn execute<W: Witness>(
    terms: &[Term],
    code: &Code,
    memory: &mut Window,
    regs: &mut Registers,
    mut witness: W,
) -> u32 {
    let (mut rlo, mut dr, mut skipped) = (regs.rlo, regs.dr, 0);
    let mut rest = terms.iter();
    while let Some(term) = rest.next() {
        match term.kind {
            Kind::Bits => {
                let table = &code.tables[term.at as usize];
                let bits = table.gather(memory);
                witness.term(rlo, bits, dr, 0, regs);
                rlo = table.evaluate(memory, bits, rlo);
            }
            Kind::Push => {
                witness.term(rlo, 0, dr, 0, regs);
                regs.stack = regs.stack << 1 | u8::from(rlo);
                regs.depth += 1;
            }
            Kind::Skip => {
                witness.term(rlo, 0, dr, 0, regs);
                let skip = Skip::of(*term);
                if skip.when >> u8::from(rlo) & 1 != 0 {
                    let terms = usize::from(skip.terms);
                    rest = rest.as_slice().get(terms..).unwrap_or_default().iter();
                    witness.skip(terms);
                    skipped += u32::from(skip.operations);
                }
            }
            kind => {
                let data = &code.data[term.at as usize];
                (rlo, dr) = data.execute(kind, memory, regs, rlo, dr, &mut witness);
            }
        }
    }
    regs.rlo = rlo;
    regs.dr = dr;
    skipped
}

impl Data {
    fn goes(&mut self, to: Operand, cond: Cond) {
        (self.to, self.to_shift, self.when) = (to.at, to.shift, acts(cond));
    }

    /// RLO and DR afterwards.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "RLO and DR stay in registers; measured in benches/against_c")]
    fn execute(
        &self,
        kind: Kind,
        memory: &mut Window,
        regs: &mut Registers,
        mut rlo: bool,
        mut dr: i64,
        witness: &mut impl Witness,
    ) -> (bool, i64) {
        let (select, operand, shift) = (self.select, &self.operand, self.operand.shift);
        let chosen =
            |rlo: bool| mask(self.to_shift) & 0_u32.wrapping_sub(u32::from(self.when >> u8::from(rlo) & 1));
        // All ones when it is selected.
        let if_selected = |what: u8| -i64::from(select & what != 0);
        match kind {
            Kind::Calculate => {
                dr = dr & i64::from(self.keep) | self.load.get(memory);
                let x = operand.get(memory);
                witness.term(rlo, 0, dr, x, regs);
                let negative = if_selected(select::NEGATIVE);
                let sum = dr.wrapping_add((x ^ negative).wrapping_sub(negative)) & if_selected(select::SUM);
                let bits = dr & x & if_selected(select::AND) ^ (dr ^ x) & if_selected(select::XOR);
                let product = signed(dr as u32, shift).wrapping_mul(signed(x as u32, shift));
                let whole = if_selected(select::PRODUCT);
                let low = i64::from(mask(shift)) | whole;
                dr = dr & !low | (sum | bits | product & whole) & low;
                write(memory, self.to, chosen(rlo), dr as u32);
            }
            Kind::Compare => {
                dr = dr & i64::from(self.keep) | self.load.get(memory);
                let (a, b) = (signed(dr as u32, shift), operand.get(memory));
                witness.term(rlo, 0, dr, b, regs);
                let place = u8::from(a >= b) + u8::from(a > b);
                // Without branches.
                rlo = select >> place & (u8::from(rlo) | !select >> 7) & 1 != 0;
                self.write.execute(memory, rlo);
            }
            Kind::Move => {
                witness.term(rlo, 0, dr, 0, regs);
                let value = read(memory, operand.at);
                write(memory, self.to, chosen(rlo), value);
            }
            Kind::Write => {
                witness.term(rlo, 0, dr, 0, regs);
                self.write.execute(memory, rlo);
            }
            Kind::Pop => {
                witness.term(rlo, 0, dr, 0, regs);
                let value = regs.stack & 1;
                regs.stack >>= 1;
                regs.depth -= 1;
                let logic = [Logic::And, Logic::Or, Logic::Xor][usize::from(select)];
                rlo = combine(logic, rlo, value != 0);
            }
            Kind::Bits | Kind::Push | Kind::Skip => {}
        }
        (rlo, dr)
    }
}
