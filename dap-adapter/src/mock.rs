//! A scripted target behind the real protocol: answers from a memory of its own, stops where it is told to.

use std::collections::VecDeque;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use technol_image::container::{content_hash, decode_program};
use technol_image::system;
use technol_wire::message::{
    BreakpointState, Event, Failure, Frame, Limits, PROTOCOL_VERSION, PlcState, Registers, Request, Response,
    SequenceState, Status, StopReason, Stopped, feature,
};
use technol_wire::{MechanismSample, Ran, SampleSource, TargetInput, TargetSession, TraceSample};

use crate::arguments::Policy;
use crate::connection::{ByteLink, Connector, TargetSpec};
use crate::project::{BuildFailure, Builder, BuiltProject};
use crate::sample;
use crate::server::Surroundings;

/// One end of a pipe of bytes.
struct PipeEnd {
    to: Sender<Vec<u8>>,
    from: Receiver<Vec<u8>>,
    line: Option<u32>,
}

fn pipe() -> (PipeEnd, PipeEnd) {
    let (a, from_a) = channel();
    let (b, from_b) = channel();
    (PipeEnd { to: a, from: from_b, line: None }, PipeEnd { to: b, from: from_a, line: None })
}

impl ByteLink for PipeEnd {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.to.send(bytes.to_vec()).map_err(|_| io::Error::other("the other end is closed"))
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        match self.from.recv_timeout(timeout) {
            Ok(bytes) => {
                buffer[..bytes.len()].copy_from_slice(&bytes);
                Ok(bytes.len())
            }
            Err(RecvTimeoutError::Timeout) => Ok(0),
            Err(RecvTimeoutError::Disconnected) => Err(io::Error::other("the other end is closed")),
        }
    }

    fn bytes_per_second(&self) -> Option<u32> {
        self.line
    }
}

/// What the target knows and what it is going to do.
pub(crate) struct State {
    pub(crate) status: Status,
    pub(crate) version: u16,
    pub(crate) memory: Vec<u8>,
    pub(crate) registers: Registers,
    pub(crate) sequences: Vec<SequenceState>,
    /// Where the next resumptions (and the start) end; when there is none left, the program runs on.
    pub(crate) stops: VecDeque<Stopped>,
    /// Every request, in order.
    pub(crate) log: Vec<Request>,
    /// Events to send.
    pub(crate) events: Vec<Event>,
    /// The link breaks.
    pub(crate) cut: bool,
    /// `Stop` is acknowledged and then nothing happens.
    pub(crate) never_stops: bool,
    /// Streams end at once.
    pub(crate) deaf: bool,
    announced: Vec<u8>,
}

/// Handle of the test.
#[derive(Clone)]
pub(crate) struct Mock {
    state: Arc<Mutex<State>>,
    /// What the adapter asked to be connected to.
    pub(crate) asked: Arc<Mutex<Vec<TargetSpec>>>,
    refusal: Option<String>,
    /// What the line carries in a second.
    line: Option<u32>,
}

impl Mock {
    pub(crate) fn new() -> Self {
        let mut memory = vec![0; sample::MEMORY as usize];
        memory[sample::INPUTS as usize] = 0b01;
        memory[sample::COUNT as usize..][..2].copy_from_slice(&300_u16.to_le_bytes());
        memory[sample::SPEED as usize..][..4].copy_from_slice(&(-1_i32).to_le_bytes());
        memory[sample::TITLE as usize..][..3].copy_from_slice(b"abc");
        memory[sample::TABLE as usize + 1] = 7;
        memory[sample::RATIO as usize..][..8].copy_from_slice(&2.5_f64.to_le_bytes());
        memory[sample::LONELY as usize] = 8;
        memory[0] = 0b11;
        let sequence = |sequence, active, line, since| SequenceState {
            sequence,
            active,
            resume: u16::from(active),
            line,
            since,
        };
        Mock {
            state: Arc::new(Mutex::new(State {
                status: Status { plc: PlcState::Empty, held: false, cycle: 100, program: None },
                version: PROTOCOL_VERSION,
                memory,
                registers: Registers { rlo: true, dr: 300, dr_real: 0.5, bx: 0, stack: 0b01, depth: 2 },
                sequences: vec![sequence(0, true, 21, 60), sequence(1, false, 0, 0)],
                stops: VecDeque::new(),
                log: Vec::new(),
                events: Vec::new(),
                cut: false,
                never_stops: false,
                deaf: false,
                announced: Vec::new(),
            })),
            asked: Arc::default(),
            refusal: None,
            line: None,
        }
    }

    /// One that cannot be reached.
    pub(crate) fn absent(reason: &str) -> Self {
        Mock { refusal: Some(reason.into()), ..Mock::new() }
    }

    /// One at the end of a line that carries so many bytes a second.
    pub(crate) fn on_a_line(self, bytes_per_second: u32) -> Self {
        Mock { line: Some(bytes_per_second), ..self }
    }

    /// The sample program is loaded and running already.
    pub(crate) fn running(self) -> Self {
        let mut state = self.state();
        state.status.plc = PlcState::Running;
        state.status.program = Some(content_hash(&sample::image().program));
        drop(state);
        self
    }

