//! The runtime as its host sees it: commands, state, memory, debugger.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Addr, BitRef, Pc};
use technol_image::program::{FASTEST_PERIODS, SequenceKind};
use technol_image::system;

use crate::block::{BlockCycle, QUEUE_LEN};
use crate::code::Code;
use crate::context::Context;
use crate::coverage::Coverage;
use crate::debugger::{
    BreakpointError, Debugger, Frame, Line, Resume, StepUntil, Stop, StopReason, call_stack,
    check_breakpoint, module_and_file,
};
use crate::event::{Command, PlcState};
use crate::execute::Machine;
use crate::fault::Fault;
use crate::load_error::LoadError;
use crate::m_functions::{GroupError, Groups};
use crate::memory::{AccessError, Memory};
use crate::plan::{PeriodError, PlanKind, Plans};
use crate::ports::OutputImage;
use crate::registers::Registers;
use crate::sequence::{self, SequenceState};
use crate::state_hash;
use crate::supervisor::PlcEvent;
use crate::trace::Trace;
use crate::validate::validate;

/// Commands that a host may give between two ticks without memory being asked for.
const COMMANDS: usize = 32;

/// What a call of [`Runtime::tick`] came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TickOutcome {
    /// The millisecond is complete.
    Done,
    /// The debugger holds the program, or a fault does, see [`Runtime::stopped`].
    Stopped,
}

/// Bounds on execution, counted in operations because the runtime has no clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// One pass of one module; more is an endless loop and faults.
    pub per_pass: u32,
    /// One 20 ms cycle; more is reported as overrun. `None` reports nothing.
    pub per_cycle: Option<u64>,
    /// One millisecond of MODULE_FAST; more is reported as overrun. `None` reports nothing.
    pub per_fast: Option<u64>,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { per_pass: 2_000_000, per_cycle: None, per_fast: None }
    }
}

/// Place inside a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) plan: PlanKind,
    pub(crate) step: usize,
    /// The pass of this step has begun.
    pub(crate) entered: bool,
}

/// A loaded program with its memory: the PLC. A clone is a snapshot.
#[derive(Clone, Debug)]
pub struct Runtime {
    pub(crate) program: Program,
    pub(crate) code: Code,
    pub(crate) plans: Plans,
    pub(crate) machine: Machine,
    pub(crate) main: Context,
    pub(crate) fast: Context,
    pub(crate) cont: Context,
    /// Where an unfinished tick is.
    pub(crate) position: Option<Position>,
    pub(crate) state: PlcState,
    pub(crate) fault: Option<Fault>,
    pub(crate) commands: VecDeque<Command>,
    /// DR on entry of MODULE_INIT and MODULE_DONE.
    pub(crate) entry_dr: i64,
    pub(crate) block: BlockCycle,
    /// Calls of `_ON_EVENT` and `_ON_CMD` that wait.
    pub(crate) plc_events: VecDeque<PlcEvent>,
    /// Outputs with a short circuit.
    pub(crate) shorted: OutputImage,
    pub(crate) outputs: OutputImage,
    pub(crate) fast_inputs: Vec<usize>,
    pub(crate) fast_outputs: Vec<usize>,
    pub(crate) limits: Limits,
    /// Operations executed in the plan in progress.
    pub(crate) spent: u64,
    pub(crate) debugger: Debugger,
    /// Somebody counts statements.
    pub(crate) coverage: Option<Coverage>,
    /// Somebody looks at the registers.
    pub(crate) trace: Option<Trace>,
}

impl Runtime {
    /// Loads a program. Everything in it is checked here, so that no content can make the runtime panic.
    pub fn new(program: Program) -> Result<Runtime, LoadError> {
        validate(&program)?;
        let machine = Machine {
            memory: Memory::new(program.memory_len()),
            millis: 0,
            init_seen: 0,
            done_seen: 0,
            state_since: alloc::vec![0; program.sequences.len()],
        };
        let mut runtime = Runtime {
            code: Code::new(&program),
            plans: Plans::new(&program, 1),
            machine,
            main: Context::new(),
            fast: Context::new(),
            cont: Context::new(),
            position: None,
            state: PlcState::Stopped,
            fault: None,
            commands: VecDeque::with_capacity(COMMANDS),
            entry_dr: 0,
            block: BlockCycle::new(),
            plc_events: VecDeque::with_capacity(QUEUE_LEN),
            shorted: [0; system::OUT_PORT_COUNT as usize],
            outputs: [0; system::OUT_PORT_COUNT as usize],
            fast_inputs: Vec::new(),
            fast_outputs: Vec::new(),
            limits: Limits::default(),
            spent: 0,
            debugger: Debugger::new(),
            coverage: None,
            trace: None,
            program,
        };
        runtime.initialise_memory();
        Ok(runtime)
    }

