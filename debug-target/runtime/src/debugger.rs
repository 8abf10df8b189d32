//! Break-points, stepping and what a debugger sees of a held program.

use alloc::vec::Vec;
use core::fmt;

use technol_image::Program;
use technol_image::op::Pc;
use technol_image::program::ModuleKind;

use crate::code::{Code, is_stoppable, module_of, procedure_of};
use crate::context::{Context, Root};
use crate::execute::Machine;
use crate::sequence::activation;

/// Why a break-point cannot be set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BreakpointError {
    /// No statement starts at this operation.
    NotAStatement,
    /// MODULE_FAST, MODULE_CYCLICOPERATION and MODULE_FASTEST take no break-points.
    InFast,
    /// MODULE_CONT never stops.
    InCont,
}

impl fmt::Display for BreakpointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BreakpointError::NotAStatement => "no instruction starts here; choose a line with code",
            BreakpointError::InFast => "a module of the 1 ms raster takes no break-points; use a trace",
            BreakpointError::InCont => "MODULE_CONT is never stopped; choose another module",
        })
    }
}

impl core::error::Error for BreakpointError {}

/// How a held program goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resume {
    /// To the next break-point.
    Continue,
    /// To the next statement, wherever it is.
    StepInto,
    /// To the next statement at the same or a lower call depth; with a sequence: of that sequence, in a later
    /// cycle if it waits, or the next statement after it once it is not active.
    StepOver {
        /// Sequence to stay in.
        sequence: Option<u16>,
    },
    /// Out of the procedure, else of the sequence, else of the module.
    StepOut,
}

/// Why the program is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// At a break-point.
    Breakpoint,
    /// A step is done.
    Step,
    /// [`pause`](crate::Runtime::pause).
    Pause,
    /// First statement after a start, see [`stop_at_entry`](crate::Runtime::stop_at_entry).
    Entry,
    /// A run-time fault.
    Fault,
}

/// One level of the call stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Operation executed next (innermost) or the call in progress.
    pub pc: Pc,
    /// Procedure this level is in.
    pub procedure: Option<u16>,
    /// Sequence on whose behalf all levels are executed.
    pub sequence: Option<u16>,
    /// Module on whose behalf all levels are executed.
    pub module: ModuleKind,
}

/// Where and why the program is held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// Why.
    pub reason: StopReason,
    /// Operation executed next; the faulting one after a fault.
    pub pc: Pc,
    /// Module.
    pub module: ModuleKind,
    /// File of the module, 0-based in execution order.
    pub file: u8,
    /// Sequence.
    pub sequence: Option<u16>,
    /// Innermost level first.
    pub call_stack: Vec<Frame>,
}

/// One of the lines of execution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// The 20 ms modules.
    Main,
    /// MODULE_CYCLICOPERATION, MODULE_FAST and MODULE_FASTEST.
    Fast,
    /// MODULE_CONT.
    Cont,
}

impl Line {
    pub(crate) const fn of(kind: ModuleKind) -> Line {
        match kind {
            kind if kind.is_fast() => Line::Fast,
            ModuleKind::Cont => Line::Cont,
            _ => Line::Main,
        }
    }
}

/// What the debugger asked for.
#[derive(Clone, Debug)]
pub(crate) struct Debugger {
    /// Ascending.
    pub(crate) breakpoints: Vec<Pc>,
    pub(crate) pause: Option<StopReason>,
    pub(crate) step: Option<StepUntil>,
    pub(crate) stop: Option<StopReason>,
    /// Whose registers and calls are shown.
    pub(crate) focus: Line,
    /// Milliseconds held.
    pub(crate) held_millis: u64,
    /// Never through the fused equations.
    pub(crate) line_by_line: bool,
}

/// A step in progress and where it began.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepUntil {
    how: Resume,
    depth: usize,
    activation: u64,
    sequence: Option<u16>,
}

impl StepUntil {
    /// A step from where `ctx` is.
    pub(crate) fn from(how: Resume, code: &Code, ctx: &Context) -> StepUntil {
        StepUntil {
            how,
            depth: ctx.calls.len(),
            activation: ctx.activation,
            sequence: code.sequence_of(ctx.outermost()),
        }
    }

