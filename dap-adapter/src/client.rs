//! A DAP client: starts conversations with an adapter, remembers all it said in one timeline, and waits for what
//! is expected. For tests, demonstrations and scripts.

use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use thiserror::Error;

use crate::server::{Surroundings, serve};
use crate::transport::{Decoder, Incoming, encode};

/// How long the client waits for anything unless told otherwise.
pub const PATIENCE: Duration = Duration::from_secs(15);

/// Why a conversation cannot go on.
#[derive(Debug, Error)]
pub enum ClientError {
    /// Sending failed.
    #[error("the adapter does not read: {0}")]
    Io(#[from] io::Error),
    /// The expected message did not come.
    #[error("no {what} within {seconds:.1} s; the last messages were:\n{last}")]
    Timeout {
        /// What was waited for.
        what: String,
        /// How long.
        seconds: f64,
        /// The end of the timeline.
        last: String,
    },
    /// The adapter closed the connection.
    #[error("the adapter closed the connection while {what} was expected; the last messages were:\n{last}")]
    Closed {
        /// What was waited for.
        what: String,
        /// The end of the timeline.
        last: String,
    },
    /// The adapter refused a request.
    #[error("{command}: {message}")]
    Refused {
        /// The request.
        command: String,
        /// The text people read.
        message: String,
        /// The whole response.
        response: Value,
    },
    /// The adapter broke the protocol.
    #[error("the adapter broke the protocol: {0}")]
    Protocol(String),
}

/// A place in the timeline: events are looked for after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mark(usize);

impl Mark {
    /// Before the first message.
    pub const START: Mark = Mark(0);
}

/// A conversation with an adapter.
pub struct Client {
    output: Box<dyn Write + Send>,
    received: Receiver<Result<Value, String>>,
    timeline: Vec<Value>,
    next_seq: i64,
    last_adapter_seq: i64,
    patience: Duration,
    closed: bool,
    /// An adapter in this process.
    adapter: Option<JoinHandle<()>>,
}

impl Client {
    /// Talks over a pair of streams (a child process, a pipe).
    pub fn new(input: impl Read + Send + 'static, output: impl Write + Send + 'static) -> Self {
        let (sender, received) = channel();
        std::thread::spawn(move || {
            let mut input = input;
            let mut decoder = Decoder::default();
            let mut buffer = [0; 16 * 1024];
            while let Ok(n) = input.read(&mut buffer) {
                if n == 0 {
                    break;
                }
                decoder.push(&buffer[..n]);
                while let Some(incoming) = decoder.next() {
                    let message = match incoming {
                        Incoming::Message(message) => Ok(message),
                        Incoming::Malformed { reason, .. } => Err(format!("a body is not JSON: {reason}")),
                        Incoming::Junk(text) => Err(format!("bytes outside messages: {text:?}")),
                    };
                    if sender.send(message).is_err() {
                        return;
                    }
                }
            }
        });
        Client {
            output: Box::new(output),
            received,
            timeline: Vec::new(),
            next_seq: 0,
            last_adapter_seq: 0,
            patience: PATIENCE,
            closed: false,
            adapter: None,
        }
    }

    /// Talks over TCP.
    pub fn connect(address: &str) -> Result<Self, ClientError> {
        let stream = TcpStream::connect(address)?;
        stream.set_nodelay(true)?;
        Ok(Client::new(stream.try_clone()?, stream))
    }

    /// Talks to an adapter in this process, through bytes all the same. It ends when the client is dropped.
    pub fn in_process(surroundings: &Surroundings) -> Result<Self, ClientError> {
        let (adapter_in, client_out) = io::pipe()?;
        let (client_in, adapter_out) = io::pipe()?;
        let surroundings = surroundings.clone();
        let adapter = std::thread::spawn(move || {
            // The client hears of an end that is no good end.
            let _ = serve(adapter_in, adapter_out, &surroundings);
        });
        Ok(Client { adapter: Some(adapter), ..Client::new(client_in, client_out) })
    }

    /// Ends the conversation. An adapter in this process has ended then too, and with it an embedded target, which has written
    /// its files.
    pub fn end(self) {
        let Client { output, received, adapter, .. } = self;
        drop((output, received));
        if let Some(adapter) = adapter {
            // A panic in it has already been printed.
            let _ = adapter.join();
        }
    }

