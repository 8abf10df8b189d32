//! The same debug session over every kind of link, and what happens when things go wrong.
#![allow(clippy::unwrap_used)] // tests

mod host;
#[cfg(unix)]
mod lines;
mod places;
mod program;

use std::net::TcpListener;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use host::Host;
use places::{Embedded, Place, Tcp};
use program::{ADD, COUNT, DATA, DIVIDE, DIVISOR, FEEDBACK, LOAD, MOTOR, SHOW, STORE, counter};
use technol_image::container::content_hash;
use technol_image::op::Op;
use technol_machine::MachineConfig;
use technol_target::{
    Address, Clock, ConnectError, Connector, ListenError, Notice, TargetCore, TargetOptions, Token, connect,
    listen_tcp,
};
use technol_wire::Sample;
use technol_wire::message::{
    BreakpointState, Event, Failure, FaultKind, Item, ItemKind, Mode, PlcState, Registers, Request, Response,
    Resume, StopReason, Subject, Subscription,
};

/// MODULE_MAIN in the numbering of the protocol.
const MAIN: u8 = 3;

fn options(clock: Clock) -> TargetOptions {
    let mut machine = MachineConfig::default();
    machine.contact.push(technol_machine::config::Contact {
        name: String::new(),
        output: technol_machine::Outputs(vec!["P0OUT.0".into()]),
        input: "P1IN.0".into(),
        on_delay_ms: 100,
        off_delay_ms: 0,
        invert: false,
    });
    machine.key.push(technol_machine::config::Key {
        name: "start".into(),
        input: Some("P2IN.0".into()),
        command: None,
        panel: None,
        invert: false,
    });
    machine.fault.push(technol_machine::config::Fault {
        name: "feedback dead".into(),
        input: Some("P1IN.0".into()),
        stuck: Some(false),
        active: false,
        ..technol_machine::config::Fault::default()
    });
    TargetOptions { clock, machine: Some(machine), ..TargetOptions::default() }
}

fn start(host: &mut Host) {
    host.tell(Request::Start { cold: true, stop_on_entry: false });
}

fn write_word(host: &mut Host, addr: u32, value: u16) {
    host.tell(Request::Write { addr, bytes: value.to_le_bytes().to_vec() });
}

fn session(place: &mut dyn Place) {
    let program = counter();
    let hash = content_hash(&program);
    let mut host = Host::new(place.link().unwrap(), 1);
    let (boot, status) = host.hello();
    assert_eq!((status.plc, status.program), (PlcState::Empty, None));
    assert_eq!(host.ask(Request::Registers), Response::Failed(Failure::NoProgram));
    assert_eq!(host.download(&program, |_| ()), Response::Done);
    let status = host.status();
    assert_eq!((status.plc, status.program, status.held), (PlcState::Stopped, Some(hash), false));
    assert_eq!(host.ask(Request::Resume(Resume::Continue)), Response::Failed(Failure::NotStopped));
    assert_eq!(host.ask(Request::Pause), Response::Failed(Failure::NotRunning));

    break_points(&mut host);
    message(&mut host);
    machine(&mut host);
    streams(&mut host);
    fault(&mut host);
    pause_and_registers(&mut host);

    host.tell(Request::Goodbye { stop: true });
    drop(host);
    if let Some(link) = place.link() {
        let mut next = Host::new(link, 2);
        let (again, status) = next.hello();
        assert_eq!((again, status.program, status.held), (boot, Some(hash), false), "the target goes on");
        assert_eq!(status.plc, PlcState::Stopped);
    }
}

