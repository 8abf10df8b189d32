//! Guards the transport against bytes that are no message.
//!
//! The transport behind us ends its session at the first body it can't read. So every frame is checked here
//! first: a sound one goes through untouched, an unsound one is replaced by a notification
//! [`UNREADABLE`] that says what was wrong, and the end of input becomes [`INPUT_CLOSED`]. Both reach the main
//! loop in their order, which answers the first with an error and ends at the second.

use std::io;

use serde_json::{Value, json};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tower_lsp::jsonrpc::{Request, Response};

/// Method that stands in for a frame that could not be read.
pub(crate) const UNREADABLE: &str = "$/technol/unreadable";
/// Method that stands for the end of input.
pub(crate) const INPUT_CLOSED: &str = "$/technol/inputClosed";

/// JSON-RPC's code for a body that is no JSON.
const PARSE_ERROR: i64 = -32700;
/// JSON-RPC's code for JSON that is no message.
const INVALID_REQUEST: i64 = -32600;
/// A header block longer than this is not one.
const LONGEST_HEADER: usize = 8 * 1024;
/// A body longer than this is refused: no editor sends one, and a wrong length must not eat the memory.
const LONGEST_BODY: usize = 256 * 1024 * 1024;

/// What was found at the front of the buffer.
#[derive(Debug, PartialEq, Eq)]
enum Found {
    /// Not enough bytes yet.
    Partial,
    /// A frame: its header's and its body's length.
    Frame { header: usize, body: usize },
    /// Bytes that are no header; so many can be dropped.
    Garbage(usize),
}

/// Copies frames from `input` to `output` until either ends.
pub(crate) async fn guard<R, W>(mut input: R, mut output: W)
where
    R: AsyncRead + Unpin,
    W: AsyncWrite + Unpin,
{
    let mut buffer = Vec::with_capacity(64 * 1024);
    loop {
        if pass_frames(&mut buffer, &mut output).await.is_err() {
            return; // the session is over on the other side
        }
        match input.read_buf(&mut buffer).await {
            Ok(0) | Err(_) => break,
            Ok(_) => {}
        }
    }
    let closed = json!({ "jsonrpc": "2.0", "method": INPUT_CLOSED });
    let _ = write_frame(&mut output, &closed).await;
    let _ = output.shutdown().await;
}

/// Passes on every whole frame at the front of `buffer` and removes it.
async fn pass_frames<W: AsyncWrite + Unpin>(buffer: &mut Vec<u8>, output: &mut W) -> io::Result<()> {
    loop {
        match find_frame(buffer) {
            Found::Partial => return Ok(()),
            Found::Garbage(length) => {
                buffer.drain(..length);
                let what = unreadable(PARSE_ERROR, "the header has no Content-Length", &Value::Null);
                write_frame(output, &what).await?;
            }
            Found::Frame { header, body } => {
                if buffer.len() < header + body {
                    buffer.reserve(header + body - buffer.len());
                    return Ok(());
                }
                match check_body(&buffer[header..header + body]) {
                    Ok(()) => {
                        output.write_all(format!("Content-Length: {body}\r\n\r\n").as_bytes()).await?;
                        output.write_all(&buffer[header..header + body]).await?;
                    }
                    Err(replacement) => write_frame(output, &replacement).await?,
                }
                buffer.drain(..header + body);
            }
        }
    }
}

/// Looks at the front of the buffer for a header block.
fn find_frame(buffer: &[u8]) -> Found {
    let Some(end) = find(buffer, b"\r\n\r\n") else {
        return if buffer.len() > LONGEST_HEADER { Found::Garbage(resume(buffer)) } else { Found::Partial };
    };
    match content_length(&buffer[..end]) {
        Some(body) if body <= LONGEST_BODY => Found::Frame { header: end + 4, body },
        _ => Found::Garbage(end + 4),
    }
}

/// How many bytes of a headerless buffer to drop: all, but for what may be the start of a header.
fn resume(buffer: &[u8]) -> usize {
    match find(&buffer[1..], b"Content-Length") {
        Some(at) => at + 1,
        None => buffer.len() - b"Content-Length".len(),
    }
}

/// The value of the last `Content-Length` in the block, whatever stands before it: stray bytes right before a
/// header don't lose the frame.
fn content_length(header: &[u8]) -> Option<usize> {
    let name = b"content-length:";
    let at = header.windows(name.len()).rposition(|window| window.eq_ignore_ascii_case(name))?;
    let value = header[at + name.len()..].split(|&byte| byte == b'\r').next()?;
    std::str::from_utf8(value).ok()?.trim().parse().ok()
}

fn find(haystack: &[u8], needle: &[u8]) -> Option<usize> {
    haystack.windows(needle.len()).position(|window| window == needle)
}

