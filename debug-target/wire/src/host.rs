//! The programmer's end.

use alloc::collections::VecDeque;
use alloc::vec::Vec;
use core::fmt;

use crate::bulk::Download;
use crate::frame::{self, Frame, FrameDecoder, MAX_PAYLOAD, kind};
use crate::message::{
    Chunk, ChunkAck, Event, Failure, Limits, PROTOCOL_VERSION, Request, Response, Subscription,
};
use crate::parts::{self, Assembly, InOrder};
use crate::silence::Silence;
use crate::stream::{Freshness, Listener, Sample};
use crate::timing::Timing;

/// Payload of requests before the target has told its limits.
const FIRST_PAYLOAD: usize = 64;

/// Zeros that stand for the fields of Hello that an older target does not send.
const MISSING_FIELDS: [u8; 16] = [0; 16];

/// Names a request; comes back with its response.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Ticket(pub u32);

/// What a host session has to tell.
#[derive(Clone, Debug, PartialEq)]
pub enum HostEvent {
    /// A request was answered. The opening Hello is answered like any other, with [`Response::Hello`].
    Response(Ticket, Response),
    /// Something happened at the target. Events come in their order, each once; between events and responses
    /// there is no order (a stop may arrive before the answer to the resume that led to it).
    Event(Event),
    /// The download got further.
    DownloadProgress {
        /// Bytes that have arrived.
        done: u32,
        /// Bytes in all.
        total: u32,
    },
    /// Every byte has arrived; now [`Request::Commit`].
    DownloadDone,
    /// A sample of a stream, each number once.
    Sample(Sample),
    /// The values of the stream with this number may be out of date, until its next sample comes.
    Stale(u8),
    /// The end of this session; nothing comes after it, open requests stay unanswered.
    LinkLost(LossReason),
}

/// Why a session ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LossReason {
    /// Nothing was heard for too long.
    Silent,
    /// The target is there but a request, or the download, stayed without answer however often it was repeated.
    NoAnswer,
    /// The target lets nobody in without a token, and none was given.
    TokenNeeded,
    /// The target has ended the session: it heard nothing of this end for too long, or was started anew.
    Forgotten,
}

impl fmt::Display for LossReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LossReason::Silent => {
                "the target no longer answers; check that it is switched on, the cable, the baud rate, and that no other debugger holds it"
            }
            LossReason::NoAnswer => {
                "the target is there but does not answer requests; the line damages too much, or the target is of another make"
            }
            LossReason::TokenNeeded => {
                "the target asks for a token; give the one it was started with (`--token-file`, `tokenFile`, or TECHNOL_TOKEN)"
            }
            LossReason::Forgotten => {
                "the target has ended the session; it was started anew, or heard nothing from here for a second"
            }
        })
    }
}

#[derive(Clone, Debug)]
struct InFlight {
    ticket: Ticket,
    seq: u8,
    parts: Vec<Vec<u8>>,
    /// Next part to send; all are sent when it is `parts.len()`.
    cursor: usize,
    /// Time of the last sending, or of the last sign that the answer is on its way.
    since: u64,
    tries: u32,
    is_hello: bool,
    is_download: bool,
    subscription: Option<Subscription>,
    /// Streams end with the program they were about.
    replaces_program: bool,
}

impl InFlight {
    /// How long to wait before the request is sent again. A target that is slow is asked less often; a Hello is
    /// answered at once, or nobody is there.
    fn patience(&self, timing: &Timing) -> u64 {
        if self.is_hello { timing.ping_us } else { timing.resend_us << self.tries.saturating_sub(1).min(1) }
    }
}

