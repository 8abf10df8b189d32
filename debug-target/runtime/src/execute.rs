//! The execution loops: free running, and watched by the debugger statement by statement.
//!
//! Both execute operations through the same two functions: [`hot`] for what makes up a program (registers
//! stay in locals), [`cold`] for sequences, calls, messages and other rare operations.

use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Cond, Logic, Op, Pc, Width};

use crate::arithmetic;
use crate::assembler;
use crate::calls;
use crate::code::{Code, Fast};
use crate::context::Context;
use crate::control::{Call, Control};
use crate::debugger::StopReason;
use crate::event::RuntimeEvent;
use crate::fault::FaultKind;
use crate::fused;
use crate::memory::Memory;
use crate::operands;
use crate::prepared;
use crate::registers::{Registers, sign_extend};
use crate::sequence;
use crate::texts;
use crate::timing;
use crate::trace::Recorder;

/// What programs read and write besides registers.
#[derive(Clone, Debug)]
pub(crate) struct Machine {
    pub(crate) memory: Memory,
    /// Milliseconds of PLC time since the start of the PLC.
    pub(crate) millis: u64,
    /// Bit n: file n executed MODULE_INIT_FINISHED.
    pub(crate) init_seen: u64,
    /// Bit n: file n executed MODULE_DONE_FINISHED.
    pub(crate) done_seen: u64,
    /// For each sequence the cycle in which its state line changed.
    pub(crate) state_since: Vec<u64>,
}

impl Machine {
    pub(crate) fn cycle(&self) -> u64 {
        self.millis / 20
    }
}

/// What is around a program while it executes.
pub(crate) struct World<'a> {
    pub(crate) control: &'a mut dyn Control,
    pub(crate) events: &'a mut Vec<RuntimeEvent>,
}

/// Why a loop ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// The pass is over.
    End,
    /// The debugger holds before `Context::pc`.
    Stop(StopReason),
    /// The operation at `Context::pc` faulted.
    Fault(FaultKind),
}

/// What follows an operation.
pub(crate) enum Step {
    Next,
    Goto(Pc),
    /// The pass is over.
    End,
    /// Not a hot operation.
    Cold,
}

/// Runs until the pass ends. Break-points stop it when `stoppable`.
pub(crate) fn run(
    program: &Program,
    code: &Code,
    machine: &mut Machine,
    ctx: &mut Context,
    world: &mut World<'_>,
    stoppable: bool,
    recorder: &mut impl Recorder,
) -> Exit {
    let ops = program.code.as_slice();
    let mut pc = ctx.pc;
    let mut regs = ctx.regs;
    let mut budget = ctx.budget;
    let mut skip = ctx.skip_stop;
    ctx.skip_stop = false;
    let exit = loop {
        match code.fast[pc as usize] {
            Fast::Stretch { first, terms, ops, pops } => {
                let len = u32::from(ops);
                if budget >= len
                    && (pops..=fused::MOST_PUSHED).contains(&regs.depth)
                    && let Some(window) = machine.memory.window()
                {
                    budget -= len;
                    let first = first as usize;
                    let terms = &code.terms[first..first + usize::from(terms)];
                    budget += recorder.stretch(first, terms, code, window, &mut regs);
                    pc += len;
                    skip = false;
                    continue;
                }
            }
            Fast::Jump { target, cond } if budget > 0 => {
                budget -= 1;
                recorder.operation(pc, &regs);
                pc = if holds(cond, regs.rlo) { target } else { pc + 1 };
                skip = false;
                continue;
            }
            Fast::Break if stoppable && !skip => break Exit::Stop(StopReason::Breakpoint),
            Fast::Break | Fast::General | Fast::Jump { .. } => {}
        }
        skip = false;
        let cost = cost(&ops[pc as usize]);
        if budget < cost {
            break Exit::Fault(FaultKind::EndlessLoop);
        }
        budget -= cost;
        let step = match hot(&ops[pc as usize], &mut regs, &mut machine.memory) {
            Ok(Step::Cold) => {
                ctx.pc = pc;
                ctx.regs = regs;
                let step = cold(program, code, machine, ctx, world);
                regs = ctx.regs;
                step
            }
            other => other,
        };
        if step.is_ok() {
            recorder.operation(pc, &regs);
        }
        match step {
            Ok(Step::Next | Step::Cold) => pc += 1,
            Ok(Step::Goto(target)) => pc = target,
            Ok(Step::End) => break Exit::End,
            Err(fault) => break Exit::Fault(fault),
        }
    };
    ctx.pc = pc;
    ctx.regs = regs;
    ctx.budget = budget;
    exit
}

