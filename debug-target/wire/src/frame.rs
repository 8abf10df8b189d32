//! One frame: `COBS(kind, seq, payload, crc32c) 00`.
//!
//! COBS removes every zero from the content, so a zero always ends a frame and a reader that joins in the
//! middle, or meets damage, is in step again at the next zero.

use alloc::vec::Vec;
use core::fmt;

use crc::{CRC_32_ISCSI, Crc};

/// Kinds of frames. Frames from the target have bit 7 set, so an end that hears itself (an echoing line)
/// ignores what it hears.
pub mod kind {
    /// Control, host to target: a part of a request.
    pub const REQUEST: u8 = 0x01;
    /// Event class, host to target: all events up to `seq` have arrived.
    pub const EVENT_ACK: u8 = 0x02;
    /// Bulk, host to target: a piece of the download whose announcement had this `seq`.
    pub const CHUNK: u8 = 0x03;
    /// Host to target: are you there?
    pub const PING: u8 = 0x04;
    /// Stream class, host to target: streams that are listened to, and what is missing.
    pub const LISTENING: u8 = 0x05;
    /// Before a session, host to target: the answer to a challenge, see PROTOCOL.md.
    pub const PROOF: u8 = 0x06;
    /// Control, target to host: a part of the response to the request with this `seq`.
    pub const RESPONSE: u8 = 0x81;
    /// Event class, target to host: a part of an event.
    pub const EVENT: u8 = 0x82;
    /// Bulk, target to host: what has arrived.
    pub const CHUNK_ACK: u8 = 0x83;
    /// Target to host: I am here. Carries the `seq` of the ping.
    pub const PONG: u8 = 0x84;
    /// Stream class, target to host: a sample. Carries the low 8 bits of its number.
    pub const STREAM: u8 = 0x85;
    /// Before a session, target to host: prove that you know the token.
    pub const CHALLENGE: u8 = 0x86;
    /// Before a session, target to host: the host is let in, or (without payload) not.
    pub const ADMISSION: u8 = 0x87;
}

/// Ends a frame on the line.
pub const DELIMITER: u8 = 0;
/// Bytes of a decoded frame besides its payload: kind, seq, CRC.
pub const OVERHEAD: usize = 6;
/// Longest payload a target may announce and a host has to take.
pub const MAX_PAYLOAD: u16 = 4096;

const CRC32C: Crc<u32> = Crc::<u32>::new(&CRC_32_ISCSI);

/// A frame that passed the checks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// One of [`kind`], or a kind of a later version, to be ignored.
    pub kind: u8,
    /// Sequence number; its meaning depends on the kind.
    pub seq: u8,
    /// Content.
    pub payload: Vec<u8>,
}

/// Why bytes between two delimiters are not a frame. All are answered the same way: by silence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameError {
    /// A COBS code points past the end.
    Stuffing,
    /// Fewer than [`OVERHEAD`] bytes.
    Short,
    /// The checksum differs.
    Checksum,
    /// Longer than this end takes.
    TooLong,
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            FrameError::Stuffing => "byte stuffing is broken",
            FrameError::Short => "frame is too short",
            FrameError::Checksum => "checksum differs",
            FrameError::TooLong => "frame is too long",
        })
    }
}

impl core::error::Error for FrameError {}

/// Appends an encoded frame with its delimiter to `out`.
pub fn encode(kind: u8, seq: u8, payload: &[u8], out: &mut Vec<u8>) {
    let mut digest = CRC32C.digest();
    digest.update(&[kind, seq]);
    digest.update(payload);
    let crc = digest.finalize().to_le_bytes();
    out.reserve(payload.len() + OVERHEAD + payload.len() / 254 + 3);
    let mut stuffing = Stuffing::new(out);
    for byte in [kind, seq].iter().chain(payload).chain(&crc) {
        stuffing.push(*byte);
    }
    stuffing.finish();
}

/// Longest encoding, delimiter included, of a frame with that much payload.
#[must_use]
pub const fn encoded_len(payload: usize) -> usize {
    let decoded = payload + OVERHEAD;
    decoded + decoded / 254 + 2
}

/// Writes COBS: a code byte, then up to 254 bytes that are not zero.
struct Stuffing<'a> {
    out: &'a mut Vec<u8>,
    /// Where the code byte of the running block stands.
    code_at: usize,
    code: u8,
}

impl<'a> Stuffing<'a> {
    fn new(out: &'a mut Vec<u8>) -> Self {
        let code_at = out.len();
        out.push(0);
        Stuffing { out, code_at, code: 1 }
    }

    fn push(&mut self, byte: u8) {
        if byte != 0 {
            self.out.push(byte);
            self.code += 1;
        }
        if byte == 0 || self.code == 0xFF {
            self.close();
            self.code_at = self.out.len();
            self.out.push(0);
            self.code = 1;
        }
    }

