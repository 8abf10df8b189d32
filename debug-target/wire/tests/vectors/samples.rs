//! What the vectors are made of: every message, with values at the edges of their encoding.

use technol_wire::frame::{self, kind};
use technol_wire::message::MachineRegisters;
use technol_wire::message::{
    BreakpointState, Chunk, ChunkAck, Entry, Event, Failure, Fault, FaultKind, FileAnswer, FileRequest,
    Frame, Limits, LostPolicy, PROTOCOL_VERSION, PlcState, Registers, Request, Response, Resume,
    SequenceState, Status, StopReason, Stopped, feature,
};
use technol_wire::message::{Item, ItemKind, Mode, Subject, Subscription, TracedLine, TracedRegister};

const HASH: [u8; 16] = [0, 1, 127, 128, 255, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];

pub(crate) fn limits() -> Limits {
    Limits { max_payload: 240, max_read: 2048, max_breakpoints: 256, window: 8 }
}

fn status() -> Status {
    Status { plc: PlcState::Running, held: true, cycle: 1 << 40, program: Some(HASH) }
}

pub(crate) fn hello() -> Response {
    Response::Hello {
        version: PROTOCOL_VERSION,
        limits: limits(),
        boot: 0xFFFF_FFFF,
        status: status(),
        features: feature::LOST_POLICY | feature::ECHO | feature::FILES | feature::RESUMED_DOWNLOAD,
    }
}

fn registers() -> Registers {
    Registers { rlo: true, dr: -129, dr_real: -0.15625, bx: 128, stack: 0b101, depth: 3 }
}

fn call_stack() -> Vec<Frame> {
    vec![
        Frame { pc: 127, procedure: Some(0), sequence: None, module: 3 },
        Frame { pc: 16_384, procedure: None, sequence: Some(300), module: 3 },
    ]
}

pub(crate) fn requests() -> Vec<Request> {
    let path = |text: &str| text.to_owned();
    let mut requests = vec![
        Request::Hello { version: PROTOCOL_VERSION, session: 0 },
        Request::Hello { version: 0x3FFF, session: 0xDEAD_BEEF },
        Request::Status,
        Request::Download { len: 16_800, hash: HASH },
        Request::Commit,
        Request::Start { cold: true, stop_on_entry: false },
        Request::Stop,
        Request::Clear,
        Request::SetBreakpoints { pcs: vec![] },
        Request::SetBreakpoints { pcs: vec![0, 127, 128, 16_383, 16_384, u32::MAX] },
        Request::Resume(Resume::Continue),
        Request::Resume(Resume::Into),
        Request::Resume(Resume::Over { sequence: None }),
        Request::Resume(Resume::Over { sequence: Some(u16::MAX) }),
        Request::Resume(Resume::Out),
        Request::Pause,
        Request::Registers,
        Request::SetRegisters(registers()),
        Request::SetRegisters(Registers { dr: i64::MIN, dr_real: f64::MAX, ..Registers::default() }),
        Request::SetRegisters(Registers { dr: i64::MAX, dr_real: -0.0, ..Registers::default() }),
        Request::Read { pieces: vec![(0, 1), (70_000, 512)] },
        Request::Write { addr: 300, bytes: vec![0, 255, 0] },
        Request::WriteBits { addr: 5, mask: 0x80, value: 0x80 },
        Request::CallStack,
        Request::Sequences,
        Request::SetSequence { sequence: 17, active: true },
        Request::SetFault { name: path("zpětné hlášení"), on: true },
        Request::Press { key: path("start"), down: false },
        Request::Goodbye { stop: true },
        Request::Subscribe(Subscription {
            id: 3,
            period: 300,
            subject: Subject::Variables(
                [
                    (ItemKind::Bit(7), Mode::Value),
                    (ItemKind::Unsigned(1), Mode::OnChange),
                    (ItemKind::Signed(4), Mode::Extremes),
                    (ItemKind::Real, Mode::Edges),
                ]
                .map(|(kind, mode)| Item { addr: 70_000, kind, mode })
                .to_vec(),
            ),
        }),
        Request::Subscribe(Subscription { id: 0, period: 1, subject: Subject::Mechanisms(vec![0, 200]) }),
        Request::Subscribe(Subscription {
            id: 7,
            period: 1,
            subject: Subject::Trace { pcs: vec![1, 300], wide: true },
        }),
        Request::Subscribe(Subscription {
            id: 6,
            period: 2,
            subject: Subject::Lines(
                [(1, TracedRegister::Dr32), (300, TracedRegister::Dr64), (70_000, TracedRegister::Real)]
                    .map(|(pc, register)| TracedLine { pc, register })
                    .to_vec(),
            ),
        }),
        Request::Unsubscribe { id: 3 },
        Request::Echo { bytes: vec![0, 1, 2] },
        Request::MachineRegisters,
    ];
    requests
        .extend([LostPolicy::RunOn, LostPolicy::StayStopped, LostPolicy::StopPlc].map(Request::OnLinkLost));
    let files = [
        FileRequest::List { path: String::new(), from: 130 },
        FileRequest::Read { path: path("a/b.txt"), offset: 1 << 33, len: 2000 },
        FileRequest::Sum { path: path("a/b.txt") },
        FileRequest::Store { path: path("c") },
        FileRequest::Copy { from: path("c"), to: path("d") },
        FileRequest::Move { from: path("c"), to: path("d") },
        FileRequest::Delete { path: path("d") },
        FileRequest::MakeFolder { path: path("e/f") },
    ];
    requests.extend(files.map(Request::Files));
    requests
}

