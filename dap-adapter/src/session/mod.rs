//! One debug session: a loop on a thread of its own that takes turns between the client, the target and timers.
//!
//! Handlers run to completion one after another. They may ask the target and wait for the answer (milliseconds;
//! bounded by the link's own silence detection); what takes longer (build, connect, download) lets a `disconnect`
//! through.

mod breakpoints;
mod evaluate;
mod execution;
mod forcing;
mod inspect;
mod launch;
mod loading;
mod phase;
mod reconnect;
mod repl;
mod sources;
mod stack;
mod target_events;
#[cfg(test)]
mod tests;
mod watching;

use std::collections::{HashSet, VecDeque};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::time::{Duration, Instant};

use dap::events::{Event, OutputEventBody};
use dap::types::OutputEventCategory;
use serde::Serialize;
use serde_json::Value;

use technol_image::debug_info::DebugInfo;
use technol_image::program::Program;
use technol_wire::message::{Fault, PlcState, SequenceState, Stopped};

use crate::arguments::{LaunchArguments, LinkArguments};
use crate::connection::{Connector, TargetSpec};
use crate::errors::RequestError;
use crate::outbox::Outbox;
use crate::ports::Ports;
use crate::project::{Builder, BuiltProject};
use crate::request::Request;
use crate::source_map::SourceMap;
use crate::target_link::TargetLink;
use crate::transport::Incoming;
use crate::tree::Tree;

use breakpoints::Breakpoints;
use forcing::Forcing;
pub(crate) use phase::COMMANDS;
use phase::Phase;
use reconnect::Again;
use watching::Watching;

/// Longest wait for the target before the client is looked at again.
const TURN: Duration = Duration::from_millis(4);
/// Longest wait for the client while there is no target.
const IDLE: Duration = Duration::from_millis(200);

/// What a handler answers: the body, `Null` for none.
type Answer = Result<Value, RequestError>;

/// What the reading side of the transport hands over.
#[derive(Debug)]
pub(crate) enum ClientInput {
    Incoming(Incoming),
    /// The client closed its end.
    Gone,
}

/// What the client can do and how it counts.
#[derive(Clone, Copy, Debug)]
struct ClientTraits {
    first_line: i64,
    first_column: i64,
    invalidated: bool,
    progress: bool,
    /// It is VS Code, which has menus for variables.
    menus: bool,
}

/// Launched or attached.
#[derive(Clone, Debug)]
enum How {
    Launch(LaunchArguments),
    Attach,
}

/// The program under debugging.
struct Debuggee {
    how: How,
    project: BuiltProject,
    program: Arc<Program>,
    debug: Arc<DebugInfo>,
    map: SourceMap,
    ports: Ports,
    tree: Tree,
    plc: PlcState,
    stop: Option<Stop>,
    fault: Option<Fault>,
}

/// Where the program is held, and what was asked about it since.
struct Stop {
    stopped: Stopped,
    sequences: Option<Vec<SequenceState>>,
}

/// Something to do later.
#[derive(Clone, Debug, PartialEq)]
enum Timer {
    ReleaseKey(String),
    /// The PLC did not end in time.
    GiveUpTerminate,
    /// A fault was announced, its details did not come.
    FaultWithoutDetails,
    /// Tell how many overruns there were.
    Overruns,
    /// Tell how many bits are forced.
    Forced,
}

/// A debug session.
pub(crate) struct Session {
    out: Outbox,
    inbox: Receiver<ClientInput>,
    /// What came in while something else was in progress.
    deferred: VecDeque<ClientInput>,
    connector: Arc<dyn Connector>,
    builder: Arc<dyn Builder>,
    phase: Phase,
    client: ClientTraits,
    /// Events that follow the response in progress.
    after: Vec<Event>,
    target: Option<TargetLink>,
    /// Where the target is, once it was asked for.
    spec: Option<TargetSpec>,
    link_arguments: LinkArguments,
    /// The link is lost and is being tried again.
    again: Option<Again>,
    debuggee: Option<Debuggee>,
    breakpoints: Breakpoints,
    watching: Watching,
    forcing: Forcing,
    break_on_fault: bool,
    threads_announced: HashSet<i64>,
    timers: Vec<(Instant, Timer)>,
    overruns: u32,
    terminating: bool,
    finished: bool,
}

