//! The loop that joins a core and a link.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use technol_wire::message::{Failure, Limits, Request, Response};
use technol_wire::{TargetInput, TargetSession, Timing};

use crate::core::TargetCore;
use crate::link::Link;
use crate::sampling;

/// Longest wait before the shutdown flag is looked at again.
const LONGEST_WAIT: Duration = Duration::from_millis(50);
/// A connection over which no host says hello for this long is given up.
const HELLO_TIMEOUT: Duration = Duration::from_secs(5);
/// Events in the queue beyond which virtual time waits for the link.
const CROWD: usize = 64;
/// Tenths of a slow line that streams may take.
const STREAM_SHARE: u32 = 6;

/// Why serving ended.
#[derive(Debug)]
pub enum ServeEnd {
    /// The link is gone.
    LinkGone(io::Error),
    /// Asked for.
    Shutdown,
}

/// Serves a host over a link until the link is gone or `shutdown` is set. The core keeps its program and its state
/// for the next link; a program that the debugger held runs on.
pub fn serve(mut link: Box<dyn Link>, core: &mut TargetCore, shutdown: &AtomicBool) -> ServeEnd {
    let mut end = TargetEnd::new(link.limits(), link.timing(), link.bytes_per_second());
    let why = run(&mut end, link.as_mut(), core, shutdown);
    core.host_lost();
    why
}

fn run(end: &mut TargetEnd, link: &mut dyn Link, core: &mut TargetCore, shutdown: &AtomicBool) -> ServeEnd {
    let began = Instant::now();
    let watched = link.timing().silence_us.is_some() && !link.outlives_host();
    let mut buffer = vec![0; 16 * 1024];
    while !shutdown.load(Ordering::Relaxed) {
        let due = end.advance(Instant::now(), core);
        let (bytes, wait) = end.turn(Instant::now(), due, core);
        let sent = if bytes.is_empty() { Ok(()) } else { link.send(&bytes) };
        match sent.and_then(|()| link.receive(&mut buffer, wait)) {
            Ok(count) => end.receive(Instant::now(), &buffer[..count], core),
            Err(error) => return ServeEnd::LinkGone(error),
        }
        // Nobody is at the other end of a connection that keeps others from getting in.
        if watched && (end.host_lost || !end.session.is_open() && began.elapsed() > HELLO_TIMEOUT) {
            return ServeEnd::LinkGone(io::Error::new(io::ErrorKind::TimedOut, "the debugger is silent"));
        }
    }
    ServeEnd::Shutdown
}

/// A core's end of a link, without the link: bytes and times go in, bytes come out. [`serve`] drives it with a link
/// and the clock; a test may drive it with a simulated cable in virtual time.
pub struct TargetEnd {
    session: TargetSession,
    limits: Limits,
    began: Option<Instant>,
    /// The host fell silent.
    host_lost: bool,
    allowance: Allowance,
}

impl TargetEnd {
    /// One end of a new link; `bytes_per_second`: what a slow line carries.
    #[must_use]
    pub fn new(limits: Limits, timing: Timing, bytes_per_second: Option<u32>) -> TargetEnd {
        let mut session = TargetSession::with_timing(limits, timing);
        session.streams().set_rate(bytes_per_second.map(|rate| rate / 10 * STREAM_SHARE));
        TargetEnd {
            session,
            limits,
            began: None,
            host_lost: false,
            allowance: Allowance::new(bytes_per_second),
        }
    }

    /// Lets time pass at the core, and takes the samples that the host has asked for; answers when there is something
    /// to do again, see [`TargetCore::advance`].
    pub fn advance(&mut self, now: Instant, core: &mut TargetCore) -> Option<Instant> {
        let crowded = self.is_crowded();
        core.advance_watched(now, crowded, Some(self.session.streams()))
    }

    /// More events wait than the link carries: virtual time should wait for them.
    #[must_use]
    pub fn is_crowded(&self) -> bool {
        self.session.events_waiting() > CROWD
    }

    /// Microseconds since the first use, which is what the protocol counts in.
    fn micros(&mut self, now: Instant) -> u64 {
        let began = *self.began.get_or_insert(now);
        now.saturating_duration_since(began).as_micros() as u64
    }

    /// Bytes came: acts on what they say and answers at once.
    pub fn receive(&mut self, now: Instant, bytes: &[u8], core: &mut TargetCore) {
        let micros = self.micros(now);
        self.session.receive(micros, bytes);
        self.act(core);
    }

