//! A target whose memory changes, a host that watches it, and the line between them, in virtual time.

use std::collections::BTreeMap;

use technol_wire::frame::kind;
use technol_wire::message::{Limits, PlcState, Request, Response, Status, Subscription};
use technol_wire::{
    HostEvent, HostSession, MechanismSample, Sample, SampleSource, TargetInput, TargetSession, Ticket,
    TraceSample,
};

/// Time of one byte at 115200 baud, in tenths of a microsecond.
const BYTE_TENTHS_US: u64 = 868;
/// A 20 ms cycle in microseconds.
pub(crate) const CYCLE: u64 = 20_000;
pub(crate) const SECOND: u64 = 1_000_000;
/// Bytes that the line carries in a second.
pub(crate) const LINE: usize = 11_520;

/// Small generator of repeatable randomness (xorshift64*).
#[derive(Clone)]
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

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    pub(crate) fn percent(&mut self, chance: u32) -> bool {
        self.next() % 100 < u64::from(chance)
    }
}

/// What the line does to frames, in percent.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Faults {
    pub(crate) lost: u32,
    pub(crate) doubled: u32,
    pub(crate) damaged: u32,
}

/// One direction.
pub(crate) struct Line {
    pub(crate) faults: Faults,
    random: Random,
    free_at_tenths: u64,
    travelling: Vec<(u64, Vec<u8>)>,
    /// Everything that was sent.
    pub(crate) bytes: usize,
    /// Of this, with their delimiters, what belongs to pings and pongs.
    pub(crate) pings: usize,
    zeros: usize,
    /// Frames of this kind do not arrive.
    pub(crate) dropped: u8,
}

impl Line {
    fn new(seed: u64) -> Self {
        let random = Random::new(seed);
        Line {
            faults: Faults::default(),
            random,
            free_at_tenths: 0,
            travelling: Vec::new(),
            bytes: 0,
            pings: 0,
            zeros: 0,
            dropped: 0,
        }
    }

    fn send(&mut self, now: u64, bytes: &[u8]) {
        self.bytes += bytes.len();
        for frame in bytes.split_inclusive(|b| *b == 0) {
            if frame == [0] {
                self.zeros = 1;
            } else {
                let zeros = std::mem::take(&mut self.zeros);
                if frame[1] & 0x7F == kind::PING {
                    self.pings += frame.len() + zeros;
                }
            }
            self.free_at_tenths = self.free_at_tenths.max(now * 10) + frame.len() as u64 * BYTE_TENTHS_US;
            let mut frame = frame.to_vec();
            if self.random.percent(self.faults.lost)
                || self.dropped != 0 && frame.get(1) == Some(&self.dropped)
            {
                continue;
            }
            if self.random.percent(self.faults.damaged) {
                let at = self.random.below(frame.len());
                frame[at] ^= 1 << self.random.below(8);
            }
            let arrival = self.free_at_tenths / 10;
            if self.random.percent(self.faults.doubled) {
                let late = self.random.next() % 60_000;
                self.travelling.push((arrival + late, frame.clone()));
            }
            self.travelling.push((arrival, frame));
        }
        self.travelling.sort_by_key(|t| t.0);
    }

    fn arrived(&mut self, now: u64) -> Vec<u8> {
        let count = self.travelling.partition_point(|t| t.0 <= now);
        self.travelling.drain(..count).flat_map(|t| t.1).collect()
    }
}

/// What there is to watch.
#[derive(Clone, Default)]
pub(crate) struct Plant {
    pub(crate) memory: Vec<u8>,
    pub(crate) mechanisms: BTreeMap<u16, MechanismSample>,
    pub(crate) traced: BTreeMap<u32, TraceSample>,
}

impl SampleSource for Plant {
    fn memory(&self) -> &[u8] {
        &self.memory
    }

    fn mechanism(&self, sequence: u16) -> MechanismSample {
        self.mechanisms.get(&sequence).copied().unwrap_or_default()
    }

    fn traced(&self, pc: u32) -> TraceSample {
        self.traced.get(&pc).copied().unwrap_or_default()
    }
}

pub(crate) struct World {
    pub(crate) now: u64,
    pub(crate) number: u32,
    pub(crate) cycle: u32,
    pub(crate) host: HostSession,
    pub(crate) target: TargetSession,
    pub(crate) to_target: Line,
    pub(crate) to_host: Line,
    pub(crate) plant: Plant,
    /// Cycle and plant of each number.
    pub(crate) history: BTreeMap<u32, (u32, Plant)>,
    pub(crate) samples: Vec<(u64, Sample)>,
    pub(crate) stale: Vec<(u64, u8)>,
    /// Frames of streams that came through, with their delimiters.
    pub(crate) heard: Vec<Vec<u8>>,
    pub(crate) responses: Vec<(u64, Ticket, Response)>,
    pub(crate) events: Vec<(u64, HostEvent)>,
    next_cycle: u64,
    /// At most so many bytes are handed over at once, and those before have left by then.
    pub(crate) driver: usize,
}