    /// Waits so long from now on.
    pub fn set_patience(&mut self, patience: Duration) {
        self.patience = patience;
    }

    /// Everything the adapter said so far.
    pub fn timeline(&self) -> &[Value] {
        &self.timeline
    }

    /// The present end of the timeline.
    pub fn mark(&self) -> Mark {
        Mark(self.timeline.len())
    }

    /// Sends bytes as they are, to see how an adapter takes them.
    pub fn send_raw(&mut self, bytes: &[u8]) -> Result<(), ClientError> {
        self.output.write_all(bytes)?;
        self.output.flush()?;
        Ok(())
    }

    /// Sends a request without waiting; answers its number.
    pub fn send(&mut self, command: &str, arguments: Value) -> Result<i64, ClientError> {
        self.next_seq += 1;
        let seq = self.next_seq;
        let mut message = json!({ "seq": seq, "type": "request", "command": command });
        if !arguments.is_null() {
            message["arguments"] = arguments;
        }
        self.send_raw(&encode(&message))?;
        Ok(seq)
    }

    /// Sends a request and waits for the body of its answer (`Null` when it has none).
    pub fn request(&mut self, command: &str, arguments: Value) -> Result<Value, ClientError> {
        let seq = self.send(command, arguments)?;
        self.response(seq)
    }

    /// Waits for the answer to request `seq`.
    pub fn response(&mut self, seq: i64) -> Result<Value, ClientError> {
        let response = self.wait(Mark::START, &format!("response to request {seq}"), |m| {
            m["type"] == "response" && m["request_seq"] == seq
        })?;
        if response["success"] == true {
            return Ok(response["body"].clone());
        }
        let text = response["body"]["error"]["format"].as_str().or(response["message"].as_str());
        Err(ClientError::Refused {
            command: response["command"].as_str().unwrap_or_default().to_owned(),
            message: text.unwrap_or("no reason given").to_owned(),
            response,
        })
    }

    /// Waits for an event after `mark` and answers its body.
    pub fn event(&mut self, mark: Mark, name: &str) -> Result<Value, ClientError> {
        self.event_where(mark, name, |_| true)
    }

    /// Waits for an event whose body fulfils a condition.
    pub fn event_where(
        &mut self,
        mark: Mark,
        name: &str,
        condition: impl Fn(&Value) -> bool,
    ) -> Result<Value, ClientError> {
        let event = self.wait(mark, &format!("event `{name}`"), |m| {
            m["type"] == "event" && m["event"] == name && condition(&m["body"])
        })?;
        Ok(event["body"].clone())
    }

    /// `initialize` as a full client sends it; answers the capabilities.
    pub fn initialize(&mut self) -> Result<Value, ClientError> {
        self.request(
            "initialize",
            json!({
                "clientID": "technol", "adapterID": "technol", "linesStartAt1": true, "columnsStartAt1": true,
                "pathFormat": "path", "supportsVariableType": true, "supportsVariablePaging": true,
                "supportsInvalidatedEvent": true, "supportsProgressReporting": true,
            }),
        )
    }

    /// Initializes, launches, sets break-points (path and lines) and lets the program go. Answers the break-points
    /// as the adapter placed them, file by file.
    pub fn start(
        &mut self,
        launch: Value,
        breakpoints: &[(&str, &[u32])],
    ) -> Result<Vec<Value>, ClientError> {
        self.initialize()?;
        let mark = self.mark();
        self.request("launch", launch)?;
        self.event(mark, "initialized")?;
        let mut placed = Vec::new();
        for (path, lines) in breakpoints {
            placed.push(self.set_breakpoints(path, lines)?);
        }
        self.request("configurationDone", Value::Null)?;
        Ok(placed)
    }

    /// Replaces the break-points of a file; answers them as the adapter placed them.
    pub fn set_breakpoints(&mut self, path: &str, lines: &[u32]) -> Result<Value, ClientError> {
        let breakpoints: Vec<Value> = lines.iter().map(|line| json!({ "line": line })).collect();
        let body = self
            .request("setBreakpoints", json!({ "source": { "path": path }, "breakpoints": breakpoints }))?;
        Ok(body["breakpoints"].clone())
    }