    fn is_over(&self, program: &Program, code: &Code, machine: &Machine, ctx: &Context) -> bool {
        let depth = ctx.calls.len();
        let sequence = code.sequence_of(ctx.outermost());
        let same_pass = ctx.activation == self.activation;
        match self.how {
            Resume::Continue => false,
            Resume::StepInto => true,
            Resume::StepOver { sequence: None } => depth <= self.depth,
            Resume::StepOver { sequence: Some(number) } if sequence == Some(number) => {
                depth <= self.depth && !continues_at_begin(program, machine, number, ctx.pc)
            }
            Resume::StepOver { sequence: Some(number) } => {
                program.sequences.get(usize::from(number)).is_none_or(|s| !machine.memory.flag(activation(s)))
            }
            Resume::StepOut if !same_pass => true,
            Resume::StepOut if self.depth > 0 => depth < self.depth,
            Resume::StepOut => self.sequence.is_some() && sequence != self.sequence,
        }
    }
}

/// `pc` is the MECH_BEGIN of a sequence that goes on behind one of its EX-type instructions: it only jumps there, so
/// somebody who steps through the mechanism does not want to see it in each cycle.
fn continues_at_begin(program: &Program, machine: &Machine, number: u16, pc: Pc) -> bool {
    program.sequences.get(usize::from(number)).is_some_and(|s| {
        pc == s.start && machine.memory.flag(activation(s)) && machine.memory.word(s.resume_cell) != 0
    })
}

impl Debugger {
    pub(crate) fn new() -> Debugger {
        Debugger {
            breakpoints: Vec::new(),
            pause: None,
            step: None,
            stop: None,
            focus: Line::Main,
            held_millis: 0,
            line_by_line: false,
        }
    }

    /// Statements must be looked at one by one; the debugger may stop there when `stoppable`.
    pub(crate) fn is_watching(&self, stoppable: bool) -> bool {
        self.line_by_line || stoppable && (self.pause.is_some() || self.step.is_some())
    }

    /// Whether to hold before the statement at `ctx.pc`.
    pub(crate) fn reason_to_stop(
        &self,
        program: &Program,
        code: &Code,
        machine: &Machine,
        ctx: &Context,
    ) -> Option<StopReason> {
        if self.breakpoints.binary_search(&ctx.pc).is_ok() {
            return Some(StopReason::Breakpoint);
        }
        let step = || self.step.filter(|step| step.is_over(program, code, machine, ctx));
        self.pause.or_else(|| step().map(|_| StopReason::Step))
    }

    /// The program is held from now on.
    pub(crate) fn hold(&mut self, reason: StopReason, focus: Line) {
        self.stop = Some(reason);
        self.focus = focus;
        self.pause = None;
        self.step = None;
        self.held_millis = 0;
    }
}

/// Whether a break-point may lie at `pc`.
pub(crate) fn check_breakpoint(program: &Program, pc: Pc) -> Result<(), BreakpointError> {
    if program.statements.binary_search(&pc).is_err() {
        return Err(BreakpointError::NotAStatement);
    }
    match module_of(program, pc).map(|m| program.modules[m].kind) {
        Some(ModuleKind::Cont) => Err(BreakpointError::InCont),
        Some(kind) if !is_stoppable(kind) => Err(BreakpointError::InFast),
        _ => Ok(()),
    }
}

/// Module and file on whose behalf `ctx` runs.
pub(crate) fn module_and_file(program: &Program, ctx: &Context) -> (ModuleKind, u8) {
    match ctx.root {
        Root::Module(index) => program.modules.get(index).map_or((ModuleKind::Main, 0), |m| (m.kind, m.file)),
        Root::Procedure => (ModuleKind::Main, 0),
    }
}

/// Levels of `ctx`, innermost first.
pub(crate) fn call_stack(program: &Program, code: &Code, ctx: &Context) -> Vec<Frame> {
    let sequence = code.sequence_of(ctx.outermost());
    let (module, _) = module_and_file(program, ctx);
    let callers = ctx.calls.iter().rev().map(|call| call.ret.saturating_sub(1));
    core::iter::once(ctx.pc)
        .chain(callers)
        .map(|pc| Frame { pc, procedure: procedure_of(program, pc), sequence, module })
        .collect()
}
