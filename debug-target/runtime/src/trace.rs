//! The register trace: what the registers were behind each of some lines, the last time the program came by.
//!
//! Traced code stays fused. What a term of a stretch works with (the bits it has gathered, DR, its operand) says what
//! each of its operations did, so that is what is noted, once for each term; the values of a line are computed from it
//! when somebody asks for them. Operations that are executed one by one are noted with their registers.

mod places;
mod recorder;
mod replay;

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use technol_image::Program;
use technol_image::op::{Op, Pc, Width};

use self::places::{TermPlace, traced_terms};
pub(crate) use self::recorder::{Recorder, Untraced};
use self::replay::registers_after;
use crate::code::Code;
use crate::registers::Registers;
use crate::runtime::Runtime;

/// A traced line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceEntry {
    /// Operation that the line begins with.
    pub pc: Pc,
    /// The last time it was executed; `None`: not yet since the trace was set or the PLC was started.
    pub last: Option<TraceValues>,
}

/// The registers behind a line, the last time it was executed.
///
/// Behind a jump or a call they are what the operation found; where a line consists of several operations they are
/// those behind the last one that was executed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceValues {
    /// 20 ms cycle of that, as [`Runtime::cycle`] counts them.
    pub cycle: u64,
    /// That was in the cycle in progress or, between two cycles, in the last one.
    pub ran: bool,
    /// Result of logic operation.
    pub rlo: bool,
    /// Data register, 64 bits.
    pub dr: i64,
    /// Real data register, of a line that works with it or has changed it.
    pub dr_real: Option<f64>,
    /// Equation stack: bit 0 is the value pushed last.
    pub stack: u8,
    /// Number of values on the equation stack, 0 to 8.
    pub depth: u8,
}

/// Stands for "not traced" where a place in a list is stored.
const NONE: u32 = u32::MAX;

/// An order of all that is noted, with the cycle in its upper half; 0: never.
type Stamp = u64;

/// An operation that was executed by itself.
#[derive(Clone, Copy, Debug, Default)]
struct SeenOperation {
    stamp: Stamp,
    dr: i64,
    dr_real: f64,
    real_changed: bool,
    rlo: bool,
    stack: u8,
    depth: u8,
}

/// What a term began with, and what it read.
#[derive(Clone, Copy, Debug, Default)]
struct SeenTerm {
    stamp: Stamp,
    /// DR, behind the LOD if the term has one.
    dr: i64,
    /// The operand of its calculation or comparison.
    operand: i64,
    /// The bits of its equation.
    bits: u8,
    rlo: bool,
    stack: u8,
    depth: u8,
}

/// What is traced, and what was seen of it.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    /// Operations of each line.
    lines: Vec<Range<Pc>>,
    /// For each operation its place in `operations`, or [`NONE`].
    operation_at: Vec<u32>,
    operations: Vec<SeenOperation>,
    /// For each term with which a traced stretch begins its place in `terms`, or [`NONE`].
    term_at: Vec<u32>,
    /// Of all terms of such stretches, in the order of the program.
    places: Vec<TermPlace>,
    terms: Vec<SeenTerm>,
    last: Stamp,
    /// DR_REAL behind the last operation that was noted.
    real: u64,
}

impl Trace {
    /// For the lines that begin in these ranges; `None` when there are none.
    fn new(program: &Program, code: &Code, ranges: &[Range<Pc>]) -> Option<Trace> {
        let begins = |pc: &&Pc| ranges.iter().any(|range| range.contains(*pc));
        let lines: Vec<_> =
            program.statements.iter().filter(begins).map(|pc| line_at(program, code, *pc)).collect();
        if lines.is_empty() {
            return None;
        }
        let mut operation_at = vec![NONE; program.code.len()];
        let mut count = 0;
        for pc in lines.iter().cloned().flatten() {
            operation_at[pc as usize] = count;
            count += 1;
        }
        let operations = vec![SeenOperation::default(); count as usize];
        let (term_at, places) = traced_terms(code, &operation_at);
        let terms = vec![SeenTerm::default(); places.len()];
        Some(Trace { lines, operation_at, operations, term_at, places, terms, last: 0, real: 0 })
    }