fn break_points(host: &mut Host) {
    start(host);
    let answer = host.ask(Request::SetBreakpoints { pcs: vec![STORE, 8, 1000] });
    let not = BreakpointState::NotAStatement;
    assert_eq!(answer, Response::Breakpoints(vec![BreakpointState::Set, not, not]));
    let stop = host.stopped();
    assert_eq!((stop.reason, stop.pc, stop.module), (StopReason::Breakpoint, STORE, MAIN));
    assert_eq!(stop.frames.iter().map(|f| f.pc).collect::<Vec<_>>(), [STORE]);
    let count = host.read_word(COUNT.addr);
    assert_eq!(stop.registers.dr & 0xFFFF, i64::from(count) + 1, "the stop brings the registers along");

    host.tell(Request::Resume(Resume::Into));
    let stop = host.stopped();
    assert_eq!((stop.reason, stop.pc), (StopReason::Step, STORE + 1));
    assert_eq!(host.read_word(COUNT.addr), count + 1);

    write_word(host, COUNT.addr, 500);
    host.tell(Request::Resume(Resume::Continue));
    let stop = host.stopped();
    assert_eq!((stop.pc, stop.registers.dr), (STORE, 501));
    assert!(host.status().held);

    // Steps over a whole cycle end where it began.
    assert_eq!(host.ask(Request::SetBreakpoints { pcs: vec![] }), Response::Breakpoints(vec![]));
    for pc in [4, 5, 6, DIVIDE, LOAD, ADD, STORE] {
        host.tell(Request::Resume(Resume::Over { sequence: None }));
        assert_eq!(host.stopped().pc, pc);
    }
    host.tell(Request::Resume(Resume::Continue));
    assert!(!host.status().held);
}

/// COUNT counts cycles, so each sample proves itself.
fn streams(host: &mut Host) {
    let item = |addr, kind, mode| Item { addr, kind, mode };
    let items = vec![
        item(COUNT.addr, ItemKind::Unsigned(2), Mode::Value),
        item(COUNT.addr, ItemKind::Unsigned(2), Mode::Edges),
    ];
    host.tell(Request::Subscribe(Subscription { id: 1, period: 1, subject: Subject::Variables(items) }));
    let trace = Subject::Trace { pcs: vec![LOAD, ADD], wide: false };
    host.tell(Request::Subscribe(Subscription { id: 2, period: 2, subject: trace }));
    host.sample("ten samples", |s| (s.id == 1 && s.values[2] >= 10).then_some(()));
    host.sample("a trace", |s| (s.id == 2 && s.values[4] == 1).then_some(()));
    let difference = |s: &Sample| u64::from(s.cycle).wrapping_sub(s.values[0]) & 0xFFFF;
    let first = host.samples.iter().find(|s| s.id == 1).map(difference);
    for sample in &host.samples {
        let own = if sample.id == 1 {
            difference(sample)
        } else {
            u64::from(sample.cycle).wrapping_sub(sample.values[7])
        };
        assert_eq!(Some(own & 0xFFFF), first, "{sample:?}");
        if sample.id == 2 {
            assert_eq!(sample.values[3] + 1, sample.values[7], "DR behind LOAD and behind ADD");
        }
    }
    // A stop is shown as well, and what is written then.
    host.tell(Request::Pause);
    host.stopped();
    write_word(host, COUNT.addr, 4711);
    host.sample("the value written", |s| (s.id == 1 && s.values[0] == 4711).then_some(()));
    write_word(host, COUNT.addr, 0);
    host.tell(Request::Resume(Resume::Continue));

    let subject = Subject::Trace { pcs: vec![8], wide: false };
    let refused = host.ask(Request::Subscribe(Subscription { id: 3, period: 1, subject }));
    assert_eq!(refused, Response::Failed(Failure::NotFound("statement at operation 8".into())));
    let subject = Subject::Mechanisms(vec![0]);
    let refused = host.ask(Request::Subscribe(Subscription { id: 3, period: 1, subject }));
    assert_eq!(refused, Response::Failed(Failure::NotFound("sequence 0".into())));
    for id in [1, 2] {
        host.tell(Request::Unsubscribe { id });
    }
    host.forget_events();
}

fn message(host: &mut Host) {
    host.forget_events();
    host.tell(Request::WriteBits { addr: SHOW.addr, mask: 1 << SHOW.bit, value: 0xFF });
    let parameters = host.event("message 27", |event| match event {
        Event::Message { number: 27, set: true, parameters, pc: 6, .. } => Some(parameters),
        _ => None,
    });
    assert_eq!(parameters.len(), 1, "the count");
    host.tell(Request::WriteBits { addr: SHOW.addr, mask: 1 << SHOW.bit, value: 0 });
    host.forget_events();
}