/// One session with a target, from Hello to the end of the link. After [`HostEvent::LinkLost`] make a new one.
#[derive(Clone, Debug)]
pub struct HostSession {
    session: u32,
    timing: Timing,
    now: u64,
    decoder: FrameDecoder,
    damaged: u32,
    queue: VecDeque<(Ticket, Request)>,
    in_flight: Option<InFlight>,
    answer: Assembly,
    next_ticket: u32,
    next_seq: u8,
    limits: Option<Limits>,
    features: u32,
    /// Said about the download before its bytes are there.
    early_ack: Option<ChunkAck>,
    /// Requests that were sent again.
    repeated: u32,
    event_expected: u8,
    event: InOrder,
    event_ack: Option<u8>,
    bulk: Option<Vec<u8>>,
    download: Option<Download>,
    download_tag: u8,
    out: VecDeque<HostEvent>,
    silence: Silence,
    last_heard: u64,
    last_sent: Option<u64>,
    last_ping: Option<u64>,
    ping_due: bool,
    streams: Listener,
    /// Asked by this end for itself: nobody waits for the answers.
    own: Vec<Ticket>,
    lost: bool,
}

impl HostSession {
    /// Opens a session: a Hello goes first by itself, see [`HostSession::hello`]. `session` should be random.
    #[must_use]
    pub fn new(session: u32) -> Self {
        Self::with_timing(session, Timing::default())
    }

    /// As [`HostSession::new`], with other times.
    #[must_use]
    pub fn with_timing(session: u32, timing: Timing) -> Self {
        let hello = Request::Hello { version: PROTOCOL_VERSION, session };
        HostSession {
            session,
            timing,
            now: 0,
            decoder: FrameDecoder::new(usize::from(MAX_PAYLOAD)),
            damaged: 0,
            queue: VecDeque::from([(Ticket(0), hello)]),
            in_flight: None,
            answer: Assembly::default(),
            next_ticket: 1,
            // A random start keeps a late answer to an earlier session from being taken for ours.
            next_seq: session as u8,
            limits: None,
            features: 0,
            early_ack: None,
            repeated: 0,
            event_expected: 0,
            event: InOrder::default(),
            event_ack: None,
            bulk: None,
            download: None,
            download_tag: 0,
            out: VecDeque::new(),
            silence: Silence::new(timing.silence_us, timing.ping_us),
            last_heard: 0,
            last_sent: None,
            last_ping: None,
            ping_due: false,
            streams: Listener::default(),
            own: Vec::new(),
            lost: false,
        }
    }

    /// The ticket of the Hello that opens the session.
    #[must_use]
    pub fn hello(&self) -> Ticket {
        Ticket(0)
    }

    /// Queues a request. They are sent one at a time, in this order, and acted on exactly once.
    /// A Hello is not needed here; before the opening one is answered it only gives that one's ticket.
    pub fn request(&mut self, request: Request) -> Ticket {
        if matches!(request, Request::Hello { .. }) && self.limits.is_none() {
            return self.hello();
        }
        // What still comes of an old stream is not taken for the new one, and an ended one is not missed.
        if let Request::Subscribe(Subscription { id, .. }) | Request::Unsubscribe { id } = request {
            self.streams.close(id);
        }
        let ticket = Ticket(self.next_ticket);
        self.next_ticket += 1;
        let request = match request {
            Request::Hello { version, .. } => Request::Hello { version, session: self.session },
            other => other,
        };
        self.queue.push_back((ticket, request));
        ticket
    }

    /// Sends the bytes that a [`Request::Download`] before it announced, as soon as that is answered with
    /// [`Response::Done`]. If it is refused, they are dropped.
    pub fn download(&mut self, bytes: Vec<u8>) {
        self.download = None;
        self.bulk = Some(bytes);
    }

    /// How far the values of a stream can be relied on; `None`: there is none of that number.
    #[must_use]
    pub fn freshness(&self, id: u8) -> Option<Freshness> {
        self.streams.freshness(id)
    }

    /// What the target told in its answer to Hello.
    #[must_use]
    pub fn limits(&self) -> Option<Limits> {
        self.limits
    }

