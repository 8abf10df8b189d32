//! Procedures and messages (manual 3.17, 14.1).

use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Source, Width};

use crate::code::Code;
use crate::context::{Call, Context, MAX_CALLS, Root};
use crate::event::RuntimeEvent;
use crate::execute::{Machine, Step};
use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::operands;
use crate::registers::Registers;

/// PROC_CALL. With `saved` the caller gets these registers back at the return.
pub(crate) fn call(
    program: &Program,
    ctx: &mut Context,
    procedure: u16,
    saved: Option<Registers>,
) -> Result<Step, FaultKind> {
    if ctx.calls.len() >= MAX_CALLS {
        return Err(FaultKind::CallDepth);
    }
    ctx.calls.push(Call { ret: ctx.pc + 1, saved });
    Ok(Step::Goto(program.procedures[usize::from(procedure)].start))
}

/// PROC_END.
pub(crate) fn return_from(ctx: &mut Context) -> Result<Step, FaultKind> {
    match ctx.calls.pop() {
        Some(call) => {
            if let Some(registers) = call.saved {
                ctx.regs = registers;
            }
            Ok(Step::Goto(call.ret))
        }
        None if ctx.root == Root::Procedure => Ok(Step::End),
        None => Err(FaultKind::UnexpectedReturn),
    }
}

/// ESET: reports the message, then calls `_ON_ESET` with the number in DR, if the program has it. A message
/// from within `_ON_ESET` is reported only.
pub(crate) fn message(
    program: &Program,
    code: &Code,
    machine: &mut Machine,
    ctx: &mut Context,
    index: u16,
    events: &mut Vec<RuntimeEvent>,
) -> Result<Step, FaultKind> {
    let message = &program.messages[usize::from(index)];
    let memory = &machine.memory;
    let regs = &ctx.regs;
    let number = match &message.number {
        Some((source, width)) => operands::unsigned(memory, source, *width, regs.bx)? as u32,
        None => u32::from(regs.dr as u16),
    };
    let sub_id = optional(memory, message.sub_id.as_ref(), regs.bx)?;
    let mut parameters = [None; 3];
    for (value, parameter) in parameters.iter_mut().zip(&message.parameters) {
        *value = optional(memory, parameter.as_ref(), regs.bx)?;
    }
    let nested = ctx.calls.iter().any(|call| call.saved.is_some());
    let handler = code.on_eset.filter(|_| !nested);
    if handler.is_some() && ctx.calls.len() >= MAX_CALLS {
        return Err(FaultKind::CallDepth);
    }
    let cycle = machine.cycle();
    events.push(RuntimeEvent::Message { cycle, number, sub_id, set: message.set, parameters, pc: ctx.pc });
    let Some(procedure) = handler else { return Ok(Step::Next) };
    let saved = ctx.regs;
    ctx.regs.dr = i64::from(number);
    ctx.regs.close_equation();
    call(program, ctx, procedure, Some(saved))
}

fn optional(memory: &Memory, value: Option<&(Source, Width)>, bx: u32) -> Result<Option<i64>, FaultKind> {
    value.map(|(source, width)| operands::integer(memory, source, *width, bx)).transpose()
}
