//! The target as the session sees it: questions are answered, events queue up, and the protocol's timers run
//! whenever the link is pumped.

use std::collections::{HashMap, VecDeque};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use technol_wire::message::{Event, Limits, Request, Response, StopReason};
use technol_wire::{HostEvent, HostSession, Sample, Ticket};

use crate::connection::ByteLink;
use crate::errors::RequestError;

/// A question that is not answered for this long is given up, in seconds. The protocol itself gives up earlier
/// when the target is silent.
const ANSWER_SECONDS: u64 = 8;
/// How long a target gets to answer a goodbye, in microseconds.
const GOODBYE_US: u64 = 700_000;

/// Something the target said unasked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum TargetEvent {
    /// An event of the protocol.
    Event(Event),
    /// The link is gone; the text says why.
    Lost(String),
}

/// Something a stream told.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Streamed {
    /// A sample.
    Sample(Sample),
    /// Samples of this stream are missing.
    Stale(u8),
}

/// Samples kept for a session that is busy with something else; the oldest go first.
const STREAMED: usize = 1000;

/// How far a download is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Transfer {
    /// Bytes that have arrived.
    pub(crate) done: u32,
    /// Bytes in all.
    pub(crate) total: u32,
    /// Nothing is missing.
    pub(crate) complete: bool,
}

/// A link with the host side of the protocol on it.
pub(crate) struct TargetLink {
    link: Box<dyn ByteLink>,
    host: HostSession,
    started: Instant,
    events: VecDeque<TargetEvent>,
    streamed: VecDeque<Streamed>,
    responses: HashMap<Ticket, Response>,
    /// Answers nobody waits for any more.
    forgotten: Vec<Ticket>,
    transfer: Transfer,
    lost: Option<String>,
}

impl TargetLink {
    pub(crate) fn new(link: Box<dyn ByteLink>) -> Self {
        TargetLink {
            link,
            host: HostSession::new(session_number()),
            started: Instant::now(),
            events: VecDeque::new(),
            streamed: VecDeque::new(),
            responses: HashMap::new(),
            forgotten: Vec::new(),
            transfer: Transfer::default(),
            lost: None,
        }
    }

    /// What fits through this target; known once it said hello.
    pub(crate) fn limits(&self) -> Limits {
        let cautious = Limits { max_payload: 64, max_read: 256, max_breakpoints: 16, window: 1 };
        self.host.limits().unwrap_or(cautious)
    }

    /// What the target can do, bits of [`technol_wire::message::feature`].
    pub(crate) fn features(&self) -> u32 {
        self.host.features()
    }

    /// The next thing the target said.
    pub(crate) fn next_event(&mut self) -> Option<TargetEvent> {
        self.events.pop_front()
    }

    /// What the streams told since the last call.
    pub(crate) fn take_streamed(&mut self) -> VecDeque<Streamed> {
        std::mem::take(&mut self.streamed)
    }

    /// Bytes the line carries in a second, if that is a bound.
    pub(crate) fn bytes_per_second(&self) -> Option<u32> {
        self.link.bytes_per_second()
    }

    /// What was said about a program that has ended does not concern the next one.
    pub(crate) fn forget_stops(&mut self) {
        self.events.retain(|event| {
            !matches!(event, TargetEvent::Event(Event::Stopped(_) | Event::Resumed | Event::Fault(_)))
        });
    }

    /// Asks and waits for the answer. `Failed` answers are errors.
    pub(crate) fn ask(&mut self, request: Request) -> Result<Response, RequestError> {
        let ticket = self.host.request(request);
        self.wait(ticket)
    }

    /// Waits for the target's answer to the greeting.
    pub(crate) fn greet(&mut self) -> Result<Response, RequestError> {
        let ticket = self.host.hello();
        self.wait(ticket)
    }

    /// Sends without waiting; a refusal is not noticed.
    pub(crate) fn tell(&mut self, request: Request) {
        let ticket = self.host.request(request);
        self.forgotten.push(ticket);
    }

    /// Hands over the bytes of an announced program.
    pub(crate) fn download(&mut self, bytes: Vec<u8>) {
        self.transfer = Transfer { total: bytes.len() as u32, ..Transfer::default() };
        self.host.download(bytes);
    }

    /// How far the download is.
    pub(crate) fn transfer(&self) -> Transfer {
        self.transfer
    }

    /// Why the link is gone, if it is.
    pub(crate) fn lost(&self) -> Option<&str> {
        self.lost.as_deref()
    }

