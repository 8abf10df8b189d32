//! Bytes from a line on which anything may be said: frames, messages, and whatever requests in whatever state of the
//! target. Nothing panics, nothing hangs, and what the target says itself is always well-formed and bounded.

#[allow(dead_code)] // parts of it are for the tests of the target
#[path = "../../../debug-target/tests/session/program.rs"]
mod program;

use std::time::{Duration, Instant};

use technol_target::{Clock, TargetCore, TargetEnd, TargetOptions};
use technol_wire::frame::{self, kind};
use technol_wire::message::{Chunk, ChunkAck, Event, Limits, PROTOCOL_VERSION, Request, Response};
use technol_wire::{FrameDecoder, HostSession, Timing};

const LIMITS: Limits = Limits { max_payload: 240, max_read: 2048, max_breakpoints: 256, window: 8 };
/// Things that happen in one input.
const MOST: usize = 150;
/// Bytes that one turn of the target may say: a whole window of events and one long answer.
const MOST_SAID: usize = 64 * 1024;

/// Any bytes, taken for a line and for the content of a frame.
pub(crate) fn frames(input: &[u8]) {
    let mut decoder = FrameDecoder::new(240);
    for frame in input.iter().filter_map(|b| decoder.push(*b)).filter_map(Result::ok) {
        assert!(frame.payload.len() <= 242, "longer than asked for");
        let mut again = Vec::new();
        frame::encode(frame.kind, frame.seq, &frame.payload, &mut again);
        assert_eq!(frame::decode(&again[..again.len() - 1]), Ok(frame));
    }
    let [first, second, payload @ ..] = input else { return };
    let mut line = Vec::new();
    frame::encode(*first, *second, payload, &mut line);
    assert_eq!(line.iter().position(|b| *b == 0), Some(line.len() - 1));
    let frame = frame::decode(&line[..line.len() - 1]).expect("it comes back");
    assert_eq!((frame.kind, frame.seq, &frame.payload[..]), (*first, *second, payload));
}

fn message<T: serde::Serialize + serde::de::DeserializeOwned>(bytes: &[u8]) {
    if let Ok(message) = postcard::from_bytes::<T>(bytes) {
        // There may be several ways to write a number, but only one to write it again.
        let written = postcard::to_allocvec(&message).expect("what was read can be written");
        let again: T = postcard::from_bytes(&written).expect("what was written can be read");
        assert_eq!(postcard::to_allocvec(&again).expect("and written again"), written);
    }
}

/// Any bytes, taken for each kind of message, and heard by a host.
pub(crate) fn messages(input: &[u8]) {
    message::<Request>(input);
    message::<Response>(input);
    message::<Event>(input);
    message::<Chunk>(input);
    message::<ChunkAck>(input);
    for is_open in [false, true] {
        let mut host = HostSession::new(1);
        host.poll(0);
        drop(host.transmit());
        if is_open {
            let hello = Response::Hello {
                version: PROTOCOL_VERSION,
                limits: LIMITS,
                boot: 1,
                status: TargetCore::new(TargetOptions::default()).expect("a target").status(),
                features: u32::MAX,
            };
            hear(&mut host, kind::RESPONSE, 1, &postcard::to_allocvec(&hello).expect("a message"));
            host.request(Request::Status);
            host.download(vec![7; 1000]);
        }
        for (n, kind) in
            [kind::RESPONSE, kind::EVENT, kind::CHUNK_ACK, kind::STREAM, 0xFF].into_iter().enumerate()
        {
            hear(&mut host, kind, n as u8, input);
            hear(&mut host, kind, 2, input);
            hear(&mut host, kind, 0, input);
            host.poll(n as u64 * 10_000);
            assert!(host.transmit().len() < MOST_SAID);
        }
    }
}

fn hear(host: &mut HostSession, kind: u8, seq: u8, content: &[u8]) {
    let mut payload = vec![0x80];
    payload.extend_from_slice(content);
    let mut line = Vec::new();
    frame::encode(kind, seq, &payload, &mut line);
    host.receive(0, &line);
    frame::encode(kind, seq, content, &mut line);
    host.receive(0, &line);
    while host.next().is_some() {}
}

