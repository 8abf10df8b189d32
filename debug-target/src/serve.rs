//! The loop that joins a core and a link.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use technol_wire::message::Limits;
use technol_wire::{TargetInput, TargetSession};

use crate::core::TargetCore;
use crate::link::Link;

/// Longest wait before the shutdown flag is looked at again.
const LONGEST_WAIT: Duration = Duration::from_millis(50);
/// A connection over which no host says hello for this long is given up.
const HELLO_TIMEOUT: Duration = Duration::from_secs(5);
/// Events in the queue beyond which virtual time waits for the link.
const CROWD: usize = 64;

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
    let end = Service::new(link.as_ref()).run(link.as_mut(), core, shutdown);
    core.host_lost();
    end
}

/// One link being served.
struct Service {
    session: TargetSession,
    limits: Limits,
    began: Instant,
    /// The host fell silent.
    host_lost: bool,
    allowance: Allowance,
}

impl Service {
    fn new(link: &dyn Link) -> Self {
        let limits = link.limits();
        Service {
            session: TargetSession::with_timing(limits, link.timing()),
            limits,
            began: Instant::now(),
            host_lost: false,
            allowance: Allowance::new(link.bytes_per_second()),
        }
    }

    fn run(&mut self, link: &mut dyn Link, core: &mut TargetCore, shutdown: &AtomicBool) -> ServeEnd {
        let mut buffer = vec![0; 16 * 1024];
        while !shutdown.load(Ordering::Relaxed) {
            let due = core.advance(Instant::now(), self.session.events_waiting() > CROWD);
            let wait = match self.transfer(link, core, due) {
                Ok(wait) => wait,
                Err(error) => return ServeEnd::LinkGone(error),
            };
            match link.receive(&mut buffer, wait) {
                Ok(count) => self.take(&buffer[..count], core),
                Err(error) => return ServeEnd::LinkGone(error),
            }
            if self.is_abandoned(link) {
                return ServeEnd::LinkGone(io::Error::new(io::ErrorKind::TimedOut, "the debugger is silent"));
            }
        }
        ServeEnd::Shutdown
    }

    /// Nobody is at the other end of a connection that keeps others from getting in.
    fn is_abandoned(&self, link: &dyn Link) -> bool {
        let watched = link.timing().silence_us.is_some() && !link.outlives_host();
        watched && (self.host_lost || !self.session.is_open() && self.began.elapsed() > HELLO_TIMEOUT)
    }

    fn now(&self) -> u64 {
        self.began.elapsed().as_micros() as u64
    }

    /// Bytes came: acts on what they say and answers at once.
    fn take(&mut self, bytes: &[u8], core: &mut TargetCore) {
        self.session.receive(self.now(), bytes);
        self.act(core);
    }

    fn act(&mut self, core: &mut TargetCore) {
        while let Some(input) = self.session.next() {
            match input {
                TargetInput::Request { seq, request } => {
                    let response = core.answer(request, self.limits);
                    self.session.respond(seq, &response);
                }
                TargetInput::Chunk(chunk) => core.chunk(&chunk),
                TargetInput::HostLost => {
                    self.host_lost = true;
                    core.host_lost();
                }
            }
        }
    }

    /// Sends what is to be sent; answers how long to wait for bytes.
    fn transfer(
        &mut self,
        link: &mut dyn Link,
        core: &mut TargetCore,
        due: Option<Instant>,
    ) -> io::Result<Duration> {
        let now = self.now();
        let timer = self.session.poll(now);
        self.act(core);
        for event in core.take_events() {
            self.session.event(&event);
        }
        let budget = self.allowance.budget(Instant::now());
        let mut wait = LONGEST_WAIT;
        if budget > 0 {
            let bytes = self.session.transmit_within(budget);
            if !bytes.is_empty() {
                link.send(&bytes)?;
                self.allowance.spend(bytes.len());
            }
        }
        wait = wait.min(self.allowance.recovery());
        if let Some(timer) = timer {
            wait = wait.min(Duration::from_micros(timer.saturating_sub(now)));
        }
        if let Some(due) = due {
            wait = wait.min(due.saturating_duration_since(Instant::now()));
        }
        Ok(wait)
    }
}

/// How many bytes may be handed over to a slow line, so that what is urgent never waits behind a full buffer.
#[derive(Debug)]
struct Allowance {
    per_second: Option<u32>,
    /// Bytes; negative after a frame that went beyond.
    credit: f64,
    at: Instant,
}

/// Bytes that may be under way at once.
const BURST: f64 = 512.0;

impl Allowance {
    fn new(per_second: Option<u32>) -> Self {
        Allowance { per_second, credit: BURST, at: Instant::now() }
    }

    fn budget(&mut self, now: Instant) -> usize {
        let Some(rate) = self.per_second else { return usize::MAX };
        let earned = now.saturating_duration_since(self.at).as_secs_f64() * f64::from(rate);
        self.at = now;
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
        let start = allowance.at;
        assert_eq!(allowance.budget(start), 512);
        allowance.spend(712);
        assert_eq!(allowance.budget(start + Duration::from_millis(10)), 0);
        assert!(allowance.recovery() > Duration::from_millis(10));
        assert_eq!(allowance.budget(start + Duration::from_millis(30)), 100);
        assert_eq!(allowance.budget(start + Duration::from_secs(9)), 512, "silence is not saved up");
        assert_eq!(Allowance::new(None).budget(start), usize::MAX);
    }
}