    fn act(&mut self, core: &mut TargetCore) {
        while let Some(input) = self.session.next() {
            match input {
                TargetInput::Request { seq, request } => {
                    let announces = matches!(request, Request::Download { .. });
                    let mut response = self.answer(request, core);
                    if let Response::Echo { damaged, .. } = &mut response {
                        *damaged = self.session.damaged_frames();
                    }
                    self.session.respond(seq, &response);
                    if announces && response == Response::Done {
                        self.session.already_arrived(core.arrived());
                    }
                }
                TargetInput::Chunk(chunk) => core.chunk(&chunk),
                TargetInput::HostLost => {
                    self.host_lost = true;
                    core.host_lost();
                }
            }
        }
    }

    /// Streams belong to this end of the link, all else to the core.
    fn answer(&mut self, request: Request, core: &mut TargetCore) -> Response {
        let loads = matches!(request, Request::Commit);
        let streams = self.session.streams();
        let response = match request {
            Request::Subscribe(subscription) => {
                let simulation = core.simulation().ok_or(Failure::NoProgram);
                let max_payload = self.limits.max_payload;
                let begun =
                    simulation.and_then(|s| sampling::subscribe(streams, &subscription, max_payload, s));
                begun.map_or_else(Response::Failed, |()| Response::Done)
            }
            Request::Unsubscribe { id } => {
                streams.unsubscribe(id);
                Response::Done
            }
            other => core.answer(other, self.limits),
        };
        if loads && response == Response::Done {
            // Their addresses are those of the program before.
            self.session.streams().clear();
        }
        response
    }

    /// The bytes to send now, and how long to wait for others at most. `due`: when the core has to do something
    /// again, as [`TargetCore::advance`] said.
    pub fn turn(&mut self, now: Instant, due: Option<Instant>, core: &mut TargetCore) -> (Vec<u8>, Duration) {
        let micros = self.micros(now);
        let timer = self.session.poll(micros);
        self.act(core);
        for event in core.take_events() {
            self.session.event(&event);
        }
        let budget = self.allowance.budget(now);
        let bytes = if budget > 0 { self.session.transmit_within(budget) } else { Vec::new() };
        self.allowance.spend(bytes.len());
        let mut wait = LONGEST_WAIT.min(self.allowance.recovery());
        // What cannot be sent yet is no reason to look again at once.
        if let Some(timer) = timer.filter(|_| budget > 0) {
            wait = wait.min(Duration::from_micros(timer.saturating_sub(micros)));
        }
        if let Some(due) = due {
            wait = wait.min(due.saturating_duration_since(now));
        }
        (bytes, wait)
    }
}

/// How many bytes may be handed over to a slow line, so that what is urgent never waits behind a full buffer.
#[derive(Debug)]
struct Allowance {
    per_second: Option<u32>,
    /// Bytes; negative after a frame that went beyond.
    credit: f64,
    /// When that was so.
    at: Option<Instant>,
}

/// Bytes that may be under way at once.
const BURST: f64 = 512.0;

impl Allowance {
    fn new(per_second: Option<u32>) -> Self {
        Allowance { per_second, credit: BURST, at: None }
    }

    fn budget(&mut self, now: Instant) -> usize {
        let Some(rate) = self.per_second else { return usize::MAX };
        let passed = now.saturating_duration_since(self.at.unwrap_or(now));
        let earned = passed.as_secs_f64() * f64::from(rate);
        self.at = Some(now);
        self.credit = (self.credit + earned).min(BURST);
        self.credit.max(0.0) as usize
    }

    fn spend(&mut self, bytes: usize) {
        self.credit -= bytes as f64;
    }

    /// Until something may be sent again.
    fn recovery(&self) -> Duration {
        match self.per_second {
            Some(rate) if self.credit < 1.0 => {
                Duration::from_secs_f64((1.0 - self.credit) / f64::from(rate)) + Duration::from_micros(100)
            }
            _ => Duration::MAX,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_line_is_given_what_it_can_carry() {
        let mut allowance = Allowance::new(Some(10_000));
        let start = Instant::now();
        assert_eq!(allowance.budget(start), 512);
        allowance.spend(712);
        assert_eq!(allowance.budget(start + Duration::from_millis(10)), 0);
        assert!(allowance.recovery() > Duration::from_millis(10));
        assert_eq!(allowance.budget(start + Duration::from_millis(30)), 100);
        assert_eq!(allowance.budget(start + Duration::from_secs(9)), 512, "silence is not saved up");
        assert_eq!(Allowance::new(None).budget(start), usize::MAX);
    }
}
