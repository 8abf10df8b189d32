//! Sequences: mechanisms and block modules (manual 4; rulings on continuation and time).
//!
//! A sequence has three cells. *Continuation*: the EX-type instruction it goes on after; 0 is its start.
//! *Wait*: the EX-type instruction that made it wait; a TEX or TIM whose number is not there starts its
//! counter anew. *Line*: the source line of the EX-type instruction executed last.

use technol_image::Program;
use technol_image::op::{BitRef, Op, Source};
use technol_image::program::{Sequence, Timed};

use crate::code::Code;
use crate::context::{Context, NO_SEQUENCE};
use crate::execute::{Machine, Step};
use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::operands;
use crate::registers::mask;

/// What a debugger shows of a sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SequenceState {
    /// Number of the sequence.
    pub sequence: u16,
    /// Its activation bit.
    pub active: bool,
    /// EX-type instruction it continues after; 0 is the start.
    pub resume: u16,
    /// EX-type instruction it waits at.
    pub waiting: Option<u16>,
    /// Source line of its state, 0 when not active.
    pub line: u16,
    /// 20 ms cycles since it began to wait there.
    pub cycles_in_state: u64,
}

/// Activation bit of a sequence.
pub(crate) fn activation(sequence: &Sequence) -> BitRef {
    BitRef { addr: sequence.active_addr, bit: sequence.active_bit, indexed: false }
}

/// State of sequence `number`.
pub(crate) fn state(program: &Program, machine: &Machine, number: u16) -> SequenceState {
    let sequence = &program.sequences[usize::from(number)];
    let memory = &machine.memory;
    let waiting = memory.word(sequence.wait_cell);
    SequenceState {
        sequence: number,
        active: memory.flag(activation(sequence)),
        resume: memory.word(sequence.resume_cell),
        waiting: (waiting != 0).then_some(waiting),
        line: memory.word(sequence.line_cell),
        cycles_in_state: machine.cycle().saturating_sub(machine.state_since[usize::from(number)]),
    }
}

/// MECH_INIT, and what reaching MECH_END does: into rest.
pub(crate) fn rest(program: &Program, machine: &mut Machine, number: u16) {
    let sequence = &program.sequences[usize::from(number)];
    machine.memory.set_flag(activation(sequence), false);
    machine.memory.set_word(sequence.resume_cell, 0);
    machine.memory.set_word(sequence.wait_cell, 0);
    set_line(machine, sequence, number, 0);
}

fn set_line(machine: &mut Machine, sequence: &Sequence, number: u16, line: u16) {
    if machine.memory.word(sequence.line_cell) != line {
        machine.memory.set_word(sequence.line_cell, line);
        machine.state_since[usize::from(number)] = machine.cycle();
    }
}

/// Executes the operations of sequences at `ctx.pc`.
pub(crate) fn execute(
    program: &Program,
    code: &Code,
    machine: &mut Machine,
    ctx: &mut Context,
) -> Result<Step, FaultKind> {
    match program.code[ctx.pc as usize] {
        Op::SeqBegin(number) => begin(program, machine, ctx, number),
        Op::SeqEnd(number) => {
            rest(program, machine, number);
            Ok(Step::Next)
        }
        Op::SeqInit(number) => {
            rest(program, machine, number);
            if code.sequence_of(ctx.outermost()) == Some(number) {
                ctx.rewound = number;
            }
            Ok(Step::Next)
        }
        ref op => match code.sequence_of(ctx.pc) {
            Some(number) => Here::new(program, machine, ctx, number).execute(op, &program.timed),
            // Validation leaves no EX-type instruction outside a sequence.
            None => Ok(Step::Next),
        },
    }
}

/// MECH_BEGIN: to the continuation, or past the end of an inactive sequence.
fn begin(
    program: &Program,
    machine: &mut Machine,
    ctx: &mut Context,
    number: u16,
) -> Result<Step, FaultKind> {
    let sequence = &program.sequences[usize::from(number)];
    ctx.rewound = NO_SEQUENCE;
    if !machine.memory.flag(activation(sequence)) {
        set_line(machine, sequence, number, 0);
        return Ok(Step::Goto(sequence.end + 1));
    }
    let point = machine.memory.word(sequence.resume_cell);
    if point != 0 {
        let target = sequence.resume.get(usize::from(point) - 1);
        return target
            .map(|pc| Step::Goto(*pc))
            .ok_or(FaultKind::BadContinuation { sequence: number, point });
    }
    if machine.memory.word(sequence.line_cell) == 0 {
        set_line(machine, sequence, number, sequence.line);
    }
    Ok(Step::Next)
}