impl World {
    pub(crate) fn new(session: u32, memory: usize) -> Self {
        World {
            now: 0,
            number: 1000,
            cycle: 70_000,
            host: HostSession::new(session),
            target: TargetSession::new(limits()),
            to_target: Line::new(u64::from(session) * 2 + 1),
            to_host: Line::new(u64::from(session) * 2 + 2),
            plant: Plant { memory: vec![0; memory], ..Plant::default() },
            history: BTreeMap::new(),
            samples: Vec::new(),
            stale: Vec::new(),
            heard: Vec::new(),
            responses: Vec::new(),
            events: Vec::new(),
            next_cycle: CYCLE,
            driver: usize::MAX,
        }
    }

    /// Bytes the target has sent, but for answers to pings.
    pub(crate) fn bytes(&self) -> usize {
        self.to_host.bytes - self.to_host.pings
    }

    pub(crate) fn damage(&mut self, faults: Faults) {
        self.to_host.faults = faults;
        self.to_target.faults = faults;
    }

    /// Connects and subscribes, without a fault of the line.
    pub(crate) fn with(session: u32, memory: usize, subscriptions: &[Subscription]) -> Self {
        let mut world = World::new(session, memory);
        world.run(SECOND / 10, |_| {});
        for subscription in subscriptions {
            let ticket = world.host.request(Request::Subscribe(subscription.clone()));
            world.run(SECOND / 10, |_| {});
            assert_eq!(world.response(ticket), Some(&Response::Done), "{subscription:?}");
        }
        world
    }

    pub(crate) fn response(&self, ticket: Ticket) -> Option<&Response> {
        self.responses.iter().find(|(_, t, _)| *t == ticket).map(|(_, _, r)| r)
    }

    /// Lets so much time pass; `change` happens before each cycle ends.
    pub(crate) fn run(&mut self, time: u64, mut change: impl FnMut(&mut World)) {
        let until = self.now + time;
        while self.now < until {
            let bytes = self.to_host.arrived(self.now);
            for frame in bytes.split_inclusive(|b| *b == 0) {
                self.hear(frame);
            }
            self.host.poll(self.now);
            self.take();
            let bytes = self.host.transmit();
            self.to_target.send(self.now, &bytes);

            let bytes = self.to_target.arrived(self.now);
            self.target.receive(self.now, &bytes);
            self.target.poll(self.now);
            while let Some(input) = self.target.next() {
                self.act(input);
            }
            if self.now >= self.next_cycle {
                self.next_cycle += CYCLE;
                change(self);
                self.number = self.number.wrapping_add(1);
                self.cycle = self.cycle.wrapping_add(1);
                self.history.insert(self.number, (self.cycle, self.plant.clone()));
                self.target.streams().sample(self.number, self.cycle, &self.plant);
            }
            if self.driver == usize::MAX || self.to_host.free_at_tenths <= self.now * 10 {
                let bytes = self.target.transmit_within(self.driver);
                self.to_host.send(self.now, &bytes);
            }
            self.now += 500;
        }
    }

    fn hear(&mut self, frame: &[u8]) {
        self.host.receive(self.now, frame);
        if frame.len() > 2 && frame[1] == kind::STREAM {
            self.heard.push(frame.to_vec());
        }
        self.take();
    }

    fn take(&mut self) {
        while let Some(event) = self.host.next() {
            match event {
                HostEvent::Sample(sample) => self.samples.push((self.now, sample)),
                HostEvent::Stale(id) => self.stale.push((self.now, id)),
                HostEvent::Response(ticket, response) => self.responses.push((self.now, ticket, response)),
                other => self.events.push((self.now, other)),
            }
        }
    }

    fn act(&mut self, input: TargetInput) {
        let TargetInput::Request { seq, request } = input else { return };
        let response = match request {
            Request::Hello { version, .. } => {
                Response::Hello { version, limits: limits(), boot: 7, status: status(), features: 0 }
            }
            Request::Subscribe(subscription) => {
                let begun = self.target.streams().subscribe(&subscription, limits().max_payload, &self.plant);
                begun.map_or_else(Response::Failed, |()| Response::Done)
            }
            Request::Unsubscribe { id } => {
                self.target.streams().unsubscribe(id);
                Response::Done
            }
            Request::Read { pieces } => {
                let len = pieces.iter().map(|p| usize::from(p.1)).sum();
                Response::Memory { cycle: 0, bytes: vec![0xA5; len] }
            }
            _ => Response::Done,
        };
        self.target.respond(seq, &response);
    }
}

fn limits() -> Limits {
    Limits { max_payload: 240, max_read: 4096, max_breakpoints: 256, window: 8 }
}

fn status() -> Status {
    Status { plc: PlcState::Running, held: false, cycle: 0, program: None }
}