    /// Sends a request that lets the program go on (`continue`, `next`, `stepIn`, `stepOut`, `pause`) for a thread
    /// and waits for the next stop.
    pub fn go(&mut self, command: &str, thread: i64) -> Result<Value, ClientError> {
        let mark = self.mark();
        self.request(command, json!({ "threadId": thread }))?;
        self.event(mark, "stopped")
    }

    /// The innermost frame of a thread.
    pub fn top_frame(&mut self, thread: i64) -> Result<Value, ClientError> {
        let body = self.request("stackTrace", json!({ "threadId": thread, "startFrame": 0, "levels": 1 }))?;
        Ok(body["stackFrames"][0].clone())
    }

    /// Children of a `variablesReference`.
    pub fn children(&mut self, reference: &Value) -> Result<Vec<Value>, ClientError> {
        let body = self.request("variables", json!({ "variablesReference": reference }))?;
        Ok(body["variables"].as_array().cloned().unwrap_or_default())
    }

    /// The variables of the scope of that name in a frame.
    pub fn scope(&mut self, frame: &Value, name: &str) -> Result<Vec<Value>, ClientError> {
        let body = self.request("scopes", json!({ "frameId": frame["id"] }))?;
        let scopes = body["scopes"].as_array().cloned().unwrap_or_default();
        let scope = scopes.iter().find(|s| s["name"] == name);
        let scope =
            scope.ok_or_else(|| ClientError::Protocol(format!("there is no scope `{name}`: {body}")))?;
        self.children(&scope["variablesReference"])
    }

    /// The value of an expression, in `watch`, `hover` or `repl` context.
    pub fn evaluate(&mut self, expression: &str, context: &str) -> Result<String, ClientError> {
        let body = self.request("evaluate", json!({ "expression": expression, "context": context }))?;
        Ok(body["result"].as_str().unwrap_or_default().to_owned())
    }

    /// Disconnects and waits until the adapter closes the stream.
    pub fn disconnect(&mut self, arguments: Value) -> Result<(), ClientError> {
        self.request("disconnect", arguments)?;
        let mark = self.mark();
        match self.wait(mark, "end of the connection", |_| false) {
            Err(ClientError::Closed { .. }) => Ok(()),
            Err(error) => Err(error),
            Ok(_) => Ok(()),
        }
    }

    fn wait(&mut self, mark: Mark, what: &str, is_it: impl Fn(&Value) -> bool) -> Result<Value, ClientError> {
        if let Some(found) = self.timeline[mark.0.min(self.timeline.len())..].iter().find(|m| is_it(m)) {
            return Ok(found.clone());
        }
        let deadline = Instant::now() + self.patience;
        while !self.closed {
            match self.received.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
                Ok(message) => {
                    let message = message.map_err(ClientError::Protocol)?;
                    self.note(&message)?;
                    if is_it(&message) {
                        return Ok(message);
                    }
                }
                Err(RecvTimeoutError::Timeout) => {
                    let (what, last) = (what.to_owned(), self.last());
                    return Err(ClientError::Timeout { what, seconds: self.patience.as_secs_f64(), last });
                }
                Err(RecvTimeoutError::Disconnected) => self.closed = true,
            }
        }
        Err(ClientError::Closed { what: what.to_owned(), last: self.last() })
    }

    /// Every message has to have its shape, whatever the test is about.
    fn note(&mut self, message: &Value) -> Result<(), ClientError> {
        self.timeline.push(message.clone());
        shape_fault(message, self.last_adapter_seq)
            .map_or(Ok(()), |fault| Err(ClientError::Protocol(format!("{fault}: {message}"))))?;
        self.last_adapter_seq += 1;
        Ok(())
    }

    fn last(&self) -> String {
        let from = self.timeline.len().saturating_sub(6);
        self.timeline[from..].iter().map(|m| format!("  {m}")).collect::<Vec<_>>().join("\n")
    }
}

