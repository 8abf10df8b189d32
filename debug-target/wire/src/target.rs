//! The machine's end.

use alloc::collections::VecDeque;
use alloc::format;
use alloc::vec::Vec;

use crate::arrived::Arrived;
use crate::events::EventQueue;
use crate::frame::{self, Frame, FrameDecoder, kind};
use crate::message::{
    Chunk, ChunkAck, Event, Failure, KNOWN_REQUESTS, Limits, PROTOCOL_VERSION, Request, Response,
};
use crate::parts::{self, Assembly};
use crate::silence::Silence;
use crate::stream::Streams;
use crate::timing::Timing;

/// Answers that are kept to be given again.
const KEPT_ANSWERS: usize = 4;

/// What a target session has to tell.
#[derive(Clone, Debug, PartialEq)]
pub enum TargetInput {
    /// Act on this, once, and call [`TargetSession::respond`] with its number. A Hello opens a session.
    Request {
        /// Number for the response.
        seq: u8,
        /// What to do.
        request: Request,
    },
    /// A new piece of the download that was announced last; it lies within the announced length.
    Chunk(Chunk),
    /// Nothing was heard from the host for too long; the session is over.
    HostLost,
}

#[derive(Clone, Debug)]
struct Reception {
    tag: u8,
    len: u32,
    arrived: Arrived,
}

#[derive(Clone, Debug)]
struct Session {
    id: u32,
    /// Number of the last request taken.
    last: u8,
    /// It is not answered yet.
    pending: bool,
    /// It announces a download of this length.
    announced: Option<u32>,
    answers: VecDeque<(u8, Vec<Vec<u8>>)>,
    reception: Option<Reception>,
    /// Hello is answered; events may go.
    open: bool,
}

/// The target's side of one link, over any number of host sessions one after another.
#[derive(Clone, Debug)]
pub struct TargetSession {
    limits: Limits,
    timing: Timing,
    now: u64,
    decoder: FrameDecoder,
    damaged: u32,
    request: Assembly,
    session: Option<Session>,
    events: EventQueue,
    dropped_events: u32,
    /// Encoded frames' parts of responses that wait to be sent: kind, number, payload.
    urgent: VecDeque<(u8, u8, Vec<u8>)>,
    replies: VecDeque<(u8, u8, Vec<u8>)>,
    chunk_ack: bool,
    pong: Option<u8>,
    streams: Streams,
    inputs: VecDeque<TargetInput>,
    silence: Silence,
    last_sent: Option<u64>,
}