    pub(crate) fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap()
    }

    /// The next resumption ends at a line of `main.plc`.
    pub(crate) fn will_stop(&self, stopped: Stopped) {
        self.state().stops.push_back(stopped);
    }

    pub(crate) fn say(&self, event: Event) {
        self.state().events.push(event);
    }

    /// Requests so far that fulfil a condition.
    pub(crate) fn asked_for(&self, condition: impl Fn(&Request) -> bool) -> Vec<Request> {
        self.state().log.iter().filter(|r| condition(r)).cloned().collect()
    }

    pub(crate) fn surroundings(&self, builder: SampleBuilder) -> Surroundings {
        Surroundings { connector: Arc::new(self.clone()), builder: Arc::new(builder) }
    }
}

impl Connector for Mock {
    fn connect(&self, target: &TargetSpec) -> Result<Box<dyn ByteLink>, String> {
        self.asked.lock().unwrap().push(target.clone());
        if let Some(refusal) = &self.refusal {
            return Err(refusal.clone());
        }
        let (mut host, target) = pipe();
        host.line = self.line;
        let state = Arc::clone(&self.state);
        std::thread::spawn(move || run(target, &state));
        Ok(Box::new(host))
    }
}

/// A stop inside SPINDLE.
pub(crate) fn stop_in_spindle(reason: StopReason, line: u32) -> Stopped {
    stop(reason, line, Some(0), &[])
}

/// A stop in MODULE_MAIN, or in a mechanism, below the calls of the procedure STEP at these lines.
pub(crate) fn stop(reason: StopReason, line: u32, sequence: Option<u16>, calls: &[u32]) -> Stopped {
    let pc = sample::pc(line);
    let mut frames: Vec<Frame> = calls
        .iter()
        .map(|line| Frame { pc: sample::pc(*line), procedure: Some(0), sequence, module: 3 })
        .collect();
    let base = if calls.is_empty() { pc } else { sample::pc(18) };
    frames.push(Frame { pc: base, procedure: None, sequence, module: 3 });
    Stopped {
        reason,
        pc,
        module: 3,
        sequence,
        cycle: 123,
        registers: Registers { rlo: true, dr: 300, dr_real: 0.5, bx: 0, stack: 0b01, depth: 2 },
        frames,
    }
}

fn run(mut link: PipeEnd, state: &Mutex<State>) {
    let limits = Limits { max_payload: 200, max_read: 128, max_breakpoints: 4, window: 4 };
    let mut session = TargetSession::new(limits);
    let started = Instant::now();
    let now = || started.elapsed().as_micros() as u64;
    let mut buffer = [0; 8192];
    let mut sampled = 0;
    loop {
        session.poll(now());
        let bytes = session.transmit();
        if !bytes.is_empty() && link.send(&bytes).is_err() {
            return;
        }
        let Ok(n) = link.receive(&mut buffer, Duration::from_millis(1)) else { return };
        session.receive(now(), &buffer[..n]);
        let mut state = state.lock().unwrap();
        if state.cut {
            return;
        }
        while let Some(input) = session.next() {
            match input {
                TargetInput::Request { seq, request } => {
                    state.log.push(request.clone());
                    let response = match request {
                        Request::Subscribe(subscription) => {
                            let begun =
                                session.streams().subscribe(&subscription, limits.max_payload, &*state);
                            begun.map_or_else(Response::Failed, |()| Response::Done)
                        }
                        Request::Unsubscribe { id } => {
                            session.streams().unsubscribe(id);
                            Response::Done
                        }
                        other => state.answer(other, limits),
                    };
                    session.respond(seq, &response);
                }
                TargetInput::Chunk(chunk) => {
                    let at = chunk.offset as usize;
                    state.announced[at..at + chunk.bytes.len()].copy_from_slice(&chunk.bytes);
                }
                TargetInput::HostLost => return,
            }
        }
        let number = (now() / 20_000) as u32;
        if state.deaf {
            session.streams().clear();
        }
        if number > sampled {
            sampled = number;
            session.streams().sample(number, number + 7000, &*state);
        }
        for event in std::mem::take(&mut state.events) {
            session.event(&event);
        }
    }
}

impl SampleSource for State {
    fn memory(&self) -> &[u8] {
        &self.memory
    }

    fn mechanism(&self, sequence: u16) -> MechanismSample {
        let now = self.sequences[usize::from(sequence)];
        MechanismSample { active: now.active, resume: now.resume, line: now.line, entered: 7000 }
    }

    fn traced(&self, pc: u32) -> TraceSample {
        TraceSample {
            ran: match pc {
                _ if pc == sample::pc(20) => Ran::Now,
                _ if pc == sample::pc(21) => Ran::Before,
                _ => Ran::Never,
            },
            rlo: true,
            dr: i64::from(self.memory[sample::COUNT as usize]),
            dr_real: 0.0,
        }
    }
}

