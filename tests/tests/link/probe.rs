//! A host without an editor: asks one thing after another, in the time of the world.

use std::collections::HashMap;

use technol_image::Program;
use technol_image::container::{encode_program, hash_bytes};
use technol_wire::message::{Event, Request, Response, Status, Stopped};
use technol_wire::{HostEvent, HostSession, LossReason, Ticket};

use crate::world::World;

/// A second.
pub(crate) const SECOND: u64 = 1_000_000;

pub(crate) struct Probe {
    pub(crate) host: HostSession,
    answers: HashMap<Ticket, Response>,
    pub(crate) events: Vec<Event>,
    pub(crate) downloaded: bool,
    /// When and why the link was lost.
    pub(crate) lost: Option<(u64, LossReason)>,
}

impl Probe {
    /// A new session, greeted.
    pub(crate) fn connect(world: &mut World, session: u32) -> Probe {
        let mut probe = Probe {
            host: HostSession::new(session),
            answers: HashMap::new(),
            events: Vec::new(),
            downloaded: false,
            lost: None,
        };
        let hello = probe.host.hello();
        assert!(matches!(probe.answer(world, hello), Response::Hello { .. }));
        probe
    }

    /// One look at the link, at most until `until`.
    pub(crate) fn pump(&mut self, world: &mut World, until: u64) {
        let deadline = self.host.poll(world.now);
        let bytes = self.host.transmit();
        if !bytes.is_empty() {
            world.send(&bytes);
        }
        let wait = deadline.unwrap_or(until).min(until).saturating_sub(world.now);
        let mut buffer = [0; 4096];
        let count = world.receive(&mut buffer, wait);
        self.host.receive(world.now, &buffer[..count]);
        while let Some(event) = self.host.next() {
            match event {
                HostEvent::Response(ticket, response) => drop(self.answers.insert(ticket, response)),
                HostEvent::Event(event) => self.events.push(event),
                HostEvent::DownloadDone => self.downloaded = true,
                HostEvent::LinkLost(reason) => self.lost = Some((world.now, reason)),
                _ => {}
            }
        }
    }

    /// Lets time pass.
    pub(crate) fn run(&mut self, world: &mut World, micros: u64) {
        let until = world.now + micros;
        while world.now < until {
            self.pump(world, until);
            if self.lost.is_some() {
                // A host that has given up does not look any more.
                while world.now < until {
                    world.receive(&mut [0; 4096], until - world.now);
                }
            }
        }
    }

    #[track_caller]
    pub(crate) fn until(&mut self, world: &mut World, what: &str, mut is_so: impl FnMut(&Probe) -> bool) {
        let deadline = world.now + 60 * SECOND;
        while !is_so(self) {
            assert!(
                world.now < deadline && self.lost.is_none(),
                "no {what}: {:?} {:?}",
                self.lost,
                self.events
            );
            self.pump(world, deadline);
        }
    }

    /// Lets time pass until something is so; `false`: the link was lost before.
    #[track_caller]
    pub(crate) fn reaches(&mut self, world: &mut World, mut is_so: impl FnMut(&Probe) -> bool) -> bool {
        let deadline = world.now + 60 * SECOND;
        while !is_so(self) {
            assert!(world.now < deadline, "it does not come: {:?}", self.events);
            if self.lost.is_some() {
                return false;
            }
            // A host that has just lost its link wants nothing more, and is asked whether it has.
            let until = world.now + SECOND / 10;
            self.pump(world, until);
        }
        true
    }

    /// The answer; none when the link is lost, and then it is not known whether the request was acted on.
    #[track_caller]
    pub(crate) fn try_ask(&mut self, world: &mut World, request: Request) -> Option<Response> {
        let ticket = self.host.request(request);
        self.reaches(world, |p| p.answers.contains_key(&ticket)).then_some(())?;
        self.answers.remove(&ticket)
    }

    #[track_caller]
    fn answer(&mut self, world: &mut World, ticket: Ticket) -> Response {
        self.until(world, "answer", |p| p.answers.contains_key(&ticket));
        self.answers.remove(&ticket).expect("an answer")
    }

    #[track_caller]
    pub(crate) fn ask(&mut self, world: &mut World, request: Request) -> Response {
        let ticket = self.host.request(request);
        self.answer(world, ticket)
    }

    #[track_caller]
    pub(crate) fn tell(&mut self, world: &mut World, request: Request) {
        let what = format!("{request:?}");
        assert_eq!(self.ask(world, request), Response::Done, "{what}");
    }

    #[track_caller]
    pub(crate) fn status(&mut self, world: &mut World) -> Status {
        match self.ask(world, Request::Status) {
            Response::Status(status) => status,
            other => panic!("{other:?}"),
        }
    }

    #[track_caller]
    pub(crate) fn load(&mut self, world: &mut World, program: &Program) {
        let bytes = encode_program(program);
        self.tell(world, Request::Download { len: bytes.len() as u32, hash: hash_bytes(&bytes) });
        self.downloaded = false;
        self.host.download(bytes);
        self.until(world, "end of the download", |p| p.downloaded);
        self.tell(world, Request::Commit);
        self.tell(world, Request::Start { cold: true, stop_on_entry: false });
    }

    /// The next stop.
    #[track_caller]
    pub(crate) fn stopped(&mut self, world: &mut World) -> Stopped {
        self.until(world, "stop", |p| p.events.iter().any(|e| matches!(e, Event::Stopped(_))));
        let at = self.events.iter().position(|e| matches!(e, Event::Stopped(_))).expect("a stop");
        match self.events.remove(at) {
            Event::Stopped(stopped) => stopped,
            other => panic!("{other:?}"),
        }
    }
}
