//! Threads, stack frames, scopes, the exception.

use dap::requests::{ScopesArguments, StackTraceArguments};
use dap::responses::{ExceptionInfoResponse, ScopesResponse, StackTraceResponse, ThreadsResponse};
use dap::types::{
    ExceptionBreakMode, ExceptionDetails, Scope, ScopePresentationhint, StackFrame,
    StackFramePresentationhint, Thread,
};

use technol_image::op::Pc;
use technol_image::program::{ModuleKind, SequenceKind};
use technol_wire::message::{Fault, FaultKind, Frame, Request as Ask, Response, SequenceState};

use crate::errors::RequestError;
use crate::mechanisms;
use crate::request::Request;
use crate::tree::Node;

use super::phase::Phase;
use super::{Answer, Debuggee, Session, Stop, body, sources};

/// The thread that stands for the modules.
pub(super) const PLC_THREAD: i64 = 1;
/// Thread of sequence 0.
const FIRST_SEQUENCE: i64 = 2;
/// Frame number of sequence 0 when it is not the one that is stopped.
const FIRST_MECHANISM_FRAME: i64 = 1_000_000;

/// The thread of a sequence, or of the modules.
pub(super) fn thread_of_sequence(sequence: Option<u16>) -> i64 {
    sequence.map_or(PLC_THREAD, |n| FIRST_SEQUENCE + i64::from(n))
}

/// The sequence of a thread, `None` for that of the modules; an error when there is no such thread.
pub(super) fn sequence_of_thread(debuggee: &Debuggee, id: i64) -> Result<Option<u16>, RequestError> {
    if id == PLC_THREAD {
        return Ok(None);
    }
    let sequence = id.checked_sub(FIRST_SEQUENCE).and_then(|n| u16::try_from(n).ok());
    let known = sequence.filter(|n| usize::from(*n) < debuggee.program.sequences.len());
    known.map(Some).ok_or(RequestError::Stale { what: "thread", id })
}

/// A frame before it is told to the client.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FrameInfo {
    id: i64,
    name: String,
    /// File and 1-based line.
    position: Option<(u16, u32)>,
    /// File whose local data it sees, by execution order.
    pub(super) order: Option<u8>,
    /// Registers belong to it.
    executing: bool,
    subtle: bool,
}

impl Session {
    pub(super) fn threads(&mut self, _request: &Request) -> Answer {
        let sequences = match self.sequences() {
            Err(RequestError::Refused(_)) => Vec::new(), // the cycle is there in any case
            result => result?,
        };
        let debuggee = self.debuggee()?;
        let stopped = debuggee.stop.as_ref().and_then(|s| s.stopped.sequence);
        let mut threads = vec![Thread { id: PLC_THREAD, name: "PLC cycle".into() }];
        for mechanism in &debuggee.debug.mechanisms {
            let now = sequences.iter().find(|s| s.sequence == mechanism.sequence);
            if now.is_some_and(|s| s.active) || stopped == Some(mechanism.sequence) {
                // VS Code keeps the names for as long as the program runs; its live view has the states.
                let keeps = self.client.menus && self.phase == Phase::Running;
                let name =
                    if keeps { mechanism.name.clone() } else { mechanisms::thread_name(mechanism, now) };
                threads.push(Thread { id: thread_of_sequence(Some(mechanism.sequence)), name });
            }
        }
        body(&ThreadsResponse { threads })
    }

    /// State of all sequences; asked once per stop.
    pub(super) fn sequences(&mut self) -> Result<Vec<SequenceState>, RequestError> {
        if let Some(told) = self.glance_at_mechanisms() {
            return Ok(told);
        }
        let (target, debuggee) = self.parts()?;
        if let Some(Stop { sequences: Some(known), .. }) = &debuggee.stop {
            return Ok(known.clone());
        }
        let Response::Sequences(states) = target.ask(Ask::Sequences)? else {
            return Err(RequestError::Refused("it did not tell the state of the mechanisms".into()));
        };
        if let Some(stop) = &mut debuggee.stop {
            stop.sequences = Some(states.clone());
        }
        Ok(states)
    }

    pub(super) fn stack_trace(&mut self, request: &Request) -> Answer {
        let arguments: StackTraceArguments = request.parse()?;
        let id = arguments.thread_id;
        let sequence = sequence_of_thread(self.debuggee()?, id)?;
        let sequences = self.sequences()?;
        let (debuggee, stop) = self.stop(request)?;
        let frames = frames_of_thread(debuggee, stop, &sequences, sequence)
            .ok_or(RequestError::Stale { what: "thread", id })?;
        let total = frames.len();
        let start = usize::try_from(arguments.start_frame.unwrap_or(0)).unwrap_or(0).min(total);
        let levels =
            arguments.levels.and_then(|n| usize::try_from(n).ok()).filter(|n| *n > 0).unwrap_or(total);
        let shown = frames.into_iter().skip(start).take(levels).map(|f| self.shown_frame(debuggee, f));
        body(&StackTraceResponse { stack_frames: shown.collect(), total_frames: Some(total as i64) })
    }

