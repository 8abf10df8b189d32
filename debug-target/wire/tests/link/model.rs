//! A cable in virtual time, and two ends on it.

use std::collections::VecDeque;

use technol_wire::message::{Failure, Limits, PlcState, Request, Response, Status};
use technol_wire::{HostEvent, HostSession, TargetInput, TargetSession, Ticket};

/// Time of one byte at 115200 baud, in tenths of a microsecond.
const BYTE_TENTHS_US: u64 = 868;

/// A longer download is refused.
pub(crate) const MOST_DOWNLOAD: u32 = 100_000;

pub(crate) fn limits() -> Limits {
    Limits { max_payload: 240, max_read: 4096, max_breakpoints: 256, window: 8 }
}

pub(crate) fn status() -> Status {
    Status { plc: PlcState::Empty, held: false, cycle: 0, program: None }
}

/// Small generator of repeatable randomness (xorshift64*).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    pub(crate) fn percent(&mut self, chance: u32) -> bool {
        self.next() % 100 < u64::from(chance)
    }
}

/// What the cable does to frames, in percent.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Faults {
    pub(crate) lost: u32,
    pub(crate) doubled: u32,
    pub(crate) reordered: u32,
    pub(crate) bit_error: u32,
    pub(crate) byte_lost: u32,
}

/// One direction.
pub(crate) struct Line {
    faults: Faults,
    random: Random,
    free_at_tenths: u64,
    /// Arrival time in microseconds and bytes.
    travelling: Vec<(u64, Vec<u8>)>,
    pub(crate) cut: bool,
    pub(crate) bytes: usize,
}

impl Line {
    fn new(faults: Faults, seed: u64) -> Self {
        let random = Random::new(seed);
        Line { faults, random, free_at_tenths: 0, travelling: Vec::new(), cut: false, bytes: 0 }
    }

    fn send(&mut self, now: u64, bytes: &[u8]) {
        self.bytes += bytes.len();
        for frame in bytes.split_inclusive(|b| *b == 0) {
            self.free_at_tenths = self.free_at_tenths.max(now * 10) + frame.len() as u64 * BYTE_TENTHS_US;
            if self.cut || self.random.percent(self.faults.lost) {
                continue;
            }
            let mut frame = frame.to_vec();
            let at = self.random.next() as usize % frame.len();
            if self.random.percent(self.faults.bit_error) {
                frame[at] ^= 1 << (self.random.next() % 8);
            }
            if self.random.percent(self.faults.byte_lost) {
                frame.remove(at);
            }
            let mut arrival = self.free_at_tenths / 10;
            if self.random.percent(self.faults.doubled) {
                self.travelling.push((arrival + self.random.next() % 60_000, frame.clone()));
            }
            if self.random.percent(self.faults.reordered) {
                arrival += self.random.next() % 60_000;
            }
            self.travelling.push((arrival, frame));
        }
        self.travelling.sort_by_key(|t| t.0);
    }

    fn arrived(&mut self, now: u64) -> Vec<u8> {
        let count = self.travelling.partition_point(|t| t.0 <= now);
        self.travelling.drain(..count).flat_map(|t| t.1).collect()
    }

    fn next_arrival(&self) -> u64 {
        self.travelling.first().map_or(u64::MAX, |t| t.0)
    }
}

/// What the target's application did.
#[derive(Default)]
pub(crate) struct Application {
    pub(crate) acted: Vec<Request>,
    pub(crate) download: Vec<u8>,
    pub(crate) host_lost_at: Option<u64>,
}

pub(crate) struct World {
    pub(crate) now: u64,
    pub(crate) host: HostSession,
    pub(crate) target: TargetSession,
    pub(crate) to_target: Line,
    pub(crate) to_host: Line,
    pub(crate) application: Application,
    pub(crate) seen: VecDeque<(u64, HostEvent)>,
}

impl World {
    pub(crate) fn new(session: u32, faults: Faults) -> Self {
        World {
            now: 0,
            host: HostSession::new(session),
            target: TargetSession::new(limits()),
            to_target: Line::new(faults, u64::from(session) * 2 + 1),
            to_host: Line::new(faults, u64::from(session) * 2 + 2),
            application: Application::default(),
            seen: VecDeque::new(),
        }
    }

    /// Runs both ends until `done` or `until` (virtual microseconds); tells whether it was `done`.
    pub(crate) fn run(&mut self, until: u64, mut done: impl FnMut(&World) -> bool) -> bool {
        loop {
            let bytes = self.to_host.arrived(self.now);
            self.host.receive(self.now, &bytes);
            let host_next = self.host.poll(self.now).unwrap_or(u64::MAX);
            let bytes = self.host.transmit();
            self.to_target.send(self.now, &bytes);

            let bytes = self.to_target.arrived(self.now);
            self.target.receive(self.now, &bytes);
            let target_next = self.target.poll(self.now).unwrap_or(u64::MAX);
            while let Some(input) = self.target.next() {
                self.act(input);
            }
            let bytes = self.target.transmit();
            self.to_host.send(self.now, &bytes);

            while let Some(event) = self.host.next() {
                self.seen.push_back((self.now, event));
            }
            if done(self) {
                return true;
            }
            let next = host_next
                .min(target_next)
                .min(self.to_host.next_arrival())
                .min(self.to_target.next_arrival())
                .max(self.now + 1);
            if next > until {
                self.now = until;
                return false;
            }
            self.now = next;
        }
    }

    fn act(&mut self, input: TargetInput) {
        match input {
            TargetInput::Request { seq, request } => {
                let response = match &request {
                    Request::Hello { version, .. } => {
                        Response::Hello { version: *version, limits: limits(), boot: 7, status: status() }
                    }
                    Request::Download { len, .. } if *len > MOST_DOWNLOAD => {
                        Response::Failed(Failure::TooLarge)
                    }
                    Request::Download { len, .. } => {
                        self.application.download = vec![0; *len as usize];
                        Response::Done
                    }
                    // As long as asked for, so that answers of every length occur.
                    Request::Read { pieces } => {
                        let len = pieces.iter().map(|p| usize::from(p.1)).sum();
                        Response::Memory { cycle: 0, bytes: vec![0xA5; len] }
                    }
                    _ => Response::Done,
                };
                self.application.acted.push(request);
                self.target.respond(seq, &response);
            }
            TargetInput::Chunk(chunk) => {
                let at = chunk.offset as usize;
                self.application.download[at..at + chunk.bytes.len()].copy_from_slice(&chunk.bytes);
            }
            TargetInput::HostLost => self.application.host_lost_at = Some(self.now),
        }
    }

    pub(crate) fn response(&self, ticket: Ticket) -> Option<&Response> {
        self.seen.iter().find_map(|(_, event)| match event {
            HostEvent::Response(t, response) if *t == ticket => Some(response),
            _ => None,
        })
    }

    pub(crate) fn connect(&mut self) {
        let hello = self.host.hello();
        let until = self.now + 5_000_000;
        assert!(self.run(until, |w| w.response(hello).is_some()), "no answer to Hello");
    }
}