fn machine(host: &mut Host) {
    let feedback = |host: &mut Host| host.read_word(FEEDBACK.addr) >> FEEDBACK.bit & 1 == 1;
    let wait_for = |host: &mut Host, value| {
        let deadline = Instant::now() + Duration::from_secs(10);
        while feedback(host) != value {
            assert!(Instant::now() < deadline, "the feedback never became {value}");
        }
    };
    assert_eq!(host.read_word(MOTOR.addr) & 1, 1);
    wait_for(host, true);
    host.tell(Request::SetFault { name: "feedback dead".into(), on: true });
    wait_for(host, false);
    host.tell(Request::SetFault { name: "feedback dead".into(), on: false });
    wait_for(host, true);
    host.tell(Request::Press { key: "start".into(), down: true });
    let known = "`stop` is not known; there is start".to_owned();
    let answer = host.ask(Request::Press { key: "stop".into(), down: true });
    assert_eq!(answer, Response::Failed(Failure::NotFound(known)));
}

fn fault(host: &mut Host) {
    write_word(host, DIVISOR.addr, 0);
    let stop = host.stopped();
    assert_eq!((stop.reason, stop.pc), (StopReason::Fault, DIVIDE));
    let fault =
        host.event("the fault", |event| if let Event::Fault(fault) = event { Some(fault) } else { None });
    assert_eq!((fault.kind, fault.pc, fault.module), (FaultKind::DivisionByZero, DIVIDE, MAIN));
    assert_eq!(host.status().plc, PlcState::Faulted);
    assert_eq!(host.read_word(DIVISOR.addr), 0, "everything stays readable");
    assert!(matches!(host.ask(Request::CallStack), Response::CallStack(frames) if frames[0].pc == DIVIDE));
    assert_eq!(host.ask(Request::Resume(Resume::Continue)), Response::Failed(Failure::NotRunning));
    host.forget_events();
    start(host);
    host.event("running again", |event| match event {
        Event::State(status) if status.plc == PlcState::Running => Some(()),
        _ => None,
    });
}

fn pause_and_registers(host: &mut Host) {
    host.tell(Request::Pause);
    let stop = host.stopped();
    assert_eq!(stop.reason, StopReason::Pause);
    let registers = Registers { rlo: true, dr: -7, dr_real: 0.5, bx: 3, stack: 0b01, depth: 2 };
    host.tell(Request::SetRegisters(registers));
    assert_eq!(host.ask(Request::Registers), Response::Registers(registers));
    assert_eq!(host.ask(Request::Sequences), Response::Sequences(vec![]));
    let end = DATA + 64;
    let answers = [
        (Request::Read { pieces: vec![(end - 1, 2)] }, Failure::OutOfRange),
        (Request::Read { pieces: vec![(u32::MAX, 1)] }, Failure::OutOfRange),
        (Request::Read { pieces: vec![(0, 32_000), (0, 32_000)] }, Failure::TooLarge),
        (Request::Write { addr: end, bytes: vec![1] }, Failure::OutOfRange),
        (Request::WriteBits { addr: end, mask: 1, value: 1 }, Failure::OutOfRange),
        (Request::SetSequence { sequence: 0, active: true }, Failure::NotFound("sequence 0".into())),
    ];
    for (request, failure) in answers {
        assert_eq!(host.ask(request.clone()), Response::Failed(failure), "{request:?}");
    }
}

#[test]
fn a_session_with_the_embedded_target() {
    session(&mut Embedded::new(options(Clock::Real)));
}

#[test]
fn a_session_in_virtual_time() {
    session(&mut Embedded::new(options(Clock::Virtual)));
}

#[test]
fn a_session_over_tcp() {
    session(&mut Tcp::new(options(Clock::Real)));
}

#[cfg(unix)]
#[test]
fn a_session_over_a_serial_line() {
    session(&mut places::serial::Serial::new(options(Clock::Real)));
}

/// In real time, one bit in ten thousand wrong both ways: each session loses some dozens of frames.
#[cfg(unix)]
#[test]
fn a_session_over_a_noisy_serial_line() {
    let noise = technol_link_model::Faults::bit_errors(1e-4);
    session(&mut places::serial::Serial::noisy(options(Clock::Real), noise));
}