/// Ok when the transport can read the body; otherwise what to pass on in its place.
fn check_body(body: &[u8]) -> Result<(), Value> {
    let text = std::str::from_utf8(body).map_err(|error| {
        unreadable(PARSE_ERROR, &format!("the message is not UTF-8: {error}"), &Value::Null)
    })?;
    if text.parse::<Response>().is_ok() || text.parse::<Request>().is_ok_and(|it| !it.method().is_empty()) {
        return Ok(());
    }
    match serde_json::from_str::<Value>(text) {
        Err(error) => {
            Err(unreadable(PARSE_ERROR, &format!("the message is not JSON: {error}"), &Value::Null))
        }
        Ok(value) => {
            let answer = value.get("result").is_some() || value.get("error").is_some();
            let id = value.get("id").filter(|id| !answer && (id.is_i64() || id.is_string()));
            let id = id.cloned().unwrap_or_default();
            let message = "the message is no JSON-RPC 2.0 request, notification or response";
            Err(unreadable(INVALID_REQUEST, message, &id))
        }
    }
}

fn unreadable(code: i64, message: &str, id: &Value) -> Value {
    let params = json!({ "code": code, "message": message, "id": id });
    json!({ "jsonrpc": "2.0", "method": UNREADABLE, "params": params })
}

async fn write_frame<W: AsyncWrite + Unpin>(output: &mut W, message: &Value) -> io::Result<()> {
    let body = message.to_string();
    output.write_all(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes()).await
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    /// Everything the guard passes on for these chunks of input.
    fn guarded(chunks: &[&[u8]]) -> Vec<Value> {
        let input: Vec<u8> = chunks.concat();
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        let mut output = Vec::new();
        runtime.block_on(guard(&input[..], &mut output));
        let mut messages = Vec::new();
        while let Found::Frame { header, body } = find_frame(&output) {
            messages.push(serde_json::from_slice(&output[header..header + body]).unwrap());
            output.drain(..header + body);
        }
        assert!(output.is_empty());
        messages
    }

    fn methods(messages: &[Value]) -> Vec<&str> {
        messages.iter().map(|it| it["method"].as_str().unwrap_or("response")).collect()
    }

    #[test]
    fn sound_messages_pass_untouched_and_the_end_is_told() {
        let request = r#"{"jsonrpc":"2.0","id":"a","method":"x","params":[1]}"#;
        let response = r#"{"jsonrpc":"2.0","id":7,"result":null}"#;
        let passed = guarded(&[frame(request).as_bytes(), frame(response).as_bytes()]);
        assert_eq!(passed[0].to_string(), serde_json::from_str::<Value>(request).unwrap().to_string());
        assert_eq!(methods(&passed), ["x", "response", INPUT_CLOSED]);
    }

    #[test]
    fn unsound_bodies_are_replaced_and_the_next_message_still_passes() {
        let good = frame(r#"{"jsonrpc":"2.0","method":"next"}"#);
        let deep =
            format!(r#"{{"jsonrpc":"2.0","method":"m","params":{}1{}}}"#, "[".repeat(500), "]".repeat(500));
        for (body, code) in [
            ("{", PARSE_ERROR),
            ("", PARSE_ERROR),
            ("[]", INVALID_REQUEST),
            ("{}", INVALID_REQUEST),
            (r#"{"jsonrpc":"1.0","id":1,"method":"x"}"#, INVALID_REQUEST),
            (r#"{"jsonrpc":"2.0","id":1.5,"method":"x"}"#, INVALID_REQUEST),
            (deep.as_str(), PARSE_ERROR),
        ] {
            let passed = guarded(&[frame(body).as_bytes(), good.as_bytes()]);
            assert_eq!(methods(&passed), [UNREADABLE, "next", INPUT_CLOSED], "{body}");
            assert_eq!(passed[0]["params"]["code"], code, "{body}");
        }
    }

    #[test]
    fn a_message_with_an_id_but_no_meaning_is_answered_under_its_id() {
        let passed = guarded(&[frame(r#"{"jsonrpc":"2.0","id":41}"#).as_bytes()]);
        assert_eq!(passed[0]["params"]["id"], 41);
    }

    #[test]
    fn bytes_that_are_not_utf8_and_headers_without_a_length_are_survived() {
        let good = frame(r#"{"jsonrpc":"2.0","method":"next"}"#);
        for bad in
            [&b"Content-Length: 2\r\n\r\n\xff\xfe"[..], b"Hello: there\r\n\r\n", b"Content-Length: x\r\n\r\n"]
        {
            assert_eq!(methods(&guarded(&[bad, good.as_bytes()])), [UNREADABLE, "next", INPUT_CLOSED]);
        }
        let noise = vec![b'x'; LONGEST_HEADER + 1];
        let passed = guarded(&[&noise, good.as_bytes()]);
        assert_eq!(
            methods(&passed),
            ["next", INPUT_CLOSED],
            "bytes right before a header don't lose its frame"
        );
    }

    #[test]
    fn lower_case_and_further_header_lines_are_accepted() {
        let body = r#"{"jsonrpc":"2.0","method":"next"}"#;
        let head = format!(
            "content-type: application/vscode-jsonrpc\r\ncontent-length:{}\r\nX: y\r\n\r\n",
            body.len()
        );
        assert_eq!(methods(&guarded(&[head.as_bytes(), body.as_bytes()])), ["next", INPUT_CLOSED]);
    }
}