impl State {
    fn answer(&mut self, request: Request, limits: Limits) -> Response {
        match request {
            Request::Hello { .. } => Response::Hello {
                version: self.version,
                limits,
                boot: 1,
                status: self.status,
                features: feature::STREAMS | feature::TRACED_REGISTERS,
            },
            Request::Status => Response::Status(self.status),
            Request::OnLinkLost(_) => Response::Done,
            Request::Echo { .. } | Request::Files(_) | Request::MachineRegisters => {
                Response::Failed(Failure::Unsupported)
            }
            Request::Download { len, .. } => {
                self.announced = vec![0; len as usize];
                Response::Done
            }
            Request::Commit => match decode_program(&self.announced) {
                Ok(program) => {
                    self.status.program = Some(content_hash(&program));
                    self.status.plc = PlcState::Stopped;
                    Response::Done
                }
                Err(_) => Response::Failed(Failure::Incomplete),
            },
            Request::Start { cold, stop_on_entry } => {
                if cold {
                    let masks = system::IN_FORCE_LOW as usize..system::OUT_SHORTED as usize;
                    self.memory[masks].fill(0);
                }
                self.to(PlcState::Running);
                if stop_on_entry {
                    self.stops.push_front(stop(StopReason::Entry, 11, None, &[]));
                }
                self.go_on();
                Response::Done
            }
            Request::Stop if self.never_stops => Response::Done,
            Request::Stop => {
                self.to(PlcState::Stopped);
                Response::Done
            }
            Request::SetBreakpoints { pcs } => {
                let refuse = |pc: u32| {
                    if pc == sample::pc(20) { BreakpointState::TooMany } else { BreakpointState::Set }
                };
                Response::Breakpoints(pcs.into_iter().map(refuse).collect())
            }
            Request::Resume(_) if !self.status.held => Response::Failed(Failure::NotStopped),
            Request::Resume(_) => {
                self.status.held = false;
                self.events.push(Event::Resumed);
                self.go_on();
                Response::Done
            }
            Request::Pause => {
                self.stops.push_front(stop_in_spindle(StopReason::Pause, 21));
                self.go_on();
                Response::Done
            }
            Request::Registers => Response::Registers(self.registers),
            Request::Read { pieces } => self.read(&pieces),
            Request::Write { addr, bytes } => {
                let at = addr as usize;
                match self.memory.get_mut(at..at + bytes.len()) {
                    Some(place) => place.copy_from_slice(&bytes),
                    None => return Response::Failed(Failure::OutOfRange),
                }
                Response::Done
            }
            Request::WriteBits { addr, mask, value } => {
                let byte = &mut self.memory[addr as usize];
                *byte = *byte & !mask | value & mask;
                Response::Done
            }
            Request::CallStack => Response::CallStack(stop_in_spindle(StopReason::Pause, 21).frames),
            Request::Sequences => Response::Sequences(self.sequences.clone()),
            Request::SetSequence { sequence, active } => {
                self.sequences[usize::from(sequence)].active = active;
                Response::Done
            }
            Request::SetFault { name, .. } if name != "stuck contactor" => Response::Failed(
                Failure::NotFound(format!("`{name}` is not known; there is stuck contactor")),
            ),
            Request::SetRegisters(_)
            | Request::Clear
            | Request::SetFault { .. }
            | Request::Press { .. }
            | Request::Subscribe(_)
            | Request::Unsubscribe { .. }
            | Request::Goodbye { .. } => Response::Done,
        }
    }

    fn to(&mut self, plc: PlcState) {
        self.status.plc = plc;
        self.status.held = false;
        self.events.push(Event::State(self.status));
    }

    fn go_on(&mut self) {
        if let Some(stopped) = self.stops.pop_front() {
            self.status.held = true;
            self.registers = stopped.registers;
            self.events.push(Event::Stopped(stopped));
        }
    }

    fn read(&self, pieces: &[(u32, u16)]) -> Response {
        let mut bytes = Vec::new();
        for (addr, len) in pieces {
            match self.memory.get(*addr as usize..*addr as usize + usize::from(*len)) {
                Some(piece) => bytes.extend_from_slice(piece),
                None => return Response::Failed(Failure::OutOfRange),
            }
        }
        Response::Memory { cycle: self.status.cycle, bytes }
    }
}

/// Builds the sample, or fails as told.
#[derive(Clone, Default)]
pub(crate) struct SampleBuilder {
    pub(crate) root: PathBuf,
    pub(crate) failure: Option<BuildFailure>,
    pub(crate) only_debug_regions: bool,
    pub(crate) target: Option<String>,
    /// The build takes so long.
    pub(crate) delay: Duration,
}

impl Builder for SampleBuilder {
    fn build(&self, _program: &Path, _policy: Policy) -> Result<BuiltProject, BuildFailure> {
        std::thread::sleep(self.delay);
        if let Some(failure) = &self.failure {
            return Err(failure.clone());
        }
        Ok(BuiltProject {
            root: self.root.clone(),
            image: sample::image(),
            machine: Some(self.root.join("machine.toml")),
            target: self.target.clone(),
            break_everywhere: !self.only_debug_regions,
            encoding: None,
            summary: "sample is up to date".into(),
            warnings: Vec::new(),
            configuration_errors: Vec::new(),
        })
    }
}
