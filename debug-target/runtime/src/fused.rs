//! Fused code: stretches of bit logic and of data operations on plain cells, executed in a loop of their own.
//!
//! A *term* stands for an equation, or for up to three data operations. Terms need no address to be looked at again, no
//! fault and no break-point, and they fetch their operands without a branch, so that what is left to mispredict is the
//! kind of each term, and jumps. A *stretch* is a list of terms; every operation at which a term begins has one for the rest of
//! it.

use alloc::vec;
use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Op, STACK_DEPTH};

use crate::code::{Code, Fast};
use crate::data::{Data, Machine, acts};
use crate::equation::{BitWrite, MAX_NESTING, Table};
use crate::memory::Window;
use crate::registers::Registers;

/// Longest stretch in operations.
pub(crate) const MAX_LEN: usize = 240;
/// Values that a stretch may push, not counting what a table pushes and pops.
const MAX_PUSHES: u8 = 2;
/// Values that may be on the equation stack when it begins.
pub(crate) const MOST_PUSHED: u8 = STACK_DEPTH as u8 - MAX_PUSHES - MAX_NESTING;

/// What a term does. One bit each: asked for one after the other, which processors foresee better than one jump to many
/// places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kind(u8);

impl Kind {
    /// An equation.
    const BITS: Kind = Kind(1);
    /// JUM, JL0, JL1 forward within the stretch, over terms that leave the equation stack alone.
    const SKIP: Kind = Kind(2);
    /// LOD, then one of AD, SU, ANDB, ORB, XORB, MULB, then STO, STO0, STO1; each of them may be missing.
    pub(crate) const CALCULATE: Kind = Kind(4);
    /// LOD, which may be missing, EQ … GE, then a write, which may be missing: RLO is bit 0, 1 or 2 of `select` when DR is
    /// less, equal or greater; bit 7: only if RLO.
    pub(crate) const COMPARE: Kind = Kind(8);
    /// WR, FL, FL1 that no other term could take along.
    pub(crate) const WRITE: Kind = Kind(16);
    /// MOVE, MOVE1: from the operand to `to`; bit RLO of `when` says whether.
    pub(crate) const MOVE: Kind = Kind(32);
    /// LA, LO, LX without operand; `select` is a [`Logic`](technol_image::op::Logic).
    pub(crate) const POP: Kind = Kind(64);
    /// What LDR does first when an equation is open.
    const PUSH: Kind = Kind(128);
    /// All that have [`Data`].
    const DATA: Kind = Kind(4 | 8 | 16 | 32 | 64);

    #[inline]
    pub(crate) fn is(self, kind: Kind) -> bool {
        self.0 & kind.0 != 0
    }
}

/// One step of a stretch; small, because all of them pass by in each cycle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    kind: Kind,
    pub(crate) operations: u8,
    /// Of an equation: how many follow each other from here, this one too; their tables do so, too.
    run: u8,
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
        Term { kind: Kind::SKIP, operations: 1, run: 0, at }
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
        let (kind, data, operations) = Data::of(ops)?;
        let at = self.data.len() as u32;
        self.data.push(data);
        Some(Term { kind, operations, run: 0, at })
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
            self.terms.push(Term { kind: Kind::PUSH, operations: 0, run: 0, at: 0 });
        }
        let write = ops.get(logic).and_then(BitWrite::of);
        table.write = write.unwrap_or(table.write);
        let operations = logic as u8 + u8::from(write.is_some());
        let term = Term { kind: Kind::BITS, operations, run: 1, at: self.tables.len() as u32 };
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
            let balanced = |term: &Term| !matches!(term.kind, Kind::PUSH | Kind::POP);
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
        let mut run = 0_u8;
        for term in self.terms[first..].iter_mut().rev() {
            run = if term.kind == Kind::BITS { run.saturating_add(1) } else { 0 };
            term.run = run;
        }
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
        let pushes = term.kind == Kind::PUSH;
        let len = usize::from(term.operations);
        if ops + len > most || (pushes && depth == MAX_PUSHES as i8) || pops == MOST_PUSHED {
            break;
        }
        depth += i8::from(pushes);
        if term.kind == Kind::POP {
            depth -= 1;
            pops = pops.max(depth.min(0).unsigned_abs());
        }
        ops += len;
        if term.kind == Kind::SKIP {
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
    #[inline]
    fn term(&mut self, _: bool, _: u8, _: i64, _: i64, _: &Registers) {}

    #[inline]
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
    while let Some(mut term) = rest.next() {
        if term.kind.is(Kind::BITS) {
            // Not beyond the end of the stretch, which a break-point may have brought nearer.
            let others = (usize::from(term.run) - 1).min(rest.len());
            for table in &code.tables[term.at as usize..][..=others] {
                let bits = table.gather(memory);
                witness.term(rlo, bits, dr, 0, regs);
                rlo = table.evaluate(memory, bits, rlo);
            }
            let Some((next, behind)) = rest.as_slice()[others..].split_first() else { break };
            (term, rest) = (next, behind.iter());
        }
        let kind = term.kind;
        if kind.is(Kind::DATA) {
            let on = Machine { memory, regs, witness: &mut witness };
            (rlo, dr) = code.data[term.at as usize].execute(kind, on, rlo, dr);
            continue;
        }
        witness.term(rlo, 0, dr, 0, regs);
        if kind.is(Kind::SKIP) {
            let skip = Skip::of(*term);
            if skip.when >> u8::from(rlo) & 1 != 0 {
                let terms = usize::from(skip.terms);
                rest = rest.as_slice().get(terms..).unwrap_or_default().iter();
                witness.skip(terms);
                skipped += u32::from(skip.operations);
            }
        } else {
            regs.stack = regs.stack << 1 | u8::from(rlo);
            regs.depth += 1;
        }
    }
    regs.rlo = rlo;
    regs.dr = dr;
    skipped
}
