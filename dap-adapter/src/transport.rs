//! The byte form of DAP messages: headers, a blank line, a JSON body and nothing after it.
//!
//! Reading is forgiving (any order and case of headers, bare line feeds, junk between messages), writing is strict.

use serde_json::Value;

/// Longest header block that is searched for its end, in bytes.
const MAX_HEADER: usize = 16 * 1024;
/// Longest body that is taken, in bytes.
const MAX_BODY: usize = 64 * 1024 * 1024;
const LENGTH: &[u8] = b"content-length:";

/// What came out of the stream.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Incoming {
    /// A body that is JSON.
    Message(Value),
    /// A body that is not JSON.
    Malformed {
        /// The body, bytes that are not UTF-8 replaced.
        text: String,
        /// What the JSON reader said.
        reason: String,
    },
    /// Bytes outside any message; they were skipped.
    Junk(String),
}

/// Cuts a stream of bytes, in pieces of any size, into messages.
#[derive(Debug, Default)]
pub(crate) struct Decoder {
    buffer: Vec<u8>,
    /// Start of what has not been taken yet.
    start: usize,
    /// Up to here no end of headers was found.
    searched: usize,
}

impl Decoder {
    /// Adds what arrived.
    pub(crate) fn push(&mut self, bytes: &[u8]) {
        if self.start > 0 {
            self.buffer.drain(..self.start);
            self.searched = self.searched.saturating_sub(self.start);
            self.start = 0;
        }
        self.buffer.extend_from_slice(bytes);
    }

    /// The next message, or `None` until more bytes arrive.
    pub(crate) fn next(&mut self) -> Option<Incoming> {
        while matches!(self.buffer.get(self.start), Some(b'\r' | b'\n')) {
            self.start += 1;
        }
        let Some(body) = self.end_of_headers() else {
            return self.overlong_header();
        };
        let headers = &self.buffer[self.start..body];
        let Some(length) = content_length(headers).filter(|n| *n <= MAX_BODY) else {
            let junk = Incoming::Junk(excerpt(headers));
            self.take(body);
            return Some(junk);
        };
        let end = body + length;
        if self.buffer.len() < end {
            return None;
        }
        let bytes = &self.buffer[body..end];
        let incoming = match serde_json::from_slice(bytes) {
            Ok(value) => Incoming::Message(value),
            Err(error) => Incoming::Malformed {
                text: String::from_utf8_lossy(bytes).into_owned(),
                reason: error.to_string(),
            },
        };
        self.take(end);
        Some(incoming)
    }

    fn take(&mut self, to: usize) {
        self.start = to;
        self.searched = to;
    }

    /// Index of the first byte after the blank line.
    fn end_of_headers(&mut self) -> Option<usize> {
        let mut at = self.searched.max(self.start);
        while let Some(n) = self.buffer[at..].iter().position(|b| *b == b'\n') {
            let next = at + n + 1;
            match self.buffer.get(next..) {
                Some([b'\n', ..]) => return Some(next + 1),
                Some([b'\r', b'\n', ..]) => return Some(next + 2),
                // The blank line may still be on its way.
                Some([] | [b'\r']) | None => {
                    self.searched = at + n;
                    return None;
                }
                Some(_) => at = next,
            }
        }
        self.searched = at;
        None
    }

    /// Drops a header block that does not end, but keeps what may be the start of a good one.
    fn overlong_header(&mut self) -> Option<Incoming> {
        if self.buffer.len() - self.start <= MAX_HEADER {
            return None;
        }
        let block = &self.buffer[self.start..];
        let junk = Incoming::Junk(excerpt(block));
        let keep = find_last(block, LENGTH)
            .filter(|at| *at > 0 && block.len() - at < MAX_HEADER)
            .unwrap_or(block.len() - LENGTH.len());
        self.take(self.start + keep);
        Some(junk)
    }
}

/// The value of `Content-Length`, wherever in the block it stands (junk may precede it on its line).
fn content_length(headers: &[u8]) -> Option<usize> {
    let at = find_last(headers, LENGTH)? + LENGTH.len();
    let line = headers[at..].split(|b| matches!(b, b'\r' | b'\n')).next()?;
    std::str::from_utf8(line).ok()?.trim().parse().ok()
}

fn find_last(block: &[u8], lower_case: &[u8]) -> Option<usize> {
    block.windows(lower_case.len()).rposition(|w| w.eq_ignore_ascii_case(lower_case))
}

fn excerpt(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(80)]).trim().to_owned()
}

