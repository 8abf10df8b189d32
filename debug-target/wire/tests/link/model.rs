//! Two ends on a cable in virtual time.

use std::collections::VecDeque;

use technol_link_model::{Cable, Faults, LineOptions};
use technol_wire::message::{Failure, Limits, PlcState, Request, Response, Status};
use technol_wire::{HostEvent, HostSession, TargetInput, TargetSession, Ticket};

/// A longer download is refused.
pub(crate) const MOST_DOWNLOAD: u32 = 100_000;

pub(crate) fn limits() -> Limits {
    Limits { max_payload: 240, max_read: 4096, max_breakpoints: 256, window: 8 }
}

pub(crate) fn status() -> Status {
    Status { plc: PlcState::Empty, held: false, cycle: 0, program: None }
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
    pub(crate) cable: Cable,
    pub(crate) application: Application,
    pub(crate) seen: VecDeque<(u64, HostEvent)>,
}

impl World {
    pub(crate) fn new(session: u32, faults: Faults) -> Self {
        Self::on(session, LineOptions { faults, ..LineOptions::default() })
    }

    pub(crate) fn on(session: u32, line: LineOptions) -> Self {
        World {
            now: 0,
            host: HostSession::new(session),
            target: TargetSession::new(limits()),
            cable: Cable::new(line, u64::from(session)),
            application: Application::default(),
            seen: VecDeque::new(),
        }
    }

    /// Runs both ends until `done` or `until` (virtual microseconds); tells whether it was `done`.
    pub(crate) fn run(&mut self, until: u64, mut done: impl FnMut(&World) -> bool) -> bool {
        loop {
            let bytes = self.cable.to_host.arrived(self.now);
            self.host.receive(self.now, &bytes);
            let host_next = self.host.poll(self.now).unwrap_or(u64::MAX);
            let bytes = self.host.transmit();
            self.cable.to_target.send(self.now, &bytes);

            let bytes = self.cable.to_target.arrived(self.now);
            self.target.receive(self.now, &bytes);
            let target_next = self.target.poll(self.now).unwrap_or(u64::MAX);
            while let Some(input) = self.target.next() {
                self.act(input);
            }
            let bytes = self.target.transmit();
            self.cable.to_host.send(self.now, &bytes);

            while let Some(event) = self.host.next() {
                self.seen.push_back((self.now, event));
            }
            if done(self) {
                return true;
            }
            let next = host_next
                .min(target_next)
                .min(self.cable.next_arrival().unwrap_or(u64::MAX))
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
                    Request::Hello { version, .. } => Response::Hello {
                        version: *version,
                        limits: limits(),
                        boot: 7,
                        status: status(),
                        features: 0,
                    },
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