impl TargetSession {
    /// A target that has not met a host yet. `limits` bound the frames both ways; tell the same in
    /// [`Response::Hello`].
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        Self::with_timing(limits, Timing::default())
    }

    /// As [`TargetSession::new`], with other times.
    #[must_use]
    pub fn with_timing(limits: Limits, timing: Timing) -> Self {
        TargetSession {
            limits,
            timing,
            now: 0,
            decoder: FrameDecoder::new(usize::from(limits.max_payload)),
            damaged: 0,
            request: Assembly::default(),
            session: None,
            events: EventQueue::default(),
            dropped_events: 0,
            urgent: VecDeque::new(),
            replies: VecDeque::new(),
            chunk_ack: false,
            pong: None,
            streams: Streams::default(),
            inputs: VecDeque::new(),
            silence: Silence::new(timing.silence_us, timing.ping_us),
            last_sent: None,
        }
    }

    /// Limits as given.
    #[must_use]
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// A host session is open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.session.as_ref().is_some_and(|s| s.open)
    }

    /// The streams of the session. Whoever acts on [`Request::Subscribe`] begins them here, and gives them samples.
    /// They end by themselves with the session.
    pub fn streams(&mut self) -> &mut Streams {
        &mut self.streams
    }

    /// Frames of events that wait to be sent or acknowledged.
    #[must_use]
    pub fn events_waiting(&self) -> usize {
        self.events.len()
    }

    /// Every byte of the announced download has arrived.
    #[must_use]
    pub fn download_complete(&self) -> bool {
        self.session
            .as_ref()
            .and_then(|s| s.reception.as_ref())
            .is_some_and(|r| r.arrived.complete() == r.len)
    }

    /// Frames that arrived damaged so far.
    #[must_use]
    pub fn damaged_frames(&self) -> u32 {
        self.damaged
    }

    /// Takes bytes from the link.
    pub fn receive(&mut self, now: u64, bytes: &[u8]) {
        self.now = self.now.max(now);
        for byte in bytes {
            match self.decoder.push(*byte) {
                Some(Ok(frame)) => self.take(&frame),
                Some(Err(_)) => self.damaged = self.damaged.saturating_add(1),
                None => {}
            }
        }
    }

    /// The next thing to act on.
    #[allow(clippy::should_implement_trait)] // not an iterator: more may come after `None`
    pub fn next(&mut self) -> Option<TargetInput> {
        self.inputs.pop_front()
    }

    fn take(&mut self, frame: &Frame) {
        match frame.kind {
            kind::REQUEST => self.take_request(frame),
            kind::EVENT_ACK if self.is_open() => self.events.acknowledged(frame.seq, self.now),
            kind::CHUNK => self.take_chunk(frame),
            kind::LISTENING if self.is_open() => {
                self.streams.poll(self.now);
                self.streams.listened(&frame.payload);
            }
            // Without a session there is no answer, so that a host notices that the target started anew.
            kind::PING if self.is_open() => self.pong = Some(frame.seq),
            _ => return,
        }
        self.silence.heard();
    }

    fn take_request(&mut self, frame: &Frame) {
        if let Some((version, id)) = hello_in(frame)
            && self.session.as_ref().is_none_or(|s| s.id != id)
        {
            self.take_hello(frame.seq, version, id);
            return;
        }
        let Some(session) = &self.session else {
            self.reply_outside(frame.seq, Failure::NoSession);
            return;
        };
        if let Some((seq, parts)) = session.answers.iter().find(|(seq, _)| *seq == frame.seq) {
            // Repeated because the answer was lost, or just slow: then it is still waiting here.
            let waiting = self.replies.iter().chain(&self.urgent).any(|(_, s, _)| s == seq);
            if !waiting {
                self.replies.extend(parts.iter().map(|p| (kind::RESPONSE, *seq, p.clone())));
            }
            return;
        }
        if session.pending || frame.seq != session.last.wrapping_add(1) {
            return; // being worked on, or a late copy of something answered long ago
        }
        if let Some(message) = self.request.add(frame.seq, &frame.payload) {
            self.take_next(frame.seq, decode_request(&message));
        }
    }

    fn take_hello(&mut self, seq: u8, version: u16, id: u32) {
        if version != PROTOCOL_VERSION {
            self.reply_outside(seq, Failure::Version);
            return;
        }
        self.forget_session();
        self.session = Some(Session {
            id,
            last: seq,
            pending: true,
            announced: None,
            answers: VecDeque::new(),
            reception: None,
            open: false,
        });
        self.inputs.push_back(TargetInput::Request { seq, request: Request::Hello { version, session: id } });
    }

    /// The next request is complete.
    fn take_next(&mut self, seq: u8, request: Result<Request, Failure>) {
        let Some(session) = &mut self.session else { return };
        session.last = seq;
        session.pending = true;
        session.announced = match request {
            Ok(Request::Download { len, .. }) => Some(len),
            _ => None,
        };
        match request {
            Ok(request) => self.inputs.push_back(TargetInput::Request { seq, request }),
            Err(failure) => self.respond(seq, &Response::Failed(failure)),
        }
    }

    /// Answers a request that belongs to no session, without keeping anything.
    fn reply_outside(&mut self, seq: u8, failure: Failure) {
        let message = postcard::to_allocvec(&Response::Failed(failure)).unwrap_or_default();
        let parts = parts::split(&message, usize::from(self.limits.max_payload)).unwrap_or_default();
        if self.replies.len() < KEPT_ANSWERS {
            self.replies.extend(parts.into_iter().map(|p| (kind::RESPONSE, seq, p)));
        }
    }

    fn take_chunk(&mut self, frame: &Frame) {
        let Some(session) = self.session.as_mut() else { return };
        let Some(reception) = session.reception.as_mut().filter(|r| r.tag == frame.seq) else { return };
        let Ok(chunk) = postcard::from_bytes::<Chunk>(&frame.payload) else { return };
        let Some(end) = u32::try_from(chunk.bytes.len()).ok().and_then(|n| chunk.offset.checked_add(n))
        else {
            return;
        };
        if end > reception.len {
            return;
        }
        self.chunk_ack = true;
        if reception.arrived.add(chunk.offset, end) {
            self.inputs.push_back(TargetInput::Chunk(chunk));
        }
    }

    /// Answers request `seq`. The answer is kept, to be given again when the request is repeated.
    /// An answer to anything but the open request is dropped: its session is over.
    pub fn respond(&mut self, seq: u8, response: &Response) {
        let Some(session) = self.session.as_mut().filter(|s| s.pending && s.last == seq) else { return };
        session.pending = false;
        let max_payload = usize::from(self.limits.max_payload);
        let encode = |response: &Response| {
            parts::split(&postcard::to_allocvec(response).unwrap_or_default(), max_payload)
        };
        let parts =
            encode(response).or_else(|| encode(&Response::Failed(Failure::TooLarge))).unwrap_or_default();
        if let Some(len) = session.announced.take().filter(|_| *response == Response::Done) {
            session.reception = Some(Reception { tag: seq, len, arrived: Arrived::default() });
        }
        if session.answers.len() == KEPT_ANSWERS {
            session.answers.pop_front();
        }
        session.answers.push_back((seq, parts.clone()));
        // The answer to Hello goes ahead of the events that follow it, else the host would drop them.
        let opens = matches!(response, Response::Hello { .. });
        session.open |= opens;
        let queue = if opens { &mut self.urgent } else { &mut self.replies };
        queue.extend(parts.into_iter().map(|p| (kind::RESPONSE, seq, p)));
    }

    /// The target has kept these bytes of the download that it has just agreed to with `Done`: they need not be sent
    /// again.
    pub fn already_arrived(&mut self, arrived: Arrived) {
        let reception = self.session.as_mut().and_then(|s| s.reception.as_mut());
        if let Some(reception) = reception.filter(|_| !arrived.is_empty()) {
            reception.arrived = arrived;
            self.chunk_ack = true;
        }
    }

    /// Queues an event for the host. Without a session it is dropped: a host learns the state from Hello.
    /// When the host does not keep up, messages, overruns and log lines are dropped and counted.
    pub fn event(&mut self, event: &Event) {
        if self.session.is_none() {
            return;
        }
        let droppable = matches!(event, Event::Message { .. } | Event::Overrun { .. } | Event::Log(_));
        if droppable && self.events.is_full() {
            self.dropped_events = self.dropped_events.saturating_add(1);
            return;
        }
        if droppable && self.dropped_events > 0 {
            let note = format!("{} messages were lost: the link is too slow for them", self.dropped_events);
            self.dropped_events = 0;
            self.push_event(&Event::Log(note));
        }
        self.push_event(event);
    }

    fn push_event(&mut self, event: &Event) {
        let message = postcard::to_allocvec(event).unwrap_or_default();
        if let Some(parts) = parts::split(&message, usize::from(self.limits.max_payload)) {
            self.events.push(parts);
        }
    }

    fn forget_session(&mut self) {
        self.session = None;
        self.request.clear();
        self.inputs.clear();
        self.events = EventQueue::default();
        self.dropped_events = 0;
        self.urgent.clear();
        self.replies.clear();
        self.chunk_ack = false;
        self.pong = None;
        self.streams.clear();
    }

    /// Lets time pass. Answers when to call again at the latest; `None`: when bytes arrive.
    pub fn poll(&mut self, now: u64) -> Option<u64> {
        self.now = self.now.max(now);
        let lost = self.silence.look(self.now);
        self.session.as_ref()?;
        if lost {
            self.forget_session();
            self.inputs.push_back(TargetInput::HostLost);
            return None;
        }
        let resend = self.events.poll(self.now, self.timing.resend_us);
        let silence = self.silence.deadline(self.now);
        let sample = self.streams.poll(self.now);
        resend.into_iter().chain(silence).chain(sample).min()
    }

    /// The bytes to send now.
    #[must_use]
    pub fn transmit(&mut self) -> Vec<u8> {
        self.transmit_within(usize::MAX)
    }

    /// As [`TargetSession::transmit`], but stops after the frame that reaches `budget` bytes: for links with a
    /// buffer, where what waits here can still be overtaken by an event.
    #[must_use]
    pub fn transmit_within(&mut self, budget: usize) -> Vec<u8> {
        let mut out = Vec::new();
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

    fn send_one(&mut self, out: &mut Vec<u8>) -> bool {
        if let Some((kind, seq, payload)) = self.urgent.pop_front() {
            frame::encode(kind, seq, &payload, out);
            return true;
        }
        if self.is_open()
            && let Some((seq, payload)) = self.events.next(self.now)
        {
            frame::encode(kind::EVENT, seq, payload, out);
            return true;
        }
        if let Some((kind, seq, payload)) = self.replies.pop_front() {
            frame::encode(kind, seq, &payload, out);
            return true;
        }
        if let Some(seq) = self.pong.take() {
            frame::encode(kind::PONG, seq, &[], out);
            return true;
        }
        if self.is_open() && self.streams.send(self.now, out) {
            return true;
        }
        if core::mem::take(&mut self.chunk_ack)
            && let Some(reception) = self.session.as_ref().and_then(|s| s.reception.as_ref())
        {
            let ack =
                ChunkAck { complete: reception.arrived.complete(), islands: reception.arrived.islands() };
            let payload = postcard::to_allocvec(&ack).unwrap_or_default();
            frame::encode(kind::CHUNK_ACK, reception.tag, &payload, out);
            return true;
        }
        false
    }
}

/// The frame is a Hello, which always fits into one part.
fn hello_in(frame: &Frame) -> Option<(u16, u32)> {
    // Part 0 of one, variant 0.
    let message = frame.payload.strip_prefix(&[0x80]).filter(|m| m.first() == Some(&0))?;
    match decode_request(message) {
        Ok(Request::Hello { version, session }) => Some((version, session)),
        _ => None,
    }
}

fn decode_request(message: &[u8]) -> Result<Request, Failure> {
    match postcard::take_from_bytes(message) {
        Ok((request, [])) => Ok(request),
        Ok(_) => Err(Failure::Malformed),
        // The variant number comes first, as a varint; numbers below 128 take one byte.
        Err(_) => match message.first() {
            Some(&first) if u32::from(first) >= KNOWN_REQUESTS => Err(Failure::Unsupported),
            _ => Err(Failure::Malformed),
        },
    }
}