#[test]
fn a_damaged_download_leaves_the_old_program_running() {
    let mut place = Tcp::new(TargetOptions { program: Some(counter()), start: true, ..options(Clock::Real) });
    let mut host = Host::new(place.link().unwrap(), 1);
    let (_, before) = host.hello();
    assert_eq!(before.program, Some(content_hash(&counter())));
    let mut other = counter();
    other.name = "other".into();

    let damaged = host.download(&other, |bytes| bytes[3] ^= 1);
    assert_eq!(damaged, Response::Failed(Failure::Incomplete));
    assert_eq!(host.ask(Request::Commit), Response::Failed(Failure::Incomplete), "nothing is left of it");
    // Intact on the way, but it would jump out of its code.
    other.code[LOAD as usize] = Op::Jump { target: 9999, cond: technol_image::op::Cond::Always };
    let answer = host.download(&other, |_| ());
    assert!(
        matches!(&answer, Response::Failed(Failure::BadProgram(why)) if why.contains("cannot be loaded")),
        "{answer:?}"
    );

    let count = host.read_word(COUNT.addr);
    std::thread::sleep(Duration::from_millis(100));
    assert!(host.read_word(COUNT.addr) > count, "the old program goes on");
    assert_eq!(host.status().program, before.program);
}

#[test]
fn a_program_that_was_held_runs_on_when_the_debugger_is_gone() {
    let mut place = Tcp::new(TargetOptions { program: Some(counter()), start: true, ..options(Clock::Real) });
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    host.ask(Request::SetBreakpoints { pcs: vec![STORE] });
    host.stopped();
    let count = host.read_word(COUNT.addr);
    drop(host);

    let mut next = Host::new(place.link().unwrap(), 2);
    let (_, status) = next.hello();
    assert!(!status.held);
    std::thread::sleep(Duration::from_millis(100));
    assert!(next.read_word(COUNT.addr) > count + 1);
}

/// A serial line does not tell that its other end is gone.
#[cfg(unix)]
#[test]
fn over_a_serial_line_silence_lets_a_held_program_run_on() {
    let options = TargetOptions { program: Some(counter()), start: true, ..options(Clock::Real) };
    let mut place = places::serial::Serial::new(options);
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    host.ask(Request::SetBreakpoints { pcs: vec![STORE] });
    host.stopped();
    drop(host);

    // At once: the next debugger finds the program held, is told where, and finds no break-points.
    let mut next = Host::new(place.link().unwrap(), 2);
    assert!(next.hello().1.held);
    assert_eq!(next.stopped().pc, STORE);
    drop(next);

    std::thread::sleep(Duration::from_millis(1500));
    let mut last = Host::new(place.link().unwrap(), 3);
    let (_, status) = last.hello();
    assert_eq!((status.plc, status.held), (PlcState::Running, false));
}

#[test]
fn a_second_debugger_waits_until_the_first_is_gone() {
    let mut place = Tcp::new(options(Clock::Real));
    let mut first = Host::new(place.link().unwrap(), 1);
    first.hello();
    let waiting = place.link().unwrap();
    assert_eq!(first.status().plc, PlcState::Empty, "the first is not disturbed");
    drop(first);
    Host::new(waiting, 2).hello();
}

#[test]
fn a_debugger_that_fell_silent_makes_room_for_the_next() {
    let mut place = Tcp::new(TargetOptions { program: Some(counter()), start: true, ..options(Clock::Real) });
    let mut silent = Host::new(place.link().unwrap(), 1);
    silent.hello();
    silent.ask(Request::SetBreakpoints { pcs: vec![STORE] });
    silent.stopped();
    // It keeps its connection open and says nothing, as after a pulled network cable.
    let waiting = place.link().unwrap();
    std::thread::sleep(Duration::from_millis(1300));
    let (_, status) = Host::new(waiting, 2).hello();
    assert!(!status.held);
}

