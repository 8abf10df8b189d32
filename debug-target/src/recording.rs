//! What goes over a link, written down as it goes: one line for each piece of bytes, with the microsecond, the
//! direction (`>` to the target, `<` from it) and the bytes in hexadecimal. [`text_of_recording`] says what it means.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use technol_image::debug_info::DebugInfo;
use technol_wire::frame::{MAX_PAYLOAD, kind};
use technol_wire::message::{Chunk, ChunkAck, Event, Limits};
use technol_wire::{Frame, FrameDecoder, Timing};

use crate::link::Link;
use crate::recorded_streams::RecordedStreams;

/// First line of a recording.
const HEAD: &str = "# technol link recording 1: microseconds, > to the target or < from it, bytes";

/// A recording cannot be made or read.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// The file cannot be written.
    #[error("cannot write the recording {path}: {source}")]
    Write {
        /// Its name.
        path: String,
        /// What the system says.
        source: io::Error,
    },
    /// It is something else.
    #[error(
        "line {line} is no part of a recording: {what}; `--record FILE` of `technol dap` or `target` writes one"
    )]
    Line {
        /// 1-based.
        line: usize,
        /// What is wrong.
        what: &'static str,
    },
}

/// A file that links are recorded into, one after another.
#[derive(Clone)]
pub struct Recording {
    out: Arc<Mutex<BufWriter<File>>>,
    began: Instant,
}

impl Recording {
    /// Begins a file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn create(path: &Path) -> Result<Recording, RecordingError> {
        let failed = |source| RecordingError::Write { path: path.display().to_string(), source };
        let mut out = BufWriter::new(File::create(path).map_err(failed)?);
        writeln!(out, "{HEAD}").and_then(|()| out.flush()).map_err(failed)?;
        Ok(Recording { out: Arc::new(Mutex::new(out)), began: Instant::now() })
    }

    /// Records a link from here on. `at_target`: this is the target's end of it.
    #[must_use]
    pub fn of(&self, link: Box<dyn Link>, at_target: bool) -> RecordedLink {
        RecordedLink { link, recording: self.clone(), sends: if at_target { '<' } else { '>' } }
    }

    fn note(&self, direction: char, bytes: &[u8]) {
        let mut line = format!("{} {direction} ", self.began.elapsed().as_micros());
        for byte in bytes {
            let _ = write!(line, "{byte:02x}");
        }
        let mut out = self.out.lock().unwrap_or_else(PoisonError::into_inner);
        // A full disk must not end the session that is recorded; the recording then ends early.
        let _ = writeln!(out, "{line}").and_then(|()| out.flush());
    }
}

/// A link that is recorded.
pub struct RecordedLink {
    link: Box<dyn Link>,
    recording: Recording,
    sends: char,
}

impl Link for RecordedLink {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.recording.note(self.sends, bytes);
        self.link.send(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        let count = self.link.receive(buffer, timeout)?;
        if count > 0 {
            self.recording.note(if self.sends == '>' { '<' } else { '>' }, &buffer[..count]);
        }
        Ok(count)
    }

    fn bytes_per_second(&self) -> Option<u32> {
        self.link.bytes_per_second()
    }

    fn outlives_host(&self) -> bool {
        self.link.outlives_host()
    }

    fn limits(&self) -> Limits {
        self.link.limits()
    }

    fn timing(&self) -> Timing {
        self.link.timing()
    }
}