    /// A pass begins or goes on, in this cycle and with this DR_REAL.
    pub(crate) fn enter(&mut self, cycle: u64, dr_real: f64) {
        self.last = self.last.max(cycle << 32);
        self.real = dr_real.to_bits();
    }

    /// As if nothing had been executed.
    pub(crate) fn forget(&mut self) {
        self.operations.fill(SeenOperation::default());
        self.terms.fill(SeenTerm::default());
        self.last = 0;
    }

    /// The registers behind the operation, and when that was.
    fn seen(&self, program: &Program, pc: Pc) -> Option<(Stamp, Registers)> {
        let alone = self.operations[self.operation_at[pc as usize] as usize];
        let behind = self.places.partition_point(|place| place.pc <= pc);
        let term = behind
            .checked_sub(1)
            .filter(|at| pc < self.places[*at].pc + Pc::from(self.places[*at].operations));
        if let Some((place, seen)) = term.map(|at| (self.places[at], self.terms[at]))
            && seen.stamp > alone.stamp
        {
            let ops = &program.code[place.pc as usize..=pc as usize];
            return Some((seen.stamp, registers_after(ops, &seen, place.opens)));
        }
        let SeenOperation { stamp, dr, dr_real, rlo, stack, depth, .. } = alone;
        (stamp > 0).then_some((stamp, Registers { rlo, dr, dr_real, stack, depth, ..Registers::default() }))
    }

    fn values(&self, program: &Program, line: &Range<Pc>, now: u64) -> Option<TraceValues> {
        // Of operations of one term, which have the same stamp, the last one.
        let seen = line.clone().filter_map(|pc| Some((pc, self.seen(program, pc)?)));
        let (pc, (stamp, regs)) = seen.max_by_key(|(_, (stamp, _))| *stamp)?;
        let alone = &self.operations[self.operation_at[pc as usize] as usize];
        let shows_real =
            alone.stamp == stamp && (alone.real_changed || works_with_reals(&program.code[pc as usize]));
        let cycle = stamp >> 32;
        Some(TraceValues {
            cycle,
            ran: cycle == now,
            rlo: regs.rlo,
            dr: regs.dr,
            dr_real: shows_real.then_some(regs.dr_real),
            stack: regs.stack,
            depth: regs.depth,
        })
    }
}

/// The operations of the line that begins there.
fn line_at(program: &Program, code: &Code, pc: Pc) -> Range<Pc> {
    // The end of a module belongs to no line, unless it is one.
    let belongs = |at: &Pc| !code.statement[*at as usize] && program.code[*at as usize] != Op::ModuleEnd;
    let more = (pc + 1..program.code.len() as Pc).take_while(belongs).count();
    pc..pc + 1 + more as Pc
}

fn works_with_reals(op: &Op) -> bool {
    match op {
        Op::Load { width, .. }
        | Op::Store { width, .. }
        | Op::Arith { width, .. }
        | Op::Compare { width, .. }
        | Op::Unary { width, .. } => *width == Width::Real,
        Op::IntToReal(_) => true,
        _ => false,
    }
}

impl Runtime {
    /// Traces the lines that begin in these ranges of operations, in place of those traced so far; none: no trace.
    /// Any module can be traced, MODULE_FAST and MODULE_CONT too. What the program does, and its state, stay the
    /// same. Memory is asked for here, and no more while the program runs. Gives the number of lines.
    pub fn set_trace(&mut self, lines: &[Range<Pc>]) -> usize {
        self.trace = Trace::new(&self.program, &self.code, lines);
        self.traced_lines()
    }

    /// Number of traced lines.
    pub fn traced_lines(&self) -> usize {
        self.trace.as_ref().map_or(0, |trace| trace.lines.len())
    }

    /// The traced lines in the order of the program, best read when a 20 ms cycle is complete. A start of the PLC
    /// forgets what was seen before.
    pub fn trace(&self) -> impl Iterator<Item = TraceEntry> + '_ {
        let in_progress = self.position.is_some() || self.fault.is_some();
        let now = self.millis().saturating_sub(u64::from(!in_progress)) / 20;
        self.trace.iter().flat_map(move |trace| {
            let entry = move |line: &Range<Pc>| TraceEntry {
                pc: line.start,
                last: trace.values(&self.program, line, now),
            };
            trace.lines.iter().map(entry)
        })
    }
}