    /// A stop has been reported and not been taken up yet.
    pub(crate) fn has_stop(&self) -> bool {
        self.events.iter().any(|e| matches!(e, TargetEvent::Event(Event::Stopped(_))))
    }

    /// Takes out the stop at the entry of a program that has just started.
    pub(crate) fn take_entry(&mut self) -> bool {
        let is_entry = |e: &TargetEvent| matches!(e, TargetEvent::Event(Event::Stopped(s)) if s.reason == StopReason::Entry);
        let found = self.events.iter().position(is_entry);
        found.and_then(|at| self.events.remove(at)).is_some()
    }

    fn wait(&mut self, ticket: Ticket) -> Result<Response, RequestError> {
        let deadline = self.now() + ANSWER_SECONDS * 1_000_000;
        loop {
            if let Some(response) = self.responses.remove(&ticket) {
                return match response {
                    Response::Failed(failure) => Err(failure.into()),
                    other => Ok(other),
                };
            }
            if let Some(why) = &self.lost {
                return Err(RequestError::LinkLost(why.clone()));
            }
            if self.now() >= deadline {
                self.forgotten.push(ticket);
                return Err(RequestError::Silent(ANSWER_SECONDS));
            }
            self.pump(Duration::from_millis(20));
        }
    }

    /// Sends what is due and receives what comes within `wait`.
    pub(crate) fn pump(&mut self, wait: Duration) {
        if self.lost.is_some() {
            return;
        }
        let deadline = self.host.poll(self.now());
        if let Err(error) = self.send() {
            return self.lose(error.to_string());
        }
        let due = deadline.map_or(wait, |at| Duration::from_micros(at.saturating_sub(self.now())));
        let mut buffer = [0_u8; 4096];
        match self.link.receive(&mut buffer, wait.min(due)) {
            Ok(0) => {}
            Ok(n) => {
                self.host.receive(self.now(), &buffer[..n]);
                // Answers to what came (acknowledgements, the next piece of a download) go out at once.
                self.host.poll(self.now());
                if let Err(error) = self.send() {
                    return self.lose(error.to_string());
                }
            }
            Err(error) => return self.lose(error.to_string()),
        }
        self.sort_out();
    }

    fn send(&mut self) -> std::io::Result<()> {
        let bytes = self.host.transmit();
        if bytes.is_empty() { Ok(()) } else { self.link.send(&bytes) }
    }

    fn sort_out(&mut self) {
        while let Some(event) = self.host.next() {
            match event {
                HostEvent::Response(ticket, response) => {
                    if let Some(at) = self.forgotten.iter().position(|t| *t == ticket) {
                        self.forgotten.swap_remove(at);
                    } else {
                        self.responses.insert(ticket, response);
                    }
                }
                HostEvent::Event(event) => self.events.push_back(TargetEvent::Event(event)),
                HostEvent::DownloadProgress { done, total } => {
                    self.transfer = Transfer { done, total, complete: self.transfer.complete };
                }
                HostEvent::Sample(sample) => self.stream(Streamed::Sample(sample)),
                HostEvent::Stale(id) => self.stream(Streamed::Stale(id)),
                HostEvent::DownloadDone => self.transfer.complete = true,
                HostEvent::LinkLost(reason) => self.lose(reason.to_string()),
            }
        }
    }

    fn stream(&mut self, streamed: Streamed) {
        if self.streamed.len() == STREAMED {
            self.streamed.pop_front();
        }
        self.streamed.push_back(streamed);
    }

    fn lose(&mut self, why: String) {
        if self.lost.is_none() {
            self.events.push_back(TargetEvent::Lost(why.clone()));
            self.lost = Some(why);
        }
    }

    fn now(&self) -> u64 {
        self.link.time().unwrap_or_else(|| self.started.elapsed()).as_micros() as u64
    }

    /// Says goodbye and gives the target a moment to hear it.
    pub(crate) fn goodbye(&mut self, stop: bool) {
        if self.lost.is_some() {
            return;
        }
        let ticket = self.host.request(Request::Goodbye { stop });
        let deadline = self.now() + GOODBYE_US;
        while self.lost.is_none() && self.now() < deadline && !self.responses.contains_key(&ticket) {
            self.pump(Duration::from_millis(20));
        }
    }
}

/// Differs from session to session, so that a target tells a new session from a reconnect.
fn session_number() -> u32 {
    let nanos = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_nanos() as u64);
    let mixed = (nanos ^ (u64::from(std::process::id()) << 32)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed >> 32) as u32
}