/// Number of variants of [`Response`]; `response_number` does not compile without knowing each.
pub(crate) const RESPONSES: u8 = 12;

fn response_number(response: &Response) -> u8 {
    match response {
        Response::Done => 0,
        Response::Hello { .. } => 1,
        Response::Status(_) => 2,
        Response::Breakpoints(_) => 3,
        Response::Registers(_) => 4,
        Response::Memory { .. } => 5,
        Response::CallStack(_) => 6,
        Response::Sequences(_) => 7,
        Response::Failed(_) => 8,
        Response::Echo { .. } => 9,
        Response::Files(_) => 10,
        Response::MachineRegisters(_) => RESPONSES - 1,
    }
}

pub(crate) fn responses() -> Vec<Response> {
    let states = [
        BreakpointState::Set,
        BreakpointState::NotAStatement,
        BreakpointState::InFast,
        BreakpointState::InCont,
        BreakpointState::TooMany,
    ];
    let sequence = SequenceState { sequence: 1, active: true, resume: 2, line: 500, since: 100_000 };
    let empty = Status { plc: PlcState::Empty, held: false, cycle: 0, program: None };
    let mut responses = vec![
        Response::Done,
        hello(),
        Response::Status(empty),
        Response::Status(status()),
        Response::Breakpoints(states.to_vec()),
        Response::Registers(registers()),
        Response::Memory { cycle: u64::MAX, bytes: vec![0; 3] },
        Response::CallStack(call_stack()),
        Response::Sequences(vec![sequence, SequenceState { active: false, ..sequence }]),
        Response::Echo { bytes: vec![0, 1, 2], damaged: 12 },
        Response::MachineRegisters(MachineRegisters { eax: 0x1_4000, flags: 0x841 }),
        Response::Files(FileAnswer::Entries {
            entries: vec![
                Entry { name: "log".into(), folder: true, size: 0, modified: 0 },
                Entry { name: "tabulka č. 1".into(), folder: false, size: 1 << 40, modified: 1_700_000_000 },
            ],
            more: true,
        }),
        Response::Files(FileAnswer::Bytes { bytes: vec![7, 0], size: 3 }),
        Response::Files(FileAnswer::Sum { size: 3, hash: HASH }),
    ];
    let failures = [
        Failure::Unsupported,
        Failure::Malformed,
        Failure::Version,
        Failure::NoSession,
        Failure::NoProgram,
        Failure::NotStopped,
        Failure::NotRunning,
        Failure::OutOfRange,
        Failure::Incomplete,
        Failure::BadProgram("jump out of the code".into()),
        Failure::NotFound("sequence 3".into()),
        Failure::TooLarge,
        Failure::Refused("not permitted".into()),
    ];
    responses.extend(failures.map(Response::Failed));
    for response in &responses {
        let bytes = postcard::to_allocvec(response).unwrap();
        assert_eq!(bytes[0], response_number(response), "{response:?}");
    }
    responses
}

/// Number of variants of [`Event`].
pub(crate) const EVENTS: u8 = 7;

fn event_number(event: &Event) -> u8 {
    match event {
        Event::Stopped(_) => 0,
        Event::Resumed => 1,
        Event::State(_) => 2,
        Event::Fault(_) => 3,
        Event::Message { .. } => 4,
        Event::Overrun { .. } => 5,
        Event::Log(_) => EVENTS - 1,
    }
}