    /// What the target can do, bits of [`feature`](crate::message::feature); 0 before its answer to Hello.
    #[must_use]
    pub fn features(&self) -> u32 {
        self.features
    }

    /// Requests that were sent again so far: a measure of the cable.
    #[must_use]
    pub fn repeated_requests(&self) -> u32 {
        self.repeated
    }

    /// Frames that arrived damaged so far: a measure of the cable.
    #[must_use]
    pub fn damaged_frames(&self) -> u32 {
        self.damaged
    }

    /// True after [`HostEvent::LinkLost`].
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.lost
    }

    /// Takes bytes from the link.
    pub fn receive(&mut self, now: u64, bytes: &[u8]) {
        self.now = self.now.max(now);
        for byte in bytes {
            match self.decoder.push(*byte) {
                Some(Ok(frame)) if !self.lost => self.take(&frame),
                Some(Err(_)) => self.damaged = self.damaged.saturating_add(1),
                _ => {}
            }
        }
    }

    /// The next thing to tell.
    #[allow(clippy::should_implement_trait)] // not an iterator: more may come after `None`
    pub fn next(&mut self) -> Option<HostEvent> {
        self.out.pop_front()
    }

    fn take(&mut self, frame: &Frame) {
        if frame.kind & 0x80 == 0 {
            return; // our own echo
        }
        self.silence.heard();
        self.last_heard = self.now;
        match frame.kind {
            kind::RESPONSE => self.take_response(frame),
            kind::EVENT => self.take_event(frame),
            kind::CHUNK_ACK => self.take_chunk_ack(frame),
            // A target that knows us has no reason to ask.
            kind::CHALLENGE if self.limits.is_none() => {
                self.lose(LossReason::TokenNeeded);
            }
            kind::STREAM => {
                let told = self.streams.take(frame.seq, &frame.payload, self.now);
                let told = told.map(|t| t.map_or_else(HostEvent::Stale, HostEvent::Sample));
                self.out.extend(told);
            }
            _ => {}
        }
    }

    fn take_response(&mut self, frame: &Frame) {
        let Some(in_flight) = self.in_flight.as_mut().filter(|r| r.seq == frame.seq) else { return };
        in_flight.since = self.now;
        in_flight.tries = in_flight.tries.min(1);
        let Some(message) = self.answer.add(frame.seq, &frame.payload) else { return };
        // An answer of a later version says nothing to us, but it is one.
        let response = decode_response(message, in_flight.is_hello);
        if in_flight.is_hello {
            match &response {
                Response::Hello { limits, features, .. } => {
                    self.limits = Some(*limits);
                    self.features = *features;
                }
                Response::Failed(_) => {}
                _ => return, // left over from another session
            }
        }
        if !in_flight.is_hello && response == Response::Failed(Failure::NoSession) {
            self.lose(LossReason::Forgotten);
            return;
        }
        let Some(done) = self.in_flight.take() else { return };
        if done.is_download {
            self.early_ack = None;
            if response == Response::Done {
                self.download_tag = done.seq;
            } else {
                self.bulk = None;
            }
        }
        if done.replaces_program && response == Response::Done {
            self.streams.clear();
        }
        if response == Response::Done
            && let Some(subscription) = done.subscription
        {
            self.streams.open(subscription, self.now);
        }
        if let Some(at) = self.own.iter().position(|ticket| *ticket == done.ticket) {
            self.own.swap_remove(at);
            return;
        }
        self.out.push_back(HostEvent::Response(done.ticket, response));
    }

    fn take_event(&mut self, frame: &Frame) {
        if self.limits.is_none() {
            return;
        }
        if frame.seq == self.event_expected {
            self.event_expected = self.event_expected.wrapping_add(1);
            // An event that a later version added is acknowledged and otherwise passed over.
            if let Some(event) = self.event.add(&frame.payload).and_then(|m| postcard::from_bytes(&m).ok()) {
                self.out.push_back(HostEvent::Event(event));
            }
        }
        self.event_ack = Some(self.event_expected.wrapping_sub(1));
    }

    fn take_chunk_ack(&mut self, frame: &Frame) {
        let Ok(ack) = postcard::from_bytes::<ChunkAck>(&frame.payload) else { return };
        let Some(download) = self.download.as_mut().filter(|d| d.tag == frame.seq) else {
            if self.download.is_none() && frame.seq == self.download_tag {
                self.early_ack = Some(ack);
            }
            return;
        };
        let before = download.acknowledged();
        download.take_ack(&ack, self.now);
        let (done, total) = (download.acknowledged(), download.total());
        if done != before {
            self.out.push_back(HostEvent::DownloadProgress { done: done as u32, total: total as u32 });
        }
        self.finish_download();
    }

    fn finish_download(&mut self) {
        if self.download.as_ref().is_some_and(Download::is_done) {
            self.download = None;
            self.out.push_back(HostEvent::DownloadDone);
        }
    }

    /// Lets time pass. Answers when to call again at the latest; `None` once the link is lost.
    pub fn poll(&mut self, now: u64) -> Option<u64> {
        self.now = self.now.max(now);
        let now = self.now;
        if self.lost {
            return None;
        }
        if self.silence.look(now) {
            return self.lose(LossReason::Silent);
        }
        let mut deadline = now + self.timing.ping_us;
        deadline = self.silence.deadline(now).map_or(deadline, |d| deadline.min(d));
        if let Some(request) = self.in_flight.as_mut().filter(|r| r.cursor == r.parts.len()) {
            let wait = request.patience(&self.timing);
            if now >= request.since + wait {
                if request.tries > self.timing.retries {
                    return self.lose(LossReason::NoAnswer);
                }
                request.cursor = 0;
                self.repeated = self.repeated.saturating_add(1);
                deadline = now;
            } else {
                deadline = deadline.min(request.since + wait);
            }
        }
        match self.download.as_mut().map(|d| d.poll(now, self.timing.retries)) {
            Some(Ok(next)) => deadline = next.map_or(deadline, |d| deadline.min(d)),
            Some(Err(_)) => return self.lose(LossReason::NoAnswer),
            None => {}
        }
        self.look_at_streams();
        let ping_us = self.timing.ping_us;
        let quiet = |at: Option<u64>| at.is_none_or(|at| now >= at + ping_us);
        self.ping_due = self.limits.is_some()
            && (quiet(self.last_sent) || quiet(Some(self.last_heard)))
            && quiet(self.last_ping);
        Some(deadline)
    }

    fn look_at_streams(&mut self) {
        let now = self.now;
        while let Some(id) = self.streams.look(now) {
            self.out.push_back(HostEvent::Stale(id));
        }
        // A target that ended a stream by itself is asked for it again; nobody waits for that answer.
        while let Some(subscription) = self.streams.ended(now) {
            let ticket = self.request(Request::Subscribe(subscription));
            self.own.push(ticket);
        }
    }

    fn lose(&mut self, reason: LossReason) -> Option<u64> {
        self.lost = true;
        self.in_flight = None;
        self.download = None;
        self.bulk = None;
        self.queue.clear();
        self.streams.clear();
        self.out.push_back(HostEvent::LinkLost(reason));
        None
    }

    /// The bytes to send now.
    #[must_use]
    pub fn transmit(&mut self) -> Vec<u8> {
        self.transmit_within(usize::MAX)
    }

    /// As [`HostSession::transmit`], but stops after the frame that reaches `budget` bytes: for links with a
    /// buffer, where what waits here can still be overtaken by what is more urgent.
    #[must_use]
    pub fn transmit_within(&mut self, budget: usize) -> Vec<u8> {
        let mut out = Vec::new();
        if self.lost {
            return out;
        }
        let idle_us = self.timing.idle_us;
        if self.last_sent.is_none_or(|at| self.now >= at + idle_us) {
            out.push(frame::DELIMITER);
        }
        let empty = out.len();
        while out.len() < budget && self.send_one(&mut out) {}
        if out.len() == empty {
            out.clear();
        } else {
            self.last_sent = Some(self.now);
        }
        out
    }

    /// Appends the most urgent frame, if there is any.
    fn send_one(&mut self, out: &mut Vec<u8>) -> bool {
        if let Some(seq) = self.event_ack.take() {
            frame::encode(kind::EVENT_ACK, seq, &[], out);
            return true;
        }
        if self.in_flight.is_none() {
            self.start_request();
        }
        if let Some(request) = &mut self.in_flight
            && let Some(part) = request.parts.get(request.cursor)
        {
            frame::encode(kind::REQUEST, request.seq, part, out);
            request.cursor += 1;
            request.since = self.now;
            if request.cursor == request.parts.len() {
                request.tries += 1;
            }
            return true;
        }
        if core::mem::take(&mut self.ping_due) {
            self.last_ping = Some(self.now);
            frame::encode(kind::PING, 0, &[], out);
            return true;
        }
        if let Some(payload) = self.streams.say(self.now) {
            frame::encode(kind::LISTENING, 0, &payload, out);
            return true;
        }
        self.start_download();
        if let Some(download) = &mut self.download {
            let tag = download.tag;
            if let Some((offset, bytes)) = download.next(self.now) {
                let chunk = Chunk { offset, bytes: bytes.to_vec() };
                frame::encode(kind::CHUNK, tag, &postcard::to_allocvec(&chunk).unwrap_or_default(), out);
                return true;
            }
        }
        false
    }

    fn max_payload(&self) -> usize {
        self.limits.map_or(FIRST_PAYLOAD, |l| usize::from(l.max_payload.min(MAX_PAYLOAD)))
    }

    fn start_request(&mut self) {
        while let Some((ticket, request)) = self.queue.pop_front() {
            // Plain data into a growing vector: encoding has no way to fail.
            let message = postcard::to_allocvec(&request).unwrap_or_default();
            let Some(parts) = parts::split(&message, self.max_payload()) else {
                let refused = Response::Failed(Failure::TooLarge);
                self.out.push_back(HostEvent::Response(ticket, refused));
                continue;
            };
            let seq = self.next_seq;
            self.next_seq = seq.wrapping_add(1);
            self.answer.clear();
            self.in_flight = Some(InFlight {
                ticket,
                seq,
                parts,
                cursor: 0,
                since: self.now,
                tries: 0,
                is_hello: ticket == self.hello(),
                is_download: matches!(request, Request::Download { .. }),
                replaces_program: matches!(request, Request::Commit),
                subscription: if let Request::Subscribe(s) = request { Some(s) } else { None },
            });
            return;
        }
    }

    /// Begins a download once its announcement is answered.
    fn start_download(&mut self) {
        let announcing = self.in_flight.as_ref().is_some_and(|r| r.is_download)
            || self.queue.iter().any(|(_, r)| matches!(r, Request::Download { .. }));
        let Some(limits) = self.limits.filter(|_| !announcing) else { return };
        if let Some(bytes) = self.bulk.take() {
            let window = usize::from(limits.window);
            let mut download = Download::new(bytes, self.download_tag, self.max_payload(), window);
            if let Some(ack) = self.early_ack.take() {
                download.take_ack(&ack, self.now);
            }
            self.download = Some(download);
            self.finish_download();
        }
    }
}

/// An answer; of one of a later version only that it is one. The answer to Hello may be shorter or longer than this
/// version's: what is missing is 0, and what is behind the fields known here is passed over.
fn decode_response(mut message: Vec<u8>, is_hello: bool) -> Response {
    if is_hello {
        message.extend_from_slice(&MISSING_FIELDS);
    }
    postcard::from_bytes(&message).unwrap_or(Response::Failed(Failure::Unsupported))
}
