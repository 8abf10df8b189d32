//! A whole session on a clean line: what goes over it, byte for byte, and what it says.

use serde_json::{Value, json};
use technol_wire::frame::{Frame, FrameDecoder, kind};
use technol_wire::message::{Chunk, ChunkAck, Event, LostPolicy, Request, Response, Resume};
use technol_wire::{HostSession, TargetInput, TargetSession};

use crate::{hex, samples};

/// Nobody is late, and a byte takes no time: only the order matters here.
struct Talk {
    host: HostSession,
    target: TargetSession,
    now: u64,
    said: Vec<Value>,
    readers: [Reader; 2],
}

impl Talk {
    fn new() -> Talk {
        let limits = samples::limits();
        Talk {
            host: HostSession::new(0x0102_0304),
            target: TargetSession::new(limits),
            now: 0,
            said: Vec::new(),
            readers: [Reader::new(), Reader::new()],
        }
    }

    fn note(&mut self, from: usize, bytes: &[u8]) {
        if !bytes.is_empty() {
            let says = self.readers[from].read(bytes);
            let from = ["host", "target"][from];
            self.said.push(json!({ "at": self.now, "from": from, "bytes": hex(bytes), "says": says }));
        }
    }

    /// Goes back and forth until nobody has anything to say.
    fn settle(&mut self) {
        loop {
            self.now += 1000;
            self.host.poll(self.now);
            let there = self.host.transmit();
            self.note(0, &there);
            self.target.receive(self.now, &there);
            self.target.poll(self.now);
            while let Some(input) = self.target.next() {
                if let TargetInput::Request { seq, request } = input {
                    self.target.respond(seq, &answer(&request));
                }
            }
            let back = self.target.transmit();
            self.note(1, &back);
            self.host.receive(self.now, &back);
            while self.host.next().is_some() {}
            if there.is_empty() && back.is_empty() {
                return;
            }
        }
    }
}

fn answer(request: &Request) -> Response {
    match request {
        Request::Hello { .. } => samples::hello(),
        // Longer than a frame: it comes in parts.
        Request::Read { pieces } => {
            let len = pieces.iter().map(|p| u32::from(p.1)).sum();
            Response::Memory { cycle: 70_000, bytes: (0..len).map(|n| n as u8).collect() }
        }
        _ => Response::Done,
    }
}

pub(crate) fn record() -> Vec<Value> {
    let mut talk = Talk::new();
    let hello = talk.host.hello();
    talk.settle();
    assert_eq!(hello.0, 0);
    talk.host.request(Request::OnLinkLost(LostPolicy::StayStopped));
    let program: Vec<u8> = (0..700_u32).map(|n| ((n * n) >> 3) as u8).collect();
    talk.host.request(Request::Download { len: 700, hash: *b"0123456789abcdef" });
    talk.host.download(program);
    talk.settle();
    for request in [
        Request::Commit,
        Request::SetBreakpoints { pcs: vec![3, 200, 70_000] },
        Request::Start { cold: true, stop_on_entry: false },
    ] {
        talk.host.request(request);
    }
    talk.settle();
    for event in samples::events() {
        talk.target.event(&event);
    }
    talk.settle();
    talk.host.request(Request::Read { pieces: vec![(1024, 500)] });
    talk.host.request(Request::Resume(Resume::Over { sequence: Some(3) }));
    talk.settle();
    // Both ends are quiet for so long that the host asks.
    talk.now += 150_000;
    talk.settle();
    talk.host.request(Request::Goodbye { stop: true });
    talk.settle();
    talk.said
}

/// Puts frames and parts together, as either end does.
struct Reader {
    decoder: FrameDecoder,
    parts: Vec<u8>,
}

impl Reader {
    fn new() -> Reader {
        Reader { decoder: FrameDecoder::new(4096), parts: Vec::new() }
    }

    fn read(&mut self, bytes: &[u8]) -> Vec<Value> {
        let frames: Vec<Frame> =
            bytes.iter().filter_map(|b| self.decoder.push(*b)).map(Result::unwrap).collect();
        frames.into_iter().map(|frame| self.frame(&frame)).collect()
    }

    fn frame(&mut self, frame: &Frame) -> Value {
        let seq = frame.seq;
        let what = match frame.kind {
            kind::REQUEST => self.part(frame).map(|m| json!(postcard::from_bytes::<Request>(&m).unwrap())),
            kind::RESPONSE => self.part(frame).map(|m| json!(postcard::from_bytes::<Response>(&m).unwrap())),
            kind::EVENT => self.part(frame).map(|m| json!(postcard::from_bytes::<Event>(&m).unwrap())),
            kind::CHUNK => Some(json!(postcard::from_bytes::<Chunk>(&frame.payload).unwrap())),
            kind::CHUNK_ACK => Some(json!(postcard::from_bytes::<ChunkAck>(&frame.payload).unwrap())),
            _ => None,
        };
        let name = match frame.kind {
            kind::REQUEST => "request",
            kind::EVENT_ACK => "event ack",
            kind::CHUNK => "chunk",
            kind::PING => "ping",
            kind::RESPONSE => "response",
            kind::EVENT => "event",
            kind::CHUNK_ACK => "chunk ack",
            kind::PONG => "pong",
            other => panic!("kind {other}"),
        };
        json!([name, seq, what])
    }

    /// The message when this was its last part; on a clean line they come in order.
    fn part(&mut self, frame: &Frame) -> Option<Vec<u8>> {
        let (head, piece) = frame.payload.split_first().unwrap();
        self.parts.extend_from_slice(piece);
        (head & 0x80 != 0).then(|| std::mem::take(&mut self.parts))
    }
}
