//! The test vectors of the protocol: files in `vectors/` that hold bytes and what they mean. Here they are compared
//! with this implementation; `decode.py`, which shares no code with it, has to read the same from them.
//!
//! `TECHNOL_BLESS=1` writes the files anew, after a change that is meant.
#![allow(clippy::unwrap_used)] // tests

mod samples;
mod session;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use technol_wire::frame::{self, FrameError};
use technol_wire::message::{Event, KNOWN_REQUESTS, Request, Response};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("vectors")
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn unhex(text: &str) -> Vec<u8> {
    (0..text.len()).step_by(2).map(|at| u8::from_str_radix(&text[at..at + 2], 16).unwrap()).collect()
}

/// One vector a line, so that a change shows as such.
fn written(vectors: &[Value]) -> String {
    let lines: Vec<String> = vectors.iter().map(Value::to_string).collect();
    format!("[\n{}\n]\n", lines.join(",\n"))
}

/// The file holds what this implementation makes.
fn compare(file: &str, vectors: &[Value]) {
    let path = folder().join(file);
    let made = written(vectors);
    if std::env::var_os("TECHNOL_BLESS").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    for (made, kept) in made.lines().zip(kept.lines()) {
        assert_eq!(made, kept, "{file} (TECHNOL_BLESS=1 writes it anew)");
    }
    assert_eq!(made.lines().count(), kept.lines().count(), "{file} (TECHNOL_BLESS=1 writes it anew)");
}

fn read(file: &str) -> Vec<Value> {
    let text = std::fs::read_to_string(folder().join(file)).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn message<T: Serialize>(of: &str, message: &T) -> Value {
    let bytes = postcard::to_allocvec(message).unwrap();
    json!({ "type": of, "bytes": hex(&bytes), "message": message })
}

fn messages() -> Vec<Value> {
    let requests = samples::requests();
    let requests = requests.iter().map(|m| message("Request", m));
    let responses = samples::responses();
    let responses = responses.iter().map(|m| message("Response", m));
    let events = samples::events();
    let events = events.iter().map(|m| message("Event", m));
    let bulk = [message("Chunk", &samples::chunk()), message("ChunkAck", &samples::chunk_ack())];
    requests.chain(responses).chain(events).chain(bulk).collect()
}

fn frames() -> Vec<Value> {
    samples::frames()
        .into_iter()
        .map(|(name, kind, seq, payload)| {
            let mut bytes = Vec::new();
            frame::encode(kind, seq, &payload, &mut bytes);
            json!({ "name": name, "bytes": hex(&bytes), "kind": kind, "seq": seq, "payload": hex(&payload) })
        })
        .collect()
}

fn damaged() -> Vec<Value> {
    samples::damaged()
        .into_iter()
        .map(|(name, bytes)| {
            let why = match frame::decode(&bytes[..bytes.len() - 1]).unwrap_err() {
                FrameError::Stuffing => "stuffing",
                FrameError::Short => "short",
                FrameError::Checksum => "checksum",
                FrameError::TooLong => "too long",
            };
            json!({ "name": name, "bytes": hex(&bytes), "why": why })
        })
        .collect()
}

#[test]
fn frames_look_as_the_vectors_say() {
    compare("frames.json", &frames());
    for vector in read("frames.json") {
        let bytes = unhex(vector["bytes"].as_str().unwrap());
        let frame = frame::decode(&bytes[..bytes.len() - 1]).unwrap();
        assert_eq!((json!(frame.kind), json!(frame.seq)), (vector["kind"].clone(), vector["seq"].clone()));
        assert_eq!(hex(&frame.payload), vector["payload"], "{}", vector["name"]);
    }
}

#[test]
fn what_is_no_frame_is_refused_as_the_vectors_say() {
    compare("damaged.json", &damaged());
}

fn comes_back<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(vector: &Value) {
    let bytes = unhex(vector["bytes"].as_str().unwrap());
    let read: T = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(serde_json::to_value(&read).unwrap(), vector["message"]);
    assert_eq!(postcard::to_allocvec(&read).unwrap(), bytes);
}

#[test]
fn messages_look_as_the_vectors_say() {
    compare("messages.json", &messages());
    for vector in read("messages.json") {
        match vector["type"].as_str().unwrap() {
            "Request" => comes_back::<Request>(&vector),
            "Response" => comes_back::<Response>(&vector),
            "Event" => comes_back::<Event>(&vector),
            "Chunk" => comes_back::<technol_wire::message::Chunk>(&vector),
            _ => comes_back::<technol_wire::message::ChunkAck>(&vector),
        }
    }
}

#[test]
fn there_is_a_vector_for_every_message() {
    let numbers = |of: &str| -> BTreeSet<u8> {
        let vectors = messages();
        let of_type = vectors.iter().filter(|v| v["type"] == of);
        of_type.map(|v| unhex(v["bytes"].as_str().unwrap())[0]).collect()
    };
    assert_eq!(numbers("Request"), (0..KNOWN_REQUESTS as u8).collect());
    assert_eq!(numbers("Response"), (0..samples::RESPONSES).collect());
    assert_eq!(numbers("Event"), (0..samples::EVENTS).collect());
}

#[test]
fn a_whole_session_goes_over_the_line_as_recorded() {
    compare("session.json", &session::record());
}

#[test]
fn an_independent_decoder_reads_the_same() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vectors/decode.py");
    let python = if cfg!(windows) { "python" } else { "python3" };
    match Command::new(python).arg(&script).arg(folder()).output() {
        Err(_) => eprintln!("SKIPPED: {python} is not installed, so nobody else has read the vectors"),
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stdout);
            let complained = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "decode.py disagrees:\n{said}{complained}");
            // It must have read them all, not just found nothing to complain about.
            let count: usize = said.trim().strip_suffix(" vectors agree").unwrap().parse().unwrap();
            let files = ["frames.json", "damaged.json", "messages.json", "session.json"];
            assert_eq!(count, files.iter().map(|file| read(file).len()).sum::<usize>());
        }
    }
}