/// An EX-type instruction in its sequence.
struct Here<'a> {
    sequence: &'a Sequence,
    number: u16,
    machine: &'a mut Machine,
    ctx: &'a mut Context,
    /// The sequence executed MECH_INIT on itself in this pass: it stays rewound.
    rewound: bool,
}

impl<'a> Here<'a> {
    fn new(program: &'a Program, machine: &'a mut Machine, ctx: &'a mut Context, number: u16) -> Here<'a> {
        let rewound = ctx.rewound == number;
        Here { sequence: &program.sequences[usize::from(number)], number, machine, ctx, rewound }
    }

    fn execute(&mut self, op: &Op, timed: &[Timed]) -> Result<Step, FaultKind> {
        match *op {
            Op::Ex { point, line } => {
                self.pass(point, line);
                Ok(self.wait(point, line))
            }
            Op::ExIf { wait_when, point, line } if self.ctx.regs.rlo == wait_when => {
                Ok(self.wait(point, line))
            }
            Op::ExIf { point, line, .. } | Op::Bex { point, line } => Ok(self.pass(point, line)),
            Op::Timed(index) => self.timed(&timed[usize::from(index)]),
            _ => Ok(Step::Next),
        }
    }

    /// TEX0, TEX1, TIM: waits `time` passes, then TEX jumps and TIM passes.
    fn timed(&mut self, timed: &Timed) -> Result<Step, FaultKind> {
        let Timed { width, point, line, .. } = *timed;
        let bx = self.ctx.regs.bx;
        let memory = &self.machine.memory;
        let limit = time(memory, timed, bx)?;
        let code = match &timed.code {
            Some((source, width)) => Some(operands::integer(memory, source, *width, bx)?),
            None => None,
        };
        let at = memory.resolve(timed.count.addr, timed.count.indexed, bx, width.bytes())?;
        let entered = self.rewound || memory.word(self.sequence.wait_cell) != point;
        let count = if entered { 0 } else { memory.read_at(at, width) & mask(width) };
        let holds = timed.wait_when.is_none_or(|value| value == self.ctx.regs.rlo);
        if holds && count < limit {
            self.machine.memory.write_at(at, width, count + 1);
            return Ok(self.wait(point, line));
        }
        self.machine.memory.write_at(at, width, 0);
        match timed.error {
            Some(target) if holds => {
                if !self.rewound {
                    self.machine.memory.set_word(self.sequence.wait_cell, 0);
                    set_line(self.machine, self.sequence, self.number, line);
                }
                self.ctx.regs.dr = code.unwrap_or(self.ctx.regs.dr);
                Ok(Step::Goto(target))
            }
            _ => Ok(self.pass(point, line)),
        }
    }

    fn wait(&mut self, point: u16, line: u16) -> Step {
        if !self.rewound {
            if self.machine.memory.word(self.sequence.wait_cell) != point {
                // Entered anew: a loop that comes back to the same line starts another stay there.
                self.machine.memory.set_word(self.sequence.wait_cell, point);
                self.machine.state_since[usize::from(self.number)] = self.machine.cycle();
            }
            set_line(self.machine, self.sequence, self.number, line);
        }
        self.ctx.regs.close_equation();
        Step::Goto(self.sequence.end + 1)
    }

    fn pass(&mut self, point: u16, line: u16) -> Step {
        if !self.rewound {
            self.machine.memory.set_word(self.sequence.resume_cell, point);
            self.machine.memory.set_word(self.sequence.wait_cell, 0);
            set_line(self.machine, self.sequence, self.number, line);
        }
        Step::Next
    }
}

/// Limit in passes: a cell is unsigned; a constant beyond the counter's range expires at its end.
fn time(memory: &Memory, timed: &Timed, bx: u32) -> Result<i64, FaultKind> {
    match timed.time {
        Source::Int(value) => Ok(value.clamp(0, mask(timed.width))),
        ref cell => Ok(operands::unsigned(memory, cell, timed.width, bx)? as i64),
    }
}