#[test]
fn rubbish_on_the_line_harms_nobody() {
    let mut place = Tcp::new(options(Clock::Real));
    let mut rubbish = place.link().unwrap();
    let bytes: Vec<u8> = (0..100_000_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    rubbish.send(&bytes).unwrap();
    drop(rubbish);
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    assert_eq!(host.download(&counter(), |_| ()), Response::Done);
}

#[test]
fn a_start_that_stops_on_entry_stops_before_the_first_statement() {
    let mut place = Embedded::new(options(Clock::Real));
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    assert_eq!(host.download(&counter(), |_| ()), Response::Done);
    host.tell(Request::Start { cold: true, stop_on_entry: true });
    let stop = host.stopped();
    assert_eq!((stop.reason, stop.pc, stop.cycle), (StopReason::Entry, LOAD, 0));
    host.tell(Request::Stop);
    host.event("the stop of the PLC", |event| match event {
        Event::State(status) if status.plc == PlcState::Stopped => Some(()),
        _ => None,
    });
}

#[test]
fn the_real_clock_keeps_twenty_milliseconds() {
    let mut place =
        Embedded::new(TargetOptions { program: Some(counter()), start: true, ..options(Clock::Real) });
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    let (began, first) = (Instant::now(), host.status().cycle);
    std::thread::sleep(Duration::from_millis(600));
    let passed = host.status().cycle - first;
    let expected = began.elapsed().as_millis() as u64 / 20;
    assert!(passed.abs_diff(expected) <= 3, "{passed} cycles for {expected}");
}

#[test]
fn virtual_time_is_faster_and_requests_are_answered_meanwhile() {
    let mut place = Embedded::new(options(Clock::Virtual));
    let mut host = Host::new(place.link().unwrap(), 1);
    host.hello();
    assert_eq!(host.download(&counter(), |_| ()), Response::Done);
    start(&mut host);
    let began = Instant::now();
    let mut questions = 0_u32;
    while host.status().cycle < 5000 {
        questions += 1;
        assert!(began.elapsed() < Duration::from_secs(20), "100 s of PLC time take longer than 20 s");
    }
    assert!(began.elapsed() / (questions + 1) < Duration::from_millis(200));
}

#[test]
fn a_target_that_is_not_there_is_an_error_with_a_remedy() {
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let error = connect(&format!("tcp:127.0.0.1:{port}").parse().unwrap()).err().unwrap();
    assert!(matches!(error, ConnectError::NoTarget { .. }));
    let text = error.to_string();
    assert!(text.contains(&format!("technol target --listen tcp:127.0.0.1:{port}")), "{text}");

    let error = connect(&"serial:/dev/no-such-line".parse().unwrap()).err().unwrap();
    assert!(matches!(error, ConnectError::NoDevice { .. }), "{error:?}");
    assert!(error.to_string().contains("check that the cable is plugged in"), "{error}");

    let error = connect(&"tcp:no-such-host.invalid:1".parse().unwrap()).err().unwrap();
    assert!(matches!(error, ConnectError::UnknownHost { .. }), "{error:?}");
    assert!(matches!(connect(&Address::Embedded), Err(ConnectError::Embedded)));
}

#[test]
fn a_target_that_others_can_reach_needs_a_token() {
    let mut core = TargetCore::new(TargetOptions::default()).unwrap();
    let ended = AtomicBool::new(true);
    let mut told = Vec::new();
    let mut listen = |token: Option<&Token>| {
        let mut tell = |notice: Notice| told.push(notice.to_string());
        listen_tcp("0.0.0.0", 0, token, &mut |link| link, &mut core, &ended, &mut tell)
    };
    let error = listen(None).unwrap_err();
    assert!(matches!(error, ListenError::TokenNeeded { .. }));
    assert!(error.to_string().contains("give a token (`--token-file FILE`"), "{error}");
    listen(Some(&Token::new("a long secret token").unwrap())).unwrap();
    assert!(told[0].starts_with("warning: other computers can reach this target"), "{told:?}");
}

#[test]
fn only_who_knows_the_token_is_served() {
    let token = Token::new("a long secret token").unwrap();
    let mut place = Tcp::guarded(options(Clock::Real), Some(token.clone()));
    let address = place.address.clone();

    // Without one: the host says why it gets nowhere.
    let mut link = place.link().unwrap();
    let mut host = technol_wire::HostSession::new(1);
    let mut buffer = [0; 1000];
    let count = link.receive(&mut buffer, Duration::from_secs(5)).unwrap();
    host.receive(0, &buffer[..count]);
    let lost = technol_wire::HostEvent::LinkLost(technol_wire::LossReason::TokenNeeded);
    assert_eq!(host.next(), Some(lost));

    let other = Token::new("another secret token").unwrap();
    let error = Connector::new(address.clone(), Some(other)).connect().err().unwrap();
    assert!(error.to_string().contains("it has another token"), "{error}");
    let link = Connector::new(address, Some(token)).connect().unwrap();
    Host::new(link, 2).hello();
}