    /// The loaded program.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// PLC memory.
    pub fn memory(&self) -> &[u8] {
        self.machine.memory.bytes()
    }

    /// Output ports as driven, after the force masks. All 0 while the PLC is stopped or faulted.
    pub fn outputs(&self) -> &OutputImage {
        &self.outputs
    }

    /// Milliseconds of PLC time: complete ticks since the start of the PLC.
    pub fn millis(&self) -> u64 {
        self.machine.millis
    }

    /// 20 ms cycle that `millis` lies in, counted from 0 at the start of the PLC.
    pub fn cycle(&self) -> u64 {
        self.machine.cycle()
    }

    /// Queues a command for the next tick boundary.
    pub fn command(&mut self, command: Command) {
        self.commands.push_back(command);
    }

    /// State of the PLC.
    pub fn state(&self) -> PlcState {
        self.state
    }

    /// The fault that stopped the PLC; `None` again after the next start.
    pub fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// Sets the bounds on execution; they hold from the next pass on.
    pub fn set_limits(&mut self, limits: Limits) {
        self.limits = limits;
    }

    /// Ports copied each millisecond around MODULE_FAST: indices into the images, 0 is P1IN and P0OUT.
    pub fn set_fast_ports(&mut self, inputs: &[u8], outputs: &[u8]) -> Result<(), AccessError> {
        let check = |ports: &[u8], count: u32| match ports.iter().find(|n| u32::from(**n) >= count) {
            Some(n) => Err(AccessError { addr: Addr::from(*n), len: 1 }),
            None => Ok(ports.iter().map(|n| usize::from(*n)).collect()),
        };
        let inputs = check(inputs, system::IN_PORT_COUNT)?;
        self.fast_outputs = check(outputs, system::OUT_PORT_COUNT)?;
        self.fast_inputs = inputs;
        Ok(())
    }

    /// Microseconds between the passes of MODULE_FASTEST, 1000 unless set: so many passes follow MODULE_FAST in
    /// each millisecond. The fast plan is never held in its middle, so it may be laid out anew at any time.
    pub fn set_fastest_period(&mut self, micros: u16) -> Result<(), PeriodError> {
        if !FASTEST_PERIODS.contains(&micros) {
            return Err(PeriodError { micros });
        }
        self.plans = Plans::new(&self.program, usize::from(1000 / micros));
        Ok(())
    }

    /// Puts M functions into groups, as the element MFunctions of the configuration does: pairs of function and
    /// group. All others are in their fixed group, or in group 14. Holds from the next block on.
    ///
    /// # Errors
    /// The first pair that is out of range or moves a function out of its fixed group; nothing changes then.
    pub fn set_m_groups(&mut self, groups: &[(u8, u8)]) -> Result<(), GroupError> {
        self.block.groups = Groups::with(groups)?;
        Ok(())
    }

    /// M01 stops the program like M00.
    pub fn set_conditional_stop(&mut self, stops: bool) {
        self.block.conditional_stop = stops;
    }

    /// Blocks that wait for their turn, with those that are about to be queued.
    pub fn waiting_blocks(&self) -> usize {
        let coming = self.commands.iter().filter(|command| matches!(command, Command::StartBlock(_)));
        self.block.queue.len() + coming.count()
    }

    /// Outputs that have a short circuit now, one bit each. The control switches a driven one off and reports it in
    /// ERRLI_P0OUT …, until the program clears the bit there (manual 9.3).
    pub fn set_shorted(&mut self, outputs: &OutputImage) {
        self.shorted = *outputs;
    }

    /// Replaces all break-points; one result for each. A break-point holds the program before its statement.
    pub fn set_breakpoints(&mut self, pcs: &[Pc]) -> Vec<Result<(), BreakpointError>> {
        let results: Vec<_> = pcs.iter().map(|pc| check_breakpoint(&self.program, *pc)).collect();
        let accepted = pcs.iter().zip(&results).filter(|(_, result)| result.is_ok()).map(|(pc, _)| *pc);
        let mut breakpoints: Vec<Pc> = accepted.collect();
        breakpoints.sort_unstable();
        breakpoints.dedup();
        self.code.patch(&breakpoints);
        self.debugger.breakpoints = breakpoints;
        results
    }