    fn shown_frame(&self, debuggee: &Debuggee, frame: FrameInfo) -> StackFrame {
        let source = frame.position.and_then(|(file, _)| debuggee.map.path(file)).map(sources::source);
        let place =
            frame.position.map_or((0, 0), |(_, line)| (self.line_out(line), self.client.first_column));
        let subtle = frame.subtle || source.is_none();
        StackFrame {
            id: frame.id,
            name: frame.name,
            line: place.0,
            column: place.1,
            source,
            presentation_hint: subtle.then_some(StackFramePresentationhint::Subtle),
            ..StackFrame::default()
        }
    }

    /// The frame of that number, as long as the program stands where it stood.
    pub(super) fn frame(&mut self, request: &Request, id: i64) -> Result<FrameInfo, RequestError> {
        let stale = || RequestError::Stale { what: "stack frame", id };
        if id >= FIRST_MECHANISM_FRAME {
            let sequence = u16::try_from(id - FIRST_MECHANISM_FRAME).map_err(|_| stale())?;
            let sequences = self.sequences()?;
            let (debuggee, _) = self.stop(request)?;
            return mechanism_frame(debuggee, &sequences, sequence).ok_or_else(stale);
        }
        let (debuggee, stop) = self.stop(request)?;
        executing_frames(debuggee, stop).into_iter().find(|f| f.id == id).ok_or_else(stale)
    }

    pub(super) fn scopes(&mut self, request: &Request) -> Answer {
        let arguments: ScopesArguments = request.parse()?;
        let frame = self.frame(request, arguments.frame_id)?;
        let (_, debuggee) = self.parts()?;
        let mut nodes = Vec::new();
        if frame.executing {
            nodes.push(("Registers".to_owned(), Node::Registers));
        }
        let mut locals: Vec<(u8, &str)> =
            debuggee.debug.files.iter().filter_map(|f| Some((f.order?, f.path.as_str()))).collect();
        // The local data of the file one is in come first, the others after the global ones.
        locals.sort_by_key(|(order, _)| *order);
        let scope = |(order, path): &(u8, &str)| (format!("Local to {path}"), Node::Locals(*order));
        nodes.extend(locals.iter().filter(|(o, _)| Some(*o) == frame.order).map(scope));
        nodes.push(("Variables".into(), Node::Globals));
        nodes.push(("Mechanisms".into(), Node::Mechanisms));
        nodes.push(("Inputs".into(), Node::Inputs));
        nodes.push(("Outputs".into(), Node::Outputs));
        nodes.push(("Control interface".into(), Node::Control));
        nodes.extend(locals.iter().filter(|(o, _)| Some(*o) != frame.order).map(scope));
        let tree = &mut debuggee.tree;
        let mut scopes = Vec::new();
        for (name, node) in nodes.into_iter().filter(|(_, node)| !tree.is_empty(*node)).collect::<Vec<_>>() {
            scopes.push(Scope {
                name,
                presentation_hint: match node {
                    Node::Registers => Some(ScopePresentationhint::Registers),
                    Node::Locals(_) => Some(ScopePresentationhint::Locals),
                    _ => None,
                },
                variables_reference: tree.handle(node),
                named_variables: Some(tree.len(node) as i64),
                expensive: false,
                ..Scope::default()
            });
        }
        body(&ScopesResponse { scopes })
    }

    pub(super) fn exception_info(&mut self, request: &Request) -> Answer {
        let (debuggee, _) = self.stop(request)?;
        let Some(fault) = &debuggee.fault else {
            return Err(RequestError::Expression("the program did not stop because of a fault".into()));
        };
        let text = fault_text(debuggee, fault);
        body(&ExceptionInfoResponse {
            exception_id: fault_name(fault.kind).into(),
            description: Some(text.clone()),
            break_mode: ExceptionBreakMode::Always,
            details: Some(ExceptionDetails {
                message: Some(text),
                type_name: Some(fault_name(fault.kind).into()),
                ..ExceptionDetails::default()
            }),
        })
    }
}

/// Frames of the thread of a sequence, or of the modules; `None` when there is no such sequence.
fn frames_of_thread(
    debuggee: &Debuggee,
    stop: &Stop,
    sequences: &[SequenceState],
    sequence: Option<u16>,
) -> Option<Vec<FrameInfo>> {
    let executing = || executing_frames(debuggee, stop);
    match sequence {
        _ if sequence == stop.stopped.sequence => Some(executing()),
        Some(n) => mechanism_frame(debuggee, sequences, n).map(|f| vec![f]),
        // The modules wait below the mechanism that is held.
        None => Some(executing().into_iter().rev().take(1).collect()),
    }
}