/// A recording in words, a line for each frame. With the debug information of the program the values of streams have
/// their names, without it their addresses.
///
/// # Errors
/// A line that is no part of a recording.
pub fn text_of_recording(recording: &str, debug: Option<&DebugInfo>) -> Result<String, RecordingError> {
    let mut text = String::new();
    let mut streams = RecordedStreams::new(debug);
    let mut ends = [Reader::new("host"), Reader::new("target")];
    for (at, line) in recording.lines().enumerate() {
        if line.starts_with('#') || line.trim().is_empty() {
            continue;
        }
        let wrong = |what| RecordingError::Line { line: at + 1, what };
        let mut words = line.split_whitespace();
        let micros: u64 =
            words.next().and_then(|w| w.parse().ok()).ok_or_else(|| wrong("the time is missing"))?;
        let end = match words.next() {
            Some(">") => &mut ends[0],
            Some("<") => &mut ends[1],
            _ => return Err(wrong("the direction is missing")),
        };
        let bytes = words.next().and_then(bytes_of).ok_or_else(|| wrong("the bytes are not hexadecimal"))?;
        for said in end.read(micros, &bytes, &mut streams) {
            let _ = writeln!(text, "{:>12.6}  {:<6}  {said}", micros as f64 / 1e6, end.name);
        }
    }
    Ok(text)
}

fn bytes_of(hex: &str) -> Option<Vec<u8>> {
    if !hex.is_ascii() || !hex.len().is_multiple_of(2) {
        return None;
    }
    (0..hex.len()).step_by(2).map(|at| u8::from_str_radix(&hex[at..at + 2], 16).ok()).collect()
}

/// One direction: frames out of bytes, messages out of frames.
struct Reader {
    name: &'static str,
    decoder: FrameDecoder,
    seq: u8,
    parts: Vec<Option<Vec<u8>>>,
}

impl Reader {
    fn new(name: &'static str) -> Reader {
        Reader { name, decoder: FrameDecoder::new(usize::from(MAX_PAYLOAD)), seq: 0, parts: Vec::new() }
    }

    fn read(&mut self, micros: u64, bytes: &[u8], streams: &mut RecordedStreams<'_>) -> Vec<String> {
        let mut said = Vec::new();
        for byte in bytes {
            match self.decoder.push(*byte) {
                Some(Ok(frame)) => said.push(self.frame(micros, &frame, streams)),
                Some(Err(error)) => said.push(format!("DAMAGED: {error}")),
                None => {}
            }
        }
        said
    }

    fn frame(&mut self, micros: u64, frame: &Frame, streams: &mut RecordedStreams<'_>) -> String {
        let Frame { kind, seq, payload } = frame;
        match *kind {
            kind::REQUEST => self.part("request", *seq, payload, |request| streams.request(*seq, request)),
            kind::RESPONSE => {
                self.part("response", *seq, payload, |response| streams.response(*seq, response))
            }
            kind::EVENT => self.part("event", *seq, payload, |_: &Event| {}),
            kind::EVENT_ACK => format!("events up to {seq} have arrived"),
            kind::CHUNK => match postcard::from_bytes::<Chunk>(payload) {
                Ok(chunk) => {
                    format!("piece of download {seq}: {} bytes at {}", chunk.bytes.len(), chunk.offset)
                }
                Err(_) => "piece of a download that is not understood".to_owned(),
            },
            kind::CHUNK_ACK => match postcard::from_bytes::<ChunkAck>(payload) {
                Ok(ack) if ack.islands.is_empty() => {
                    format!("download {seq} has arrived up to {}", ack.complete)
                }
                Ok(ack) => {
                    format!("download {seq} has arrived up to {}, and {:?}", ack.complete, ack.islands)
                }
                Err(_) => "state of a download that is not understood".to_owned(),
            },
            kind::PING => "ping".to_owned(),
            kind::PONG => "pong".to_owned(),
            kind::STREAM => {
                let values = streams.sample(micros, *seq, payload).map(|told| format!(": {told}"));
                sample(*seq, payload) + &values.unwrap_or_default()
            }
            kind::LISTENING => listening(payload),
            kind::CHALLENGE => "asks for the token".to_owned(),
            kind::PROOF => "proves that it knows the token".to_owned(),
            kind::ADMISSION if payload.is_empty() => "does not let the host in".to_owned(),
            kind::ADMISSION => "lets the host in".to_owned(),
            other => format!("kind {other:02x}h, number {seq}, {} bytes", payload.len()),
        }
    }

