//! A target at one end of a cable in virtual time; the other end is a link that any host can use.

use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use technol_dap::{ByteLink, Connector, TargetSpec};
use technol_link_model::{Cable, LineOptions};
use technol_target::{Clock, TargetCore, TargetEnd, TargetOptions};
use technol_wire::message::Limits;
use technol_wire::{FrameDecoder, Timing};

/// What a serial line at 115200 baud takes.
pub(crate) const LIMITS: Limits =
    Limits { max_payload: 240, max_read: 2048, max_breakpoints: 256, window: 8 };

/// A frame as it passed the host's end, with the virtual microsecond. Of the target's, when it was sent is noted too.
#[derive(Clone, Debug)]
pub(crate) struct Passed {
    pub(crate) at: u64,
    pub(crate) from_host: bool,
    pub(crate) kind: u8,
    /// Number of the message that begins with it.
    pub(crate) what: Option<u8>,
}

/// Target and cable.
pub(crate) struct World {
    pub(crate) core: TargetCore,
    end: TargetEnd,
    pub(crate) cable: Cable,
    base: Instant,
    /// Virtual microseconds.
    pub(crate) now: u64,
    /// Without it the target neither hears nor says anything, and its time stands still.
    pub(crate) power: bool,
    arrived: Vec<u8>,
    /// Frames that the target sent, with the time of sending.
    pub(crate) sent: Vec<Passed>,
    pub(crate) passed: Vec<Passed>,
    ears: [FrameDecoder; 3],
    /// Links that were opened.
    pub(crate) opened: u32,
}

impl World {
    pub(crate) fn new(line: LineOptions, options: TargetOptions) -> World {
        let core = TargetCore::new(TargetOptions { clock: Clock::Told, ..options }).expect("a target");
        World {
            core,
            end: fresh_end(line),
            cable: Cable::new(line, 1),
            base: Instant::now(),
            now: 0,
            power: true,
            arrived: Vec::new(),
            sent: Vec::new(),
            passed: Vec::new(),
            ears: std::array::from_fn(|_| FrameDecoder::new(4096)),
            opened: 0,
        }
    }

    /// The target is switched off and on: program and session are gone.
    pub(crate) fn restart(&mut self, line: LineOptions, options: TargetOptions) {
        self.core = TargetCore::new(TargetOptions { clock: Clock::Told, ..options }).expect("a target");
        self.end = fresh_end(line);
        self.power = true;
    }

    /// Lets time pass until something has arrived at the host, or `until`.
    pub(crate) fn run(&mut self, until: u64) {
        loop {
            let next = if self.power { self.turn() } else { u64::MAX };
            let bytes = self.cable.to_host.arrived(self.now);
            note(&mut self.ears[1], &mut self.passed, self.now, false, &bytes);
            self.arrived.extend(bytes);
            if !self.arrived.is_empty() || self.now >= until {
                return;
            }
            let arrival = self.cable.next_arrival().unwrap_or(u64::MAX);
            self.now = next.min(arrival).max(self.now + 1).min(until);
        }
    }

    fn turn(&mut self) -> u64 {
        let now = self.base + Duration::from_micros(self.now);
        let bytes = self.cable.to_target.arrived(self.now);
        if !bytes.is_empty() {
            self.end.receive(now, &bytes, &mut self.core);
        }
        let due = self.end.advance(now, &mut self.core);
        let (bytes, wait) = self.end.turn(now, due, &mut self.core);
        note(&mut self.ears[2], &mut self.sent, self.now, false, &bytes);
        self.cable.to_host.send(self.now, &bytes);
        self.now + (wait.as_micros() as u64).max(1)
    }

    pub(crate) fn send(&mut self, bytes: &[u8]) {
        note(&mut self.ears[0], &mut self.passed, self.now, true, bytes);
        self.cable.to_target.send(self.now, bytes);
    }

    pub(crate) fn receive(&mut self, buffer: &mut [u8], micros: u64) -> usize {
        self.run(self.now + micros);
        let count = buffer.len().min(self.arrived.len());
        for (to, from) in buffer.iter_mut().zip(self.arrived.drain(..count)) {
            *to = from;
        }
        count
    }
}

fn fresh_end(line: LineOptions) -> TargetEnd {
    TargetEnd::new(LIMITS, Timing::default(), Some(line.baud / 10))
}

fn note(ear: &mut FrameDecoder, log: &mut Vec<Passed>, at: u64, from_host: bool, bytes: &[u8]) {
    let frames = bytes.iter().filter_map(|b| ear.push(*b)).filter_map(Result::ok);
    log.extend(frames.map(|frame| Passed {
        at,
        from_host,
        kind: frame.kind,
        what: frame.payload.get(1).copied(),
    }));
}

/// The world, shared between a test and the adapter.
#[derive(Clone)]
pub(crate) struct Shared(pub(crate) Arc<Mutex<World>>);

impl Shared {
    pub(crate) fn new(line: LineOptions, options: TargetOptions) -> Shared {
        Shared(Arc::new(Mutex::new(World::new(line, options))))
    }

    /// Waits until so much virtual time has passed; the adapter lets it pass, unless it is without a link.
    pub(crate) fn think(&self, micros: u64) {
        let until = self.world().now + micros;
        let patience = Instant::now() + Duration::from_secs(2);
        while self.world().now < until && Instant::now() < patience {
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    pub(crate) fn world(&self) -> MutexGuard<'_, World> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl ByteLink for Shared {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.world().send(bytes);
        Ok(())
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        let count = self.world().receive(buffer, timeout.as_micros() as u64);
        if count == 0 {
            // Virtual time need not race while nothing happens.
            std::thread::sleep(Duration::from_micros(100));
        }
        Ok(count)
    }

    fn time(&self) -> Option<Duration> {
        Some(Duration::from_micros(self.world().now))
    }
}

impl Connector for Shared {
    /// The plug is always in; whether the cable is whole is another question.
    fn connect(&self, _target: &TargetSpec) -> Result<Box<dyn ByteLink>, String> {
        let mut world = self.world();
        let until = world.now + 50_000;
        while world.now < until {
            world.run(until);
            world.arrived.clear();
        }
        world.opened += 1;
        Ok(Box::new(self.clone()))
    }
}