impl Session {
    pub(crate) fn new(
        inbox: Receiver<ClientInput>,
        out: Outbox,
        connector: Arc<dyn Connector>,
        builder: Arc<dyn Builder>,
    ) -> Self {
        Session {
            out,
            inbox,
            deferred: VecDeque::new(),
            connector,
            builder,
            phase: Phase::New,
            client: ClientTraits {
                first_line: 1,
                first_column: 1,
                invalidated: false,
                progress: false,
                menus: false,
            },
            after: Vec::new(),
            target: None,
            spec: None,
            link_arguments: LinkArguments::default(),
            again: None,
            debuggee: None,
            breakpoints: Breakpoints::default(),
            watching: Watching::default(),
            forcing: Forcing::default(),
            break_on_fault: true,
            threads_announced: HashSet::new(),
            timers: Vec::new(),
            overruns: 0,
            terminating: false,
            finished: false,
        }
    }

    /// Runs until the client disconnects or is gone.
    pub(crate) fn run(mut self) {
        while !self.finished && !self.out.is_gone() {
            self.take_target_events();
            self.try_again();
            self.watch();
            self.run_timers();
            match self.next_input() {
                Some(ClientInput::Incoming(incoming)) => self.take(incoming),
                Some(ClientInput::Gone) => break,
                None => {}
            }
        }
        // A client that vanished gets what `disconnect` without arguments would have done.
        self.leave_target(None);
    }

    fn next_input(&mut self) -> Option<ClientInput> {
        if let Some(input) = self.deferred.pop_front() {
            return Some(input);
        }
        let Some(target) = &mut self.target else {
            let wait = if self.again.is_some() { TURN } else { IDLE };
            return match self.inbox.recv_timeout(wait) {
                Ok(input) => Some(input),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => Some(ClientInput::Gone),
            };
        };
        match self.inbox.try_recv() {
            Ok(input) => return Some(input),
            Err(TryRecvError::Disconnected) => return Some(ClientInput::Gone),
            Err(TryRecvError::Empty) => {}
        }
        target.pump(TURN);
        None
    }

    fn take(&mut self, incoming: Incoming) {
        match incoming {
            Incoming::Message(message) => match Request::from_message(&message) {
                Ok(request) => self.answer(&request),
                Err(reason) => self.complain(&format!("a message was ignored: {reason}")),
            },
            Incoming::Malformed { text, reason } => match Request::from_broken(&text) {
                Some(request) => self.out.respond(&request, Err(&RequestError::NotJson { reason })),
                None => self.complain(&format!("a message was ignored: it is not valid JSON: {reason}")),
            },
            Incoming::Junk(text) => {
                self.complain(&format!("bytes without a Content-Length were ignored: {text:?}"));
            }
        }
    }

    /// Answers one request, exactly once.
    fn answer(&mut self, request: &Request) {
        let result = match COMMANDS.iter().find(|c| c.name == request.command) {
            None => Err(RequestError::Unknown { command: request.command.clone() }),
            Some(command) => {
                phase::check(command, self.phase).and_then(|()| (command.handler)(self, request))
            }
        };
        match result {
            Ok(body) => self.out.respond(request, Ok(body)),
            Err(error) => self.out.respond(request, Err(&error)),
        }
        for event in std::mem::take(&mut self.after) {
            self.out.event(&event);
        }
    }