    /// A part of a message, and with the last missing one the message.
    fn part<T: serde::de::DeserializeOwned + std::fmt::Debug>(
        &mut self,
        what: &str,
        seq: u8,
        payload: &[u8],
        mut understood: impl FnMut(&T),
    ) -> String {
        let Some((head, piece)) = payload.split_first() else {
            return format!("{what} {seq} without content");
        };
        let (index, last) = (usize::from(head & 0x7F), head & 0x80 != 0);
        let is_event = what == "event";
        // The parts of an event have numbers of their own, and come in order.
        if index == 0 || !is_event && seq != self.seq {
            self.parts.clear();
        }
        self.seq = seq;
        if self.parts.len() <= index {
            self.parts.resize(index + 1, None);
        }
        self.parts[index] = Some(piece.to_vec());
        if !last {
            return format!("{what} {seq}, part {}", index + 1);
        }
        if self.parts.iter().any(Option::is_none) {
            return format!("{what} {seq}, last part, others are missing");
        }
        let message: Vec<u8> = self.parts.iter().flatten().flatten().copied().collect();
        match postcard::from_bytes::<T>(&message) {
            Ok(message) => {
                understood(&message);
                format!("{what} {seq}: {message:?}")
            }
            Err(_) => format!("{what} {seq} of another version: {} bytes", message.len()),
        }
    }
}

/// What a sample says of itself.
fn sample(seq: u8, payload: &[u8]) -> String {
    let Some((head, rest)) = payload.split_first() else { return "sample without content".to_owned() };
    let what = ["whole, plain", "whole", "changes since the last whole one", "changes since the last one"];
    let what = what[usize::from(head >> 3 & 3)];
    let full = || {
        let (number, rest) = postcard::take_from_bytes::<u32>(rest).ok()?;
        let (cycle, _) = postcard::take_from_bytes::<u32>(rest).ok()?;
        Some(format!("number {number}, cycle {cycle}"))
    };
    let short = || format!("number {} of 1024", u32::from(head & 3) << 8 | u32::from(seq));
    let number = if head & 4 != 0 { full() } else { Some(short()) };
    let number = number.unwrap_or_else(|| "its number is not understood".to_owned());
    format!("sample of stream {}: {what}, {number}, {} bytes", head >> 5, payload.len())
}