    /// Executes operation by operation, as a step does, instead of through the fused equations. Slower, and the
    /// same in all it does: made for comparing both.
    pub fn set_line_by_line(&mut self, on: bool) {
        self.debugger.line_by_line = on;
    }

    /// Holds the program at the next statement outside MODULE_FAST and MODULE_CONT.
    pub fn pause(&mut self) {
        if self.debugger.stop.is_none() {
            self.debugger.pause = Some(StopReason::Pause);
        }
    }

    /// Holds the program at the first statement it executes, usually that of MODULE_INIT after a start.
    pub fn stop_at_entry(&mut self) {
        self.debugger.pause = Some(StopReason::Entry);
    }

    /// Lets a held program go on in the next ticks. After a fault the PLC stays faulted.
    pub fn resume(&mut self, how: Resume) {
        let Some(reason) = self.debugger.stop.take() else { return };
        if reason == StopReason::Fault {
            return;
        }
        self.main.skip_stop = true;
        if how != Resume::Continue {
            self.debugger.step = Some(StepUntil::from(how, &self.code, &self.main));
        }
    }

    /// Where and why the program is held.
    pub fn stopped(&self) -> Option<Stop> {
        let reason = self.debugger.stop?;
        let ctx = self.focused();
        let (module, file) = module_and_file(&self.program, ctx);
        let sequence = self.code.sequence_of(ctx.outermost());
        Some(Stop { reason, pc: ctx.pc, module, file, sequence, call_stack: self.call_stack() })
    }

    /// Registers of the held line of execution, else what the 20 ms modules left.
    pub fn registers(&self) -> Registers {
        self.focused().regs
    }

    /// Sets these registers; a stack depth above 8 counts as 8.
    pub fn set_registers(&mut self, registers: Registers) {
        let depth = registers.depth.min(technol_image::op::STACK_DEPTH as u8);
        let eax = registers.eax & !crate::assembler::RLO;
        self.focused_mut().regs = Registers { depth, eax, ..registers };
    }

    /// Call levels of the held program, innermost first; empty while it runs.
    pub fn call_stack(&self) -> Vec<Frame> {
        match self.debugger.stop {
            Some(_) => call_stack(&self.program, &self.code, self.focused()),
            None => Vec::new(),
        }
    }

    /// Writes PLC memory.
    pub fn write_memory(&mut self, addr: Addr, bytes: &[u8]) -> Result<(), AccessError> {
        self.machine.memory.poke(addr, bytes)
    }

    /// Writes one bit of PLC memory.
    pub fn write_bit(&mut self, addr: Addr, bit: u8, value: bool) -> Result<(), AccessError> {
        if bit > 7 || addr as usize >= self.machine.memory.bytes().len() {
            return Err(AccessError { addr, len: 1 });
        }
        self.machine.memory.set_flag(BitRef { addr, bit, indexed: false }, value);
        Ok(())
    }

    /// State of every sequence, by number.
    pub fn sequences(&self) -> impl Iterator<Item = SequenceState> + '_ {
        (0..self.program.sequences.len()).map(|n| sequence::state(&self.program, &self.machine, n as u16))
    }

    /// A number that two runtimes of the same program share when they go on the same way from here: memory, outputs,
    /// registers, sequences, blocks, queues and time are in it. What a debugger has set is not.
    pub fn state_hash(&self) -> u64 {
        state_hash::of(self)
    }

    pub(crate) fn sequence_of_kind(&self, kind: SequenceKind) -> Option<u16> {
        self.program.sequences.iter().position(|s| s.kind == kind).map(|n| n as u16)
    }

    pub(crate) fn context(&mut self, line: Line) -> &mut Context {
        match line {
            Line::Main => &mut self.main,
            Line::Fast => &mut self.fast,
            Line::Cont => &mut self.cont,
        }
    }

    pub(crate) fn line(&self, line: Line) -> &Context {
        match line {
            Line::Main => &self.main,
            Line::Fast => &self.fast,
            Line::Cont => &self.cont,
        }
    }

    fn focused(&self) -> &Context {
        self.line(self.debugger.focus)
    }

    fn focused_mut(&mut self) -> &mut Context {
        self.context(self.debugger.focus)
    }
}