    /// Does something slow on another thread, while the link stays alive. A `disconnect` ends the wait.
    fn aside<T: Send + 'static>(
        &mut self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, RequestError> {
        let (done, result) = channel();
        std::thread::spawn(move || done.send(work()));
        loop {
            match result.recv_timeout(TURN) {
                Ok(value) => return Ok(value),
                Err(RecvTimeoutError::Disconnected) => return Err(RequestError::Cancelled),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Some(target) = &mut self.target {
                target.pump(Duration::ZERO);
            }
            if self.interrupted() {
                return Err(RequestError::Cancelled);
            }
        }
    }

    /// The client wants to leave. Everything it sends meanwhile is kept for later.
    fn interrupted(&mut self) -> bool {
        loop {
            match self.inbox.try_recv() {
                Ok(input) => self.deferred.push_back(input),
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => {
                    self.deferred.push_back(ClientInput::Gone);
                    break;
                }
            }
        }
        self.out.is_gone()
            || self.deferred.iter().any(|input| match input {
                ClientInput::Gone => true,
                ClientInput::Incoming(Incoming::Message(message)) => {
                    matches!(message.get("command").and_then(Value::as_str), Some("disconnect" | "terminate"))
                }
                ClientInput::Incoming(_) => false,
            })
    }

    fn run_timers(&mut self) {
        let now = Instant::now();
        while let Some(at) = self.timers.iter().position(|(due, _)| *due <= now) {
            let (_, timer) = self.timers.swap_remove(at);
            self.on_timer(timer);
        }
    }

    fn start_timer(&mut self, after: Duration, timer: Timer) {
        self.timers.push((Instant::now() + after, timer));
    }

    /// Link and program; an error when there is none.
    fn parts(&mut self) -> Result<(&mut TargetLink, &mut Debuggee), RequestError> {
        if self.again.is_some() {
            return Err(RequestError::LinkLost("it is being tried again".into()));
        }
        match (&mut self.target, &mut self.debuggee) {
            (Some(target), Some(debuggee)) => Ok((target, debuggee)),
            _ => Err(RequestError::LinkLost("there is no target".into())),
        }
    }

    fn debuggee(&self) -> Result<&Debuggee, RequestError> {
        self.debuggee.as_ref().ok_or_else(|| RequestError::LinkLost("there is no program".into()))
    }

    /// The stop the program is held at.
    fn stop(&self, request: &Request) -> Result<(&Debuggee, &Stop), RequestError> {
        let not_stopped = || RequestError::NotStopped { command: request.command.clone() };
        let debuggee = self.debuggee()?;
        Ok((debuggee, debuggee.stop.as_ref().ok_or_else(not_stopped)?))
    }

    /// A line in the debug console.
    fn say(&mut self, text: &str) {
        self.output(OutputEventCategory::Console, text, None);
    }

    /// A line in the debug console that stands out.
    fn complain(&mut self, text: &str) {
        self.output(OutputEventCategory::Stderr, text, None);
    }

    fn output(&mut self, category: OutputEventCategory, text: &str, at: Option<(&std::path::Path, u32)>) {
        let body = OutputEventBody {
            category: Some(category),
            output: format!("{text}\n"),
            source: at.map(|(path, _)| sources::source(path)),
            line: at.map(|(_, line)| self.line_out(line)),
            ..OutputEventBody::default()
        };
        self.out.event(&Event::Output(body));
    }

    /// A 1-based line as the client counts.
    fn line_out(&self, line: u32) -> i64 {
        i64::from(line) - 1 + self.client.first_line
    }

    /// A line of the client as 1-based; 0 stands for nonsense.
    fn line_in(&self, line: i64) -> u32 {
        u32::try_from(line.saturating_sub(self.client.first_line).saturating_add(1)).unwrap_or(0)
    }
}

/// A response body, as handlers return it.
#[expect(clippy::unnecessary_wraps, reason = "it ends handlers, which can fail")]
fn body(value: &impl Serialize) -> Answer {
    // Plain data: serialising it has no way to fail.
    Ok(serde_json::to_value(value).unwrap_or_default())
}