/// Fields that the bodies of responses and events cannot do without.
const REQUIRED: &[(&str, &[&str])] = &[
    ("breakpointLocations", &["breakpoints"]),
    ("completions", &["targets"]),
    ("evaluate", &["result", "variablesReference"]),
    ("exceptionInfo", &["exceptionId", "breakMode"]),
    ("loadedSources", &["sources"]),
    ("scopes", &["scopes"]),
    ("setBreakpoints", &["breakpoints"]),
    ("setExpression", &["value"]),
    ("setVariable", &["value"]),
    ("source", &["content"]),
    ("stackTrace", &["stackFrames"]),
    ("threads", &["threads"]),
    ("variables", &["variables"]),
    ("breakpoint", &["reason", "breakpoint"]),
    ("continued", &["threadId"]),
    ("exited", &["exitCode"]),
    ("output", &["output"]),
    ("process", &["name"]),
    ("progressStart", &["progressId", "title"]),
    ("progressUpdate", &["progressId"]),
    ("progressEnd", &["progressId"]),
    ("stopped", &["reason"]),
    ("thread", &["reason", "threadId"]),
];

/// What is wrong with a message, by the protocol.
fn shape_fault(message: &Value, last_seq: i64) -> Option<&'static str> {
    if message["seq"].as_i64() != Some(last_seq + 1) {
        return Some("`seq` does not count up by one");
    }
    if any_field(message, &|_, value| value.is_null()) {
        return Some("optional fields that are not there must be absent, not null");
    }
    // The second is an extension of VS Code.
    let exceptions = ["request_seq", "__vscodeVariableMenuContext"];
    if any_field(message, &|key, _| key.contains('_') && !exceptions.contains(&key)) {
        return Some("no field of the protocol but request_seq has an underscore");
    }
    let name = match message["type"].as_str() {
        Some("response") => {
            let complete = message["request_seq"].is_i64()
                && message["success"].is_boolean()
                && message["command"].is_string();
            if !complete {
                return Some("a response needs request_seq, success and command");
            }
            if message["success"] == false {
                let error = &message["body"]["error"];
                let explained = error["id"].is_i64() && error["format"].is_string();
                return (!explained).then_some("an error response needs body.error with id and format");
            }
            &message["command"]
        }
        Some("event") if message["event"].is_string() => &message["event"],
        Some("event") => return Some("an event needs a name"),
        _ => return Some("neither response nor event"),
    };
    let required = REQUIRED.iter().find(|(n, _)| name == n).map_or(&[][..], |(_, fields)| *fields);
    let missing = required.iter().any(|field| message["body"].get(field).is_none());
    missing.then_some("the body lacks a field that the protocol requires")
}

fn any_field(value: &Value, is_it: &impl Fn(&str, &Value) -> bool) -> bool {
    match value {
        Value::Array(items) => items.iter().any(|item| is_it("", item) || any_field(item, is_it)),
        Value::Object(map) => map.iter().any(|(key, value)| is_it(key, value) || any_field(value, is_it)),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misshapen_messages_are_noticed() {
        for (message, fault) in [
            (json!({"seq": 2, "type": "event", "event": "x"}), "`seq` does not count"),
            (json!({"seq": 1, "type": "event", "event": "x", "body": {"a": null}}), "absent, not null"),
            (json!({"seq": 1, "type": "event", "event": "x", "body": [{"thread_id": 1}]}), "underscore"),
            (json!({"seq": 1, "type": "event"}), "an event needs a name"),
            (json!({"seq": 1, "type": "event", "event": "stopped", "body": {}}), "lacks a field"),
            (json!({"seq": 1, "type": "response", "request_seq": 1, "success": true}), "a response needs"),
            (
                json!({"seq": 1, "type": "response", "request_seq": 1, "success": false, "command": "x"}),
                "an error response needs",
            ),
            (json!({"seq": 1, "type": "request"}), "neither"),
        ] {
            let found = shape_fault(&message, 0);
            assert!(found.is_some_and(|f| f.contains(fault)), "{message}: {found:?}");
        }
        let good = json!({"seq": 1, "type": "event", "event": "stopped", "body": {"reason": "step"}});
        assert_eq!(shape_fault(&good, 0), None);
    }
}