    fn close(&mut self) {
        self.out[self.code_at] = self.code;
    }

    fn finish(mut self) {
        self.close();
        self.out.push(DELIMITER);
    }
}

/// Decodes the bytes between two delimiters.
pub fn decode(stuffed: &[u8]) -> Result<Frame, FrameError> {
    let mut bytes = Vec::with_capacity(stuffed.len());
    let mut rest = stuffed;
    while let Some((&code, after)) = rest.split_first() {
        let run = usize::from(code).checked_sub(1).ok_or(FrameError::Stuffing)?;
        if run > after.len() {
            return Err(FrameError::Stuffing);
        }
        let (block, next) = after.split_at(run);
        bytes.extend_from_slice(block);
        if code != 0xFF && !next.is_empty() {
            bytes.push(0);
        }
        rest = next;
    }
    let content_len = bytes.len().checked_sub(4).filter(|n| *n >= 2).ok_or(FrameError::Short)?;
    let (content, crc) = bytes.split_at(content_len);
    if CRC32C.checksum(content).to_le_bytes() != crc {
        return Err(FrameError::Checksum);
    }
    Ok(Frame { kind: content[0], seq: content[1], payload: content[2..].to_vec() })
}

/// Collects bytes into frames; holds at most one frame of the longest permitted length.
#[derive(Clone, Debug)]
pub struct FrameDecoder {
    stuffed: Vec<u8>,
    limit: usize,
    too_long: bool,
}

impl FrameDecoder {
    /// A decoder for frames of at most `max_payload` bytes of payload.
    #[must_use]
    pub fn new(max_payload: usize) -> Self {
        FrameDecoder { stuffed: Vec::new(), limit: encoded_len(max_payload), too_long: false }
    }

    /// Takes one byte; answers when it ends a frame, good or damaged. Delimiters in a row are no frames.
    pub fn push(&mut self, byte: u8) -> Option<Result<Frame, FrameError>> {
        if byte != DELIMITER {
            if self.stuffed.len() < self.limit {
                self.stuffed.push(byte);
            } else {
                self.too_long = true;
            }
            return None;
        }
        let too_long = core::mem::take(&mut self.too_long);
        let answer = if self.stuffed.is_empty() {
            None
        } else if too_long {
            Some(Err(FrameError::TooLong))
        } else {
            Some(decode(&self.stuffed))
        };
        self.stuffed.clear();
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn encoded(kind: u8, seq: u8, payload: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        encode(kind, seq, payload, &mut out);
        out
    }

    /// The example of PROTOCOL.md, worked out independently.
    #[test]
    fn a_ping_looks_like_this_on_the_line() {
        assert_eq!(encoded(kind::PING, 7, &[]), [0x07, 0x04, 0x07, 0xE5, 0x72, 0x21, 0x6B, 0x00]);
    }

    #[test]
    fn the_checksum_is_crc32c() {
        assert_eq!(CRC32C.checksum(b"123456789"), 0xE306_9283);
    }

    #[test]
    fn lengths_around_the_stuffing_blocks_come_back() {
        for fill in [0_u8, 1, 0xFF] {
            for len in (0..6).chain(245..260).chain(500..515) {
                let payload = vec![fill; len];
                let bytes = encoded(kind::CHUNK, 0, &payload);
                assert!(bytes.len() <= encoded_len(len), "{} > {} at {len}", bytes.len(), encoded_len(len));
                assert_eq!(bytes.iter().position(|b| *b == 0), Some(bytes.len() - 1), "one zero, at the end");
                let frame = decode(&bytes[..bytes.len() - 1]);
                assert_eq!(frame, Ok(Frame { kind: kind::CHUNK, seq: 0, payload }));
            }
        }
    }

    #[test]
    fn nothing_with_its_checksum_is_no_frame() {
        // COBS of 00 00 00 00, which is the CRC of nothing.
        assert_eq!(decode(&[1, 1, 1, 1, 1]), Err(FrameError::Short));
    }

    #[test]
    fn a_decoder_forgets_a_frame_that_is_too_long_and_goes_on() {
        let mut decoder = FrameDecoder::new(4);
        let mut bytes = vec![9; 100];
        bytes.extend_from_slice(&[0, 0, 0]);
        bytes.extend_from_slice(&encoded(kind::PONG, 1, &[1, 2, 3, 4]));
        let answers: Vec<_> = bytes.into_iter().filter_map(|b| decoder.push(b)).collect();
        assert_eq!(
            answers,
            [Err(FrameError::TooLong), Ok(Frame { kind: kind::PONG, seq: 1, payload: vec![1, 2, 3, 4] })]
        );
    }
}