/// Which streams a host listens to.
fn listening(payload: &[u8]) -> String {
    let stream = |entry: &[u8]| {
        let [flags, number @ ..] = entry else { return String::new() };
        let number = number.try_into().map_or(0, u32::from_le_bytes);
        let has = if flags & 0x40 != 0 { format!(" (has {number})") } else { String::new() };
        let wants = if flags & 0x80 != 0 { " (wants a whole sample)" } else { "" };
        format!("{}{has}{wants}", flags & 7)
    };
    let streams: Vec<String> = payload.chunks_exact(5).map(stream).collect();
    format!("listens to stream {}", streams.join(", "))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // tests
mod tests {
    use super::*;
    use crate::pipe::pair;
    use technol_image::debug_info::{Scope, Symbol, SymbolKind};
    use technol_image::op::Width;
    use technol_wire::message::{
        Failure, Item, ItemKind, Mode, Request, Response, Subject, Subscription, TracedLine, TracedRegister,
    };
    use technol_wire::{HostSession, TargetInput, TargetSession};

    #[test]
    fn a_recorded_session_can_be_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("link.log");
        let recording = Recording::create(&path).unwrap();
        let (near, mut far) = pair();
        let mut near = recording.of(Box::new(near), false);
        let mut host = HostSession::new(5);
        let mut target = TargetSession::new(near.limits());
        host.poll(0);
        near.send(&host.transmit()).unwrap();
        let mut buffer = [0; 1000];
        let count = far.receive(&mut buffer, Duration::ZERO).unwrap();
        target.receive(0, &buffer[..count]);
        assert!(matches!(target.next(), Some(TargetInput::Request { seq: 5, .. })));
        target.respond(5, &Response::Failed(Failure::Version));
        far.send(&target.transmit()).unwrap();
        far.send(&[1, 2, 3, 0]).unwrap();
        near.receive(&mut buffer, Duration::from_secs(1)).unwrap();
        drop(near);

        let text = text_of_recording(&std::fs::read_to_string(&path).unwrap(), None).unwrap();
        let said: Vec<&str> = text.lines().map(|line| line[12..].trim()).collect();
        assert_eq!(
            said,
            [
                "host    request 5: Hello { version: 1, session: 5 }",
                "target  response 5: Failed(Version)",
                "target  DAMAGED: frame is too short",
            ]
        );
    }

    #[test]
    fn what_is_no_recording_is_refused_with_its_line() {
        for (text, line, what) in [
            ("hello", 1, "the time is missing"),
            ("# head\n12 x 00", 2, "the direction is missing"),
            ("12 > 0", 1, "the bytes are not hexadecimal"),
            ("12 > éé", 1, "the bytes are not hexadecimal"),
            ("12 >", 1, "the bytes are not hexadecimal"),
        ] {
            let error = text_of_recording(text, None).unwrap_err();
            let expected = format!("line {line} is no part of a recording: {what};");
            assert!(error.to_string().starts_with(&expected), "{text}: {error}");
        }
    }

    /// The frames are the examples of PROTOCOL.md.
    #[test]
    fn streams_are_told_in_words() {
        let lines = "0 < 1185e8afe8079003c4b1088b807b3ed6ae00\n1 < 0985e9b3801dc22a8100\n";
        let mut bytes = Vec::new();
        technol_wire::frame::encode(kind::LISTENING, 0, &[0xC5, 0xE8, 3, 0, 0, 1, 0, 0, 0, 0], &mut bytes);
        let text = text_of_recording(&format!("{lines}2 > {}\n", hex(&bytes)), None).unwrap();
        let said: Vec<&str> = text.lines().map(|line| line[12..].trim()).collect();
        assert_eq!(
            said,
            [
                "target  sample of stream 5: whole, number 1000, cycle 400, 10 bytes",
                "target  sample of stream 5: changes since the last whole one, number 1001 of 1024, 2 bytes",
                "host    listens to stream 5 (has 1000) (wants a whole sample), 1",
            ]
        );
    }

    fn hex(bytes: &[u8]) -> String {
        bytes.iter().fold(String::new(), |mut hex, byte| {
            let _ = write!(hex, "{byte:02x}");
            hex
        })
    }

    fn hex_line(micros: u64, direction: char, kind: u8, seq: u8, payload: &[u8]) -> String {
        let mut bytes = Vec::new();
        technol_wire::frame::encode(kind, seq, payload, &mut bytes);
        format!("{micros} {direction} {}\n", hex(&bytes))
    }

    fn subscribed(seq: u8, subject: Subject) -> String {
        let request = Request::Subscribe(Subscription { id: 5, period: 1, subject });
        let asked = [vec![0x80], postcard::to_allocvec(&request).unwrap()].concat();
        hex_line(0, '>', kind::REQUEST, seq, &asked) + &hex_line(1, '<', kind::RESPONSE, seq, &[0x80, 0])
    }

    /// What the samples of a recording tell, without what they say of themselves.
    fn values(recording: &str, debug: Option<&DebugInfo>) -> Vec<String> {
        let text = text_of_recording(recording, debug).unwrap();
        let samples = text.lines().filter(|line| line.contains("sample of stream"));
        samples.map(|line| line.split_once(" bytes: ").map_or("", |(_, told)| told).to_owned()).collect()
    }

    /// The example of PROTOCOL.md.
    const EXAMPLE: &str = "2 < 1185e8afe8079003c4b1088b807b3ed6ae00\n3 < 0985e9b3801dc22a8100\n\
        4 < 0b85ebb385444cd1f736da00\n";

    fn example() -> String {
        let item = |addr, kind| Item { addr, kind, mode: Mode::Value };
        let items =
            [item(8, ItemKind::Bit(3)), item(9, ItemKind::Unsigned(2)), item(20, ItemKind::Signed(4))];
        subscribed(7, Subject::Variables(items.to_vec())) + EXAMPLE
    }

    #[test]
    fn values_of_streams_are_told_with_their_names_and_only_when_they_change() {
        let told = values(&example(), None);
        assert_eq!(
            told,
            ["bit 8.3 = 1, WORD 9 = 300, DWRD 20 = 70000", "all as before", "bit 8.3 = 0, DWRD 20 = 69990"]
        );
        let symbol = |name: &str, scope, kind| Symbol { name: name.into(), scope, kind, declared: None };
        let debug = DebugInfo {
            program: [0; 16],
            files: Vec::new(),
            lines: Vec::new(),
            symbols: vec![
                symbol("SYSTEM", Scope::System, SymbolKind::Bit { addr: 8, bit: 3 }),
                symbol("DOOR", Scope::Global, SymbolKind::Bit { addr: 8, bit: 3 }),
                symbol("AREA", Scope::Global, SymbolKind::Cell { addr: 9, width: Width::Byte }),
                symbol("POSITION", Scope::File(0), SymbolKind::Cell { addr: 20, width: Width::DWord }),
            ],
            mechanisms: Vec::new(),
        };
        let told = values(&example(), Some(&debug));
        assert_eq!(told[0], "DOOR = 1, WORD 9 = 300, POSITION = 70000");
    }

    #[test]
    fn a_stream_that_the_recording_does_not_explain_is_told_without_values() {
        assert_eq!(values(EXAMPLE, None), ["", "", ""]);
        // The first sample is missing: the others differ from nothing that is known.
        let recording = example();
        let late: Vec<&str> = recording.lines().filter(|line| !line.starts_with("2 ")).collect();
        let missing = "not understood without the frames that are missing";
        assert_eq!(values(&late.join("\n"), None), [missing, missing]);
        // A new session knows nothing of the old one's streams.
        let hello = postcard::to_allocvec(&Request::Hello { version: 1, session: 3 }).unwrap();
        let hello = hex_line(2, '>', kind::REQUEST, 9, &[vec![0x80], hello].concat());
        assert_eq!(values(&(example() + &hello + EXAMPLE), None)[3..], ["", "", ""]);
    }

    #[test]
    fn the_registers_behind_lines_are_told() {
        let line = |pc, register| TracedLine { pc, register };
        let lines = vec![line(4, TracedRegister::Real), line(9, TracedRegister::Dr64)];
        // Stream 5, plain, full: number 1000, cycle 400; known, ran, RLO, 2.5; known, not ran, not RLO, -2.
        let real = 2.5_f64.to_bits();
        let bits = (u128::from(0b111_u8) << 64 | u128::from(real)) << 3 | 0b100;
        let mut payload = vec![0xA7, 0xE8, 0x07, 0x90, 0x03];
        // 70 bits, then 64 ones but the last, filled to bytes.
        let text = format!("{bits:070b}{:064b}", -2_i64 as u64);
        let padded = format!("{text:0<136}");
        let byte = |at: usize| u8::from_str_radix(&padded[at..at + 8], 2).unwrap();
        payload.extend((0..136).step_by(8).map(byte));
        let recording =
            subscribed(1, Subject::Lines(lines)) + &hex_line(2, '<', kind::STREAM, 0xE8, &payload);
        assert_eq!(
            values(&recording, None),
            ["operation 4: RLO 1 DR_REAL 2.5, operation 9: RLO 0 DR64 -2, earlier"]
        );
    }
}