/// As [`run`], but asks `watch` before every statement whether to stop there.
pub(crate) fn run_watched(
    program: &Program,
    code: &Code,
    machine: &mut Machine,
    ctx: &mut Context,
    world: &mut World<'_>,
    watch: &dyn Fn(&Machine, &Context) -> Option<StopReason>,
    recorder: &mut impl Recorder,
) -> Exit {
    loop {
        let pc = ctx.pc;
        if code.statement[pc as usize]
            && !ctx.skip_stop
            && let Some(reason) = watch(machine, ctx)
        {
            return Exit::Stop(reason);
        }
        ctx.skip_stop = false;
        let op = &program.code[pc as usize];
        let cost = cost(op);
        if ctx.budget < cost {
            return Exit::Fault(FaultKind::EndlessLoop);
        }
        ctx.budget -= cost;
        let step = match hot(op, &mut ctx.regs, &mut machine.memory) {
            Ok(Step::Cold) => cold(program, code, machine, ctx, world),
            other => other,
        };
        if step.is_ok() {
            recorder.operation(pc, &ctx.regs);
        }
        match step {
            Ok(Step::Next | Step::Cold) => ctx.pc = pc + 1,
            Ok(Step::Goto(target)) => ctx.pc = target,
            Ok(Step::End) => return Exit::End,
            Err(fault) => return Exit::Fault(fault),
        }
    }
}

/// A call takes as long as about so many operations: they copy texts and tables.
const SERVICE_COST: u32 = 20;

/// What an operation takes from the budget: copying costs by length, everything else 1.
#[inline]
fn cost(op: &Op) -> u32 {
    match op {
        Op::Copy { len, .. } | Op::Clear { len, .. } => 1 + len / 16,
        Op::Service(_) => SERVICE_COST,
        _ => 1,
    }
}

#[inline]
fn holds(cond: Cond, rlo: bool) -> bool {
    match cond {
        Cond::Always => true,
        Cond::IfRlo => rlo,
        Cond::IfNotRlo => !rlo,
    }
}

#[inline]
fn combine(op: Logic, a: bool, b: bool) -> bool {
    match op {
        Logic::And => a & b,
        Logic::Or => a | b,
        Logic::Xor => a ^ b,
    }
}

/// Operations on registers and memory. A fault leaves registers and memory as they were.
#[inline(always)]
#[expect(clippy::inline_always, reason = "registers stay in locals of the loop; measured in benches/cycle")]
fn hot(op: &Op, regs: &mut Registers, memory: &mut Memory) -> Result<Step, FaultKind> {
    match op {
        Op::Nop => {}
        Op::Ldr { bit, neg, push } => {
            let value = memory.bit(*bit, regs.bx)? ^ neg;
            if *push {
                regs.push()?;
            }
            regs.rlo = value;
        }
        Op::Logic { op, bit, neg } => {
            regs.rlo = combine(*op, regs.rlo, memory.bit(*bit, regs.bx)? ^ neg);
        }
        Op::LogicPop(op) => regs.rlo = combine(*op, regs.rlo, regs.pop()?),
        Op::Complement => regs.rlo = !regs.rlo,
        Op::Write(bit) => memory.set_bit(*bit, regs.bx, regs.rlo)?,
        Op::Flag { value, bit, cond } => {
            if holds(*cond, regs.rlo) {
                memory.set_bit(*bit, regs.bx, *value)?;
            }
        }
        Op::MoveBit { dst, src, neg, cond } => {
            if holds(*cond, regs.rlo) {
                let value = memory.bit(*src, regs.bx)? ^ neg;
                memory.set_bit(*dst, regs.bx, value)?;
            }
        }
        Op::Jump { target, cond } => {
            if holds(*cond, regs.rlo) {
                return Ok(Step::Goto(*target));
            }
        }
        Op::Load { src, width: Width::Real, neg } => {
            let value = operands::real(memory, src, regs.bx)?;
            regs.set_real(if *neg { -value } else { value });
        }
        Op::Load { src, width, neg } => {
            let value = operands::integer(memory, src, *width, regs.bx)?;
            regs.dr = if *neg { value.wrapping_neg() } else { value };
        }
        Op::Store { dst, width, cond } => {
            if holds(*cond, regs.rlo) {
                let value = match width {
                    Width::Real => regs.dr_real.to_bits() as i64,
                    _ => regs.dr,
                };
                memory.write(*dst, *width, regs.bx, value)?;
            }
        }
        Op::Move { dst, src, width, cond } => {
            if holds(*cond, regs.rlo) {
                let value = memory.read(*src, *width, regs.bx)?;
                memory.write(*dst, *width, regs.bx, value)?;
            }
        }
        Op::Arith { op, src, width: Width::Real } => {
            let operand = operands::real(memory, src, regs.bx)?;
            arithmetic::real(*op, regs, operand)?;
        }
        Op::Arith { op, src, width } => {
            let operand = operands::integer(memory, src, *width, regs.bx)?;
            arithmetic::integer(*op, regs, operand, *width)?;
        }
        Op::Compare { if_rlo: true, .. } if !regs.rlo => {}
        Op::Compare { op, src, width: Width::Real, .. } => {
            let operand = operands::real(memory, src, regs.bx)?;
            regs.rlo = arithmetic::compare_real(*op, regs, operand);
        }
        Op::Compare { op, src, width, .. } => {
            let operand = operands::integer(memory, src, *width, regs.bx)?;
            regs.rlo = arithmetic::compare_integer(*op, regs, operand, *width);
        }
        Op::Unary { op, width } => arithmetic::unary(*op, regs, *width),
        Op::Shift { left, count, width } => {
            let count = operands::shift_count(memory, count, regs.bx)?;
            arithmetic::shift(regs, *left, count, *width);
        }
        Op::DrToRlo(test) => regs.rlo = arithmetic::test(regs, *test),
        Op::RloToDr(width) => regs.set_low(*width, -i64::from(regs.rlo)),
        _ => return Ok(Step::Cold),
    }
    Ok(Step::Next)
}