/// What is being executed, innermost first, with the module at the bottom.
fn executing_frames(debuggee: &Debuggee, stop: &Stop) -> Vec<FrameInfo> {
    let mut frames: Vec<FrameInfo> = stop
        .stopped
        .frames
        .iter()
        .zip(1_i64..)
        .map(|(frame, id)| FrameInfo {
            id,
            name: frame_name(debuggee, frame),
            position: position(debuggee, frame.pc),
            order: order(debuggee, frame.pc),
            executing: true,
            subtle: false,
        })
        .collect();
    let outermost = stop.stopped.frames.last().and_then(|f| f.sequence);
    let sequence = outermost.and_then(|n| debuggee.program.sequences.get(usize::from(n)));
    if let Some(sequence) = sequence.filter(|s| s.kind == SequenceKind::Mechanism) {
        frames.push(FrameInfo {
            id: frames.len() as i64 + 1,
            name: module_name(stop.stopped.module),
            position: position(debuggee, sequence.start),
            order: order(debuggee, sequence.start),
            executing: true,
            subtle: true,
        });
    }
    frames
}

/// Where a mechanism stands that is not the one being executed.
fn mechanism_frame(debuggee: &Debuggee, sequences: &[SequenceState], sequence: u16) -> Option<FrameInfo> {
    let mechanism = debuggee.debug.mechanisms.iter().find(|m| m.sequence == sequence)?;
    let now = sequences.iter().find(|s| s.sequence == sequence);
    let start = debuggee.program.sequences.get(usize::from(sequence))?.start;
    Some(FrameInfo {
        id: FIRST_MECHANISM_FRAME + i64::from(sequence),
        name: mechanism.name.clone(),
        position: Some((mechanism.file, now.map_or(mechanism.lines.0, |s| mechanisms::line(mechanism, s)))),
        order: order(debuggee, start),
        executing: false,
        subtle: false,
    })
}

fn frame_name(debuggee: &Debuggee, frame: &Frame) -> String {
    let procedure = frame.procedure.and_then(|n| debuggee.program.procedures.get(usize::from(n)));
    if let Some(procedure) = procedure {
        return procedure.name.clone();
    }
    let mechanism = frame.sequence.and_then(|n| debuggee.debug.mechanisms.iter().find(|m| m.sequence == n));
    mechanism.map_or_else(|| module_name(frame.module), |m| m.name.clone())
}

fn module_name(index: u8) -> String {
    ModuleKind::from_number(index).map_or("module", |kind| kind.keyword()).to_owned()
}

/// File and 1-based line.
pub(super) fn position(debuggee: &Debuggee, pc: Pc) -> Option<(u16, u32)> {
    debuggee.debug.line_at(pc).map(|l| (l.file, l.line))
}

/// The file whose local data an operation sees.
fn order(debuggee: &Debuggee, pc: Pc) -> Option<u8> {
    let module = debuggee.program.modules.iter().find(|m| (m.start..m.end).contains(&pc));
    let from_line = || debuggee.debug.files.get(usize::from(debuggee.debug.line_at(pc)?.file))?.order;
    module.map(|m| m.file).or_else(from_line)
}

/// `motion.plc:42`, as people say it.
fn place_text(debuggee: &Debuggee, pc: Pc) -> String {
    debuggee
        .debug
        .position(pc)
        .map_or_else(|| format!("operation {pc}"), |(file, line)| format!("{file}:{line}"))
}

pub(super) fn fault_text(debuggee: &Debuggee, fault: &Fault) -> String {
    let mechanism = fault.sequence.and_then(|n| debuggee.debug.mechanisms.iter().find(|m| m.sequence == n));
    let inside = mechanism.map_or_else(|| module_name(fault.module), |m| m.name.clone());
    let place = place_text(debuggee, fault.pc);
    format!("{} at {place} in {inside}, cycle {}", fault_name(fault.kind), fault.cycle)
}

pub(super) fn fault_name(kind: FaultKind) -> &'static str {
    match kind {
        FaultKind::DivisionByZero => "division by zero",
        FaultKind::QuotientOverflow => "the quotient does not fit",
        FaultKind::BcdRange => "BCD value out of range",
        FaultKind::StackOverflow => "more than eight values on the equation stack",
        FaultKind::StackUnderflow => "nothing left on the equation stack",
        FaultKind::BadAddress => "indexed address outside PLC memory",
        FaultKind::EndlessLoop => "endless loop: the pass did not end",
        FaultKind::CallDepth => "procedures are nested too deeply",
        FaultKind::UnexpectedReturn => "end of a procedure that was not called",
        FaultKind::UnexpectedEnd => "end of a module inside a procedure",
        FaultKind::NoService => "the control of the target does not carry out this instruction",
        FaultKind::BadContinuation => "the continuation of a mechanism was overwritten",
    }
}
