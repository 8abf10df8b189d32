//! A debugger, as small as can be.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use technol_image::Program;
use technol_image::container::{encode_program, hash_bytes};
use technol_target::Link;
use technol_wire::message::{Event, Request, Response, Status, Stopped};
use technol_wire::{HostEvent, HostSession, Sample, Ticket};

/// Nothing in these tests takes this long.
const PATIENCE: Duration = Duration::from_secs(20);

pub(crate) struct Host {
    link: Box<dyn Link>,
    session: HostSession,
    began: Instant,
    responses: Vec<(Ticket, Response)>,
    events: VecDeque<Event>,
    downloaded: bool,
    pub(crate) samples: Vec<Sample>,
}

impl Host {
    pub(crate) fn new(link: Box<dyn Link>, session: u32) -> Host {
        let session = HostSession::with_timing(session, link.timing());
        let (responses, events) = (Vec::new(), VecDeque::new());
        Host {
            link,
            session,
            began: Instant::now(),
            responses,
            events,
            downloaded: false,
            samples: Vec::new(),
        }
    }

    fn now(&self) -> u64 {
        self.began.elapsed().as_micros() as u64
    }

    fn pump(&mut self) {
        let deadline = self.session.poll(self.now());
        let bytes = self.session.transmit();
        if !bytes.is_empty() {
            self.link.send(&bytes).unwrap();
        }
        let wait = deadline.map_or(0, |at| at.saturating_sub(self.now())).min(20_000);
        let mut buffer = [0; 4096];
        let count = self.link.receive(&mut buffer, Duration::from_micros(wait)).unwrap();
        self.session.receive(self.now(), &buffer[..count]);
        while let Some(event) = self.session.next() {
            match event {
                HostEvent::Response(ticket, response) => self.responses.push((ticket, response)),
                HostEvent::Event(event) => self.events.push_back(event),
                HostEvent::Sample(sample) => self.samples.push(sample),
                HostEvent::DownloadProgress { .. } | HostEvent::Stale(_) => {}
                HostEvent::DownloadDone => self.downloaded = true,
                HostEvent::LinkLost(reason) => panic!("link lost: {reason}"),
            }
        }
    }

    #[track_caller]
    fn until<T>(&mut self, what: &str, mut look: impl FnMut(&mut Host) -> Option<T>) -> T {
        let deadline = Instant::now() + PATIENCE;
        loop {
            if let Some(found) = look(self) {
                return found;
            }
            assert!(Instant::now() < deadline, "waited in vain for {what}; there is {:?}", self.events);
            self.pump();
        }
    }

    #[track_caller]
    fn answer(&mut self, ticket: Ticket) -> Response {
        self.until("an answer", |host| {
            let at = host.responses.iter().position(|(t, _)| *t == ticket)?;
            Some(host.responses.swap_remove(at).1)
        })
    }

    #[track_caller]
    pub(crate) fn ask(&mut self, request: Request) -> Response {
        let ticket = self.session.request(request);
        self.answer(ticket)
    }

    /// Asks for something that must succeed.
    #[track_caller]
    pub(crate) fn tell(&mut self, request: Request) {
        let what = format!("{request:?}");
        assert_eq!(self.ask(request), Response::Done, "{what}");
    }

    #[track_caller]
    pub(crate) fn hello(&mut self) -> (u32, Status) {
        let ticket = self.session.hello();
        match self.answer(ticket) {
            Response::Hello { boot, status, .. } => (boot, status),
            other => panic!("{other:?}"),
        }
    }

    #[track_caller]
    pub(crate) fn status(&mut self) -> Status {
        match self.ask(Request::Status) {
            Response::Status(status) => status,
            other => panic!("{other:?}"),
        }
    }

    /// Announces a program and sends the bytes given, which may be others.
    #[track_caller]
    pub(crate) fn download(&mut self, program: &Program, damage: impl FnOnce(&mut Vec<u8>)) -> Response {
        let mut bytes = encode_program(program);
        self.tell(Request::Download { len: bytes.len() as u32, hash: hash_bytes(&bytes) });
        damage(&mut bytes);
        self.downloaded = false;
        self.session.download(bytes);
        self.until("the end of the download", |host| host.downloaded.then_some(()));
        self.ask(Request::Commit)
    }

    #[track_caller]
    pub(crate) fn read_word(&mut self, addr: u32) -> u16 {
        match self.ask(Request::Read { pieces: vec![(addr, 1), (addr + 1, 1)] }) {
            Response::Memory { bytes, .. } => u16::from_le_bytes(bytes.try_into().unwrap()),
            other => panic!("{other:?}"),
        }
    }

    /// The next event that is looked for; others before it are passed over.
    #[track_caller]
    pub(crate) fn event<T>(&mut self, what: &str, mut look: impl FnMut(Event) -> Option<T>) -> T {
        self.until(what, |host| host.events.pop_front().and_then(&mut look))
    }

    #[track_caller]
    pub(crate) fn stopped(&mut self) -> Stopped {
        self.event("a stop", |event| match event {
            Event::Stopped(stopped) => Some(stopped),
            _ => None,
        })
    }

    /// Waits for a sample.
    #[track_caller]
    pub(crate) fn sample<T>(&mut self, what: &str, mut look: impl FnMut(&Sample) -> Option<T>) -> T {
        self.until(what, |host| host.samples.iter().find_map(&mut look))
    }

    pub(crate) fn forget_events(&mut self) {
        self.events.clear();
    }
}