/// A target that any input is said to.
struct Bench {
    core: TargetCore,
    end: TargetEnd,
    ear: FrameDecoder,
    now: Instant,
    seq: u8,
}

impl Bench {
    fn new(state: u8) -> Bench {
        let program = (state & 1 != 0).then(program::counter);
        let start = program.is_some() && state & 2 != 0;
        let options = TargetOptions { clock: Clock::Told, program, start, ..TargetOptions::default() };
        let mut bench = Bench {
            core: TargetCore::new(options).expect("a target"),
            end: TargetEnd::new(LIMITS, Timing::default(), Some(11_520)),
            ear: FrameDecoder::new(240),
            now: Instant::now(),
            seq: 0,
        };
        if state & 4 != 0 {
            bench.hello(9);
        }
        if state & 8 != 0 {
            bench.request(&Request::SetBreakpoints { pcs: vec![program::STORE] });
            bench.pass(60);
        }
        bench
    }

    fn hello(&mut self, session: u32) {
        self.request(&Request::Hello { version: PROTOCOL_VERSION, session });
    }

    fn request(&mut self, request: &Request) {
        let message = postcard::to_allocvec(request).expect("a message");
        self.say(&message);
    }

    /// A request with the number that is expected next.
    fn say(&mut self, message: &[u8]) {
        let mut payload = vec![0x80];
        payload.extend_from_slice(message);
        self.frame(kind::REQUEST, self.seq, &payload);
        self.seq = self.seq.wrapping_add(1);
    }

    fn frame(&mut self, kind: u8, seq: u8, payload: &[u8]) {
        let mut line = Vec::new();
        frame::encode(kind, seq, payload, &mut line);
        self.line(&line);
    }

    fn line(&mut self, bytes: &[u8]) {
        self.end.receive(self.now, bytes, &mut self.core);
        self.turn();
    }

    fn turn(&mut self) {
        let due = self.end.advance(self.now, &mut self.core);
        let (bytes, wait) = self.end.turn(self.now, due, &mut self.core);
        assert!(bytes.len() < MOST_SAID, "{} bytes at once", bytes.len());
        assert!(wait < Duration::from_secs(1));
        for frame in bytes.iter().filter_map(|b| self.ear.push(*b)) {
            let frame = frame.expect("what the target says is whole");
            assert!(frame.kind & 0x80 != 0);
        }
    }

    fn pass(&mut self, millis: u64) {
        for _ in 0..millis.div_ceil(20) {
            self.now += Duration::from_millis(20);
            self.turn();
        }
    }
}

/// An input: the state to begin in, then what happens, one byte each with what belongs to it.
pub(crate) fn target(input: &[u8]) {
    let Some((state, mut rest)) = input.split_first() else { return };
    let mut bench = Bench::new(*state);
    for _ in 0..MOST {
        let Some((what, after)) = rest.split_first() else { break };
        let len = after.first().map_or(0, |n| usize::from(*n)).min(after.len().saturating_sub(1));
        let content = after.get(1..=len).unwrap_or_default();
        rest = match what & 7 {
            0 => {
                bench.pass(20);
                after
            }
            1 => {
                bench.hello(u32::from(*what));
                after
            }
            2 => {
                bench.pass(1000);
                after
            }
            3 => {
                bench.line(content);
                after.get(len + 1..).unwrap_or_default()
            }
            4 => {
                let [kind, seq, payload @ ..] = content else { break };
                bench.frame(*kind, *seq, payload);
                after.get(len + 1..).unwrap_or_default()
            }
            // Most of what happens should get as far as being acted on.
            _ => {
                bench.say(content);
                after.get(len + 1..).unwrap_or_default()
            }
        };
    }
    // Whatever was said: a debugger that comes now is served.
    bench.pass(1100);
    bench.hello(0xFFFF_FFFF);
    bench.pass(200);
    assert!(bench.core.status().cycle < 1_000_000);
}
