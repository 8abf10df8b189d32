//! Everything that goes to the client: one writer that numbers the messages.

use std::sync::mpsc::{SyncSender, TrySendError};
use std::time::{Duration, Instant};

use dap::events::Event;
use serde_json::{Map, Value, json};

use crate::errors::RequestError;
use crate::request::Request;
use crate::transport::encode;

/// Messages that may wait for a client that does not read.
pub(crate) const QUEUE: usize = 1024;
/// A client that takes nothing for this long counts as gone.
const PATIENCE: Duration = Duration::from_secs(5);

/// Sends responses and events in order.
#[derive(Debug)]
pub(crate) struct Outbox {
    seq: i64,
    sink: SyncSender<Vec<u8>>,
    gone: bool,
}

impl Outbox {
    pub(crate) fn new(sink: SyncSender<Vec<u8>>) -> Self {
        Outbox { seq: 0, sink, gone: false }
    }

    /// The client does not read any more.
    pub(crate) fn is_gone(&self) -> bool {
        self.gone
    }

    /// Answers a request.
    pub(crate) fn respond(&mut self, request: &Request, result: Result<Value, &RequestError>) {
        let mut response = json!({
            "type": "response",
            "request_seq": request.seq,
            "command": request.command,
            "success": result.is_ok(),
        });
        match result {
            Ok(Value::Null) => {}
            Ok(body) => response["body"] = body,
            Err(error) => {
                // Some clients show `message`, some `body.error.format`; two words in `message` mean something to them.
                response["message"] = error.word().map_or_else(|| json!(error.to_string()), |w| json!(w));
                response["body"] = json!({ "error": {
                    "id": error.id(),
                    "format": escape(&error.to_string()),
                    "showUser": error.show_user(),
                }});
            }
        }
        self.send(response);
    }

    /// Reports something.
    pub(crate) fn event(&mut self, event: &Event) {
        // Plain data: serialising it has no way to fail.
        let mut message = serde_json::to_value(event).unwrap_or_default();
        message["type"] = json!("event");
        self.send(message);
    }

    /// Reports something that the protocol has no event for.
    pub(crate) fn custom(&mut self, event: &str, body: &Value) {
        self.send(json!({ "type": "event", "event": event, "body": body }));
    }

    fn send(&mut self, mut message: Value) {
        self.seq += 1;
        message["seq"] = json!(self.seq);
        remove_nulls(&mut message);
        let mut bytes = encode(&message);
        let give_up = Instant::now() + PATIENCE;
        while !self.gone {
            bytes = match self.sink.try_send(bytes) {
                Err(TrySendError::Full(back)) if Instant::now() < give_up => back,
                result => {
                    self.gone = result.is_err();
                    return;
                }
            };
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

/// Braces in `format` would be taken for names of variables.
fn escape(text: &str) -> String {
    text.replace('{', "(").replace('}', ")")
}

/// Optional fields that are not there must be absent: some clients take `null` for a value.
fn remove_nulls(value: &mut Value) {
    match value {
        Value::Object(map) => {
            let old = std::mem::take(map);
            *map = old
                .into_iter()
                .filter(|(_, v)| !v.is_null())
                .map(|(k, mut v)| {
                    remove_nulls(&mut v);
                    (k, v)
                })
                .collect::<Map<_, _>>();
        }
        Value::Array(items) => items.iter_mut().for_each(remove_nulls),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::{Decoder, Incoming};
    use dap::events::ThreadEventBody;
    use dap::types::ThreadEventReason;
    use std::sync::mpsc::sync_channel;

    #[test]
    fn messages_are_numbered_and_hold_no_nulls() {
        let (sink, sent) = sync_channel(8);
        let mut outbox = Outbox::new(sink);
        let request = Request { seq: 7, command: "threads".into(), arguments: Value::Null };
        outbox.respond(&request, Ok(json!({"a": null, "b": [{"c": null, "d": 1}]})));
        outbox.respond(&request, Ok(Value::Null));
        outbox.respond(&request, Err(&RequestError::Unknown { command: "x{y}".into() }));
        outbox.event(&Event::Thread(ThreadEventBody { reason: ThreadEventReason::Started, thread_id: 1 }));
        outbox.event(&Event::Terminated(None));
        let mut decoder = Decoder::default();
        for bytes in sent.try_iter() {
            decoder.push(&bytes);
        }
        let messages: Vec<Value> = std::iter::from_fn(|| decoder.next())
            .map(|m| if let Incoming::Message(v) = m { v } else { panic!("{m:?}") })
            .collect();
        assert_eq!(
            messages,
            [
                json!({"seq": 1, "type": "response", "request_seq": 7, "command": "threads", "success": true,
                       "body": {"b": [{"d": 1}]}}),
                json!({"seq": 2, "type": "response", "request_seq": 7, "command": "threads", "success": true}),
                json!({"seq": 3, "type": "response", "request_seq": 7, "command": "threads", "success": false,
                       "message": "the request `x{y}` is not known here",
                       "body": {"error": {"id": 1, "format": "the request `x(y)` is not known here", "showUser": false}}}),
                json!({"seq": 4, "type": "event", "event": "thread", "body": {"reason": "started", "threadId": 1}}),
                json!({"seq": 5, "type": "event", "event": "terminated"}),
            ]
        );
    }

    #[test]
    fn a_client_that_went_away_is_noticed() {
        let (sink, sent) = sync_channel(8);
        drop(sent);
        let mut outbox = Outbox::new(sink);
        outbox.event(&Event::Initialized);
        assert!(outbox.is_gone());
    }
}