pub(crate) fn events() -> Vec<Event> {
    let stopped = Stopped {
        reason: StopReason::Breakpoint,
        pc: 127,
        module: 3,
        sequence: Some(300),
        cycle: 128,
        registers: registers(),
        frames: call_stack(),
    };
    let reasons = [StopReason::Step, StopReason::Pause, StopReason::Entry, StopReason::Fault];
    let fault = |kind| Fault { kind, pc: 9, module: 0, sequence: None, cycle: 77 };
    let kinds = [
        FaultKind::DivisionByZero,
        FaultKind::QuotientOverflow,
        FaultKind::BcdRange,
        FaultKind::StackOverflow,
        FaultKind::StackUnderflow,
        FaultKind::BadAddress,
        FaultKind::EndlessLoop,
        FaultKind::CallDepth,
        FaultKind::UnexpectedReturn,
        FaultKind::UnexpectedEnd,
        FaultKind::BadContinuation,
        FaultKind::NoService,
    ];
    let message = |sub_id, parameters| Event::Message {
        cycle: 70_000,
        number: 1200,
        sub_id,
        set: true,
        parameters,
        pc: 200,
    };
    let mut events = vec![
        Event::Stopped(stopped.clone()),
        Event::Resumed,
        message(None, vec![]),
        message(Some(-1), vec![i64::MIN, -65, -64, 63, 64, i64::MAX]),
        Event::Overrun { cycle: 4, fast: true },
        Event::Log("řádek".into()),
    ];
    let bare = Stopped { sequence: None, frames: vec![], ..stopped };
    events.extend(reasons.map(|reason| Event::Stopped(Stopped { reason, ..bare.clone() })));
    events.extend(kinds.map(|kind| Event::Fault(fault(kind))));
    let states = [
        PlcState::Empty,
        PlcState::Stopped,
        PlcState::Starting,
        PlcState::Running,
        PlcState::Stopping,
        PlcState::Halted,
        PlcState::Faulted,
    ];
    events.extend(states.map(|plc| Event::State(Status { plc, ..status() })));
    for event in &events {
        let bytes = postcard::to_allocvec(event).unwrap();
        assert_eq!(bytes[0], event_number(event), "{event:?}");
    }
    events
}

pub(crate) fn chunk() -> Chunk {
    Chunk { offset: 16_384, bytes: vec![0, 1, 0, 255] }
}

pub(crate) fn chunk_ack() -> ChunkAck {
    ChunkAck { complete: 464, islands: vec![(696, 232), (16_384, 1)] }
}

/// Name, kind, number, payload.
pub(crate) fn frames() -> Vec<(String, u8, u8, Vec<u8>)> {
    let mut frames = vec![
        ("ping".to_owned(), kind::PING, 7, vec![]),
        ("pong".to_owned(), kind::PONG, 7, vec![]),
        ("event ack before the first event".to_owned(), kind::EVENT_ACK, 255, vec![]),
        ("an unknown kind".to_owned(), 0x7F, 0, vec![1, 2, 3]),
    ];
    // The stuffing has its edges at zeros and at runs of 254 bytes.
    for len in [1, 2, 240, 247, 248, 249, 250, 251, 252, 253, 254, 255, 256, 503, 504, 505, 506, 507, 508] {
        for fill in [0, 1, 255] {
            frames.push((format!("{len} times {fill}"), kind::CHUNK, 1, vec![fill; len]));
        }
    }
    frames
}

/// Name and bytes with their delimiter.
pub(crate) fn damaged() -> Vec<(String, Vec<u8>)> {
    let mut good = Vec::new();
    frame::encode(kind::RESPONSE, 5, &[0x80, 0], &mut good);
    let mut damaged: Vec<(String, Vec<u8>)> = vec![
        ("nothing with its checksum".into(), vec![1, 1, 1, 1, 1, 0]),
        ("five bytes".into(), vec![6, 1, 2, 3, 4, 5, 0]),
        ("one byte".into(), vec![1, 0]),
        ("a code that points behind the end".into(), vec![9, 1, 2, 3, 4, 5, 6, 0]),
    ];
    for at in 0..good.len() - 1 {
        for bit in [0, 7] {
            let mut bytes = good.clone();
            bytes[at] ^= 1 << bit;
            if bytes[at] != 0 {
                damaged.push((format!("bit {bit} of byte {at} is flipped"), bytes));
            }
        }
        let mut bytes = good.clone();
        bytes.remove(at);
        damaged.push((format!("byte {at} is lost"), bytes));
    }
    damaged
}