/// The bytes of a message.
pub(crate) fn encode(message: &Value) -> Vec<u8> {
    let body = message.to_string();
    let mut bytes = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
    bytes.extend_from_slice(body.as_bytes());
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use serde_json::json;

    fn decode(pieces: &[&[u8]]) -> Vec<Incoming> {
        let mut decoder = Decoder::default();
        let mut out = Vec::new();
        for piece in pieces {
            decoder.push(piece);
            out.extend(std::iter::from_fn(|| decoder.next()));
        }
        out
    }

    #[test]
    fn headers_come_in_any_order_case_and_line_ending() {
        for headers in [
            "Content-Length: 7\r\n\r\n",
            "content-length:7\r\n\r\n",
            "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\nCONTENT-LENGTH:  7 \r\n\r\n",
            "Content-Length: 7\r\nX-Other: a: b\r\n\r\n",
            "Content-Length: 7\n\n",
            "\r\n\r\nContent-Length: 7\r\n\r\n",
            "{\"cut off\": 1}Content-Length: 7\r\n\r\n",
        ] {
            let text = format!("{headers}{{\"a\":1}}");
            assert_eq!(decode(&[text.as_bytes()]), [Incoming::Message(json!({"a": 1}))], "{headers:?}");
        }
    }

    #[test]
    fn nothing_follows_the_body() {
        let bytes = encode(&json!({"text": "č"}));
        assert_eq!(bytes, "Content-Length: 13\r\n\r\n{\"text\":\"č\"}".as_bytes());
    }

    #[test]
    fn a_bad_body_does_not_take_the_next_message_along() {
        let stream = b"Content-Length: 5\r\n\r\n{\"a\":Content-Length: 7\r\n\r\n{\"a\":1}";
        let out = decode(&[stream]);
        assert!(matches!(&out[0], Incoming::Malformed { text, .. } if text == "{\"a\":"), "{out:?}");
        assert_eq!(out[1], Incoming::Message(json!({"a": 1})));
    }

    #[test]
    fn junk_is_skipped_up_to_the_next_header() {
        let out = decode(&[b"GET / HTTP/1.1\r\nHost: x\r\n\r\nContent-Length: 2\r\n\r\n{}"]);
        assert_eq!(out, [Incoming::Junk("GET / HTTP/1.1\r\nHost: x".into()), Incoming::Message(json!({}))]);
        let mut endless = vec![b'x'; 3 * MAX_HEADER];
        endless.extend_from_slice(b"Content-Length: 2\r\n\r\n{}");
        let out = decode(&endless.chunks(1000).collect::<Vec<_>>());
        assert_eq!(out.last(), Some(&Incoming::Message(json!({}))));
    }

    #[test]
    fn absurd_lengths_are_junk() {
        for length in ["99999999999999999999", "-1", "7x", "", "1073741824"] {
            let stream = format!("Content-Length: {length}\r\n\r\nContent-Length: 2\r\n\r\n{{}}");
            assert_eq!(decode(&[stream.as_bytes()]).last(), Some(&Incoming::Message(json!({}))), "{length}");
        }
    }

    proptest! {
        #[test]
        fn messages_survive_any_chunking(
            texts in prop::collection::vec(".{0,40}", 1..8),
            cuts in prop::collection::vec(1_usize..40, 0..40),
        ) {
            let messages: Vec<Value> = texts.iter().map(|t| json!({"seq": 1, "text": t})).collect();
            let stream: Vec<u8> = messages.iter().flat_map(encode).collect();
            let mut decoder = Decoder::default();
            let mut out = Vec::new();
            let mut rest = &stream[..];
            for cut in cuts.into_iter().chain([usize::MAX]) {
                let (piece, tail) = rest.split_at(cut.min(rest.len()));
                rest = tail;
                decoder.push(piece);
                out.extend(std::iter::from_fn(|| decoder.next()));
            }
            prop_assert_eq!(out, messages.into_iter().map(Incoming::Message).collect::<Vec<_>>());
        }

        #[test]
        fn any_bytes_end_in_bounded_memory(chunks in prop::collection::vec(prop::collection::vec(any::<u8>(), 0..4000), 0..20)) {
            let mut decoder = Decoder::default();
            for chunk in &chunks {
                decoder.push(chunk);
                while decoder.next().is_some() {}
                prop_assert!(decoder.buffer.len() - decoder.start <= MAX_HEADER + 4000 || content_length(&decoder.buffer[decoder.start..]).is_some());
            }
        }
    }
}