/// The other operations.
#[inline(never)]
fn cold(
    program: &Program,
    code: &Code,
    machine: &mut Machine,
    ctx: &mut Context,
    world: &mut World<'_>,
) -> Result<Step, FaultKind> {
    let Machine { memory, .. } = machine;
    let regs = &mut ctx.regs;
    match &program.code[ctx.pc as usize] {
        Op::Edge { rising, bit, state } => {
            let now = memory.bit(*bit, regs.bx)?;
            let before = memory.byte(*state);
            let changed = before & 2 != 0 && (before & 1 != 0) != now;
            regs.rlo = changed && now == *rising;
            memory.set_byte(*state, u8::from(now) | 2);
        }
        Op::IncrementBcd => arithmetic::increment_bcd(regs)?,
        Op::BcdToBin(width) => arithmetic::bcd_to_binary(regs, *width)?,
        Op::BinToBcd(width) => arithmetic::binary_to_bcd(regs, *width)?,
        Op::IntToReal(width) => {
            let value = sign_extend(*width, regs.dr);
            regs.dr_real = value as f64;
            regs.dr = value;
        }
        Op::Raster { rate, end } => {
            if !timing::ticks(*rate, machine.millis) {
                return Ok(Step::Goto(*end));
            }
        }
        Op::Timer { count, width } => timing::timer(memory, regs, *count, *width)?,
        Op::Counter { op, count, width, state } => {
            timing::counter(memory, regs, *op, *count, *width, *state)?;
        }
        Op::Copy { src, dst, len } => {
            let from = memory.resolve(src.addr, src.indexed, regs.bx, *len)?;
            let to = memory.resolve(dst.addr, dst.indexed, regs.bx, *len)?;
            memory.copy(from, to, *len as usize);
        }
        Op::Clear { addr, len } => memory.fill(*addr as usize, *len as usize, 0),
        Op::Assembler { function, width, to, from } => {
            assembler::execute(memory, regs, *function, *width, *to, *from)?;
        }
        Op::AssemblerJump { condition, target } => {
            if assembler::holds(regs, *condition) {
                return Ok(Step::Goto(*target));
            }
        }
        Op::IndexFromDr => regs.bx = u32::from(regs.dr as u16),
        Op::SelectBlock { offset, len } => prepared::select(memory, regs.bx, *offset, *len),
        Op::InitFinished(file) => machine.init_seen |= 1 << file,
        Op::DoneFinished(file) => machine.done_seen |= 1 << file,
        Op::Call(procedure) => return calls::call(program, ctx, *procedure, None),
        Op::Return => return calls::return_from(ctx),
        Op::ModuleEnd if ctx.calls.is_empty() => return Ok(Step::End),
        Op::ModuleEnd => return Err(FaultKind::UnexpectedEnd),
        Op::Service(index) => {
            let call = &program.services[usize::from(*index)];
            if call.push {
                regs.push()?;
            }
            let millis = machine.millis;
            let mut call =
                Call { service: call.service, args: &call.args, index: *index, millis, memory, regs };
            match texts::execute(&mut call) {
                Some(done) => done?,
                None => world.control.service(&mut call)?,
            }
        }
        Op::Message { index, cond } => {
            if holds(*cond, regs.rlo) {
                return calls::message(program, code, machine, ctx, *index, world.events);
            }
        }
        _ => return sequence::execute(program, code, machine, ctx),
    }
    Ok(Step::Next)
}
