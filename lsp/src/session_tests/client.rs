//! The client's side of a session.

use std::thread::JoinHandle;
use std::time::Duration;

use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt, DuplexStream, duplex};
use tokio::runtime::{Builder, Runtime};

use crate::Outcome;

/// Longer than anything here takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

pub(super) struct Client {
    runtime: Runtime,
    to_server: Option<DuplexStream>,
    from_server: DuplexStream,
    buffer: Vec<u8>,
    /// Notifications and requests that came while something else was waited for.
    pub(super) unasked: Vec<Value>,
    next_id: i64,
    server: JoinHandle<Outcome>,
}

impl Client {
    /// A session in which nothing was said yet.
    pub(super) fn connect() -> Client {
        let (to_server, input) = duplex(1 << 16);
        let (output, from_server) = duplex(1 << 16);
        let server = std::thread::spawn(move || {
            let runtime = Builder::new_current_thread().enable_time().build().unwrap();
            runtime.block_on(crate::run(input, output)).unwrap()
        });
        let runtime = Builder::new_current_thread().enable_time().build().unwrap();
        let (buffer, unasked) = (Vec::new(), Vec::new());
        Client { runtime, to_server: Some(to_server), from_server, buffer, unasked, next_id: 0, server }
    }

    /// A session that is under way, with these capabilities and options.
    pub(super) fn start(root: Option<&str>, capabilities: &Value, options: &Value) -> Client {
        let mut client = Client::connect();
        let folders = root.map(|uri| json!([{ "uri": uri, "name": "root" }]));
        let answer = client.request(
            "initialize",
            &json!({
                "processId": null, "capabilities": capabilities, "initializationOptions": options,
                "rootUri": root, "workspaceFolders": folders,
            }),
        );
        assert_eq!(answer["serverInfo"]["name"], "technol");
        client.notify("initialized", &json!({}));
        client
    }

    /// Sends bytes as they are.
    pub(super) fn send_raw(&mut self, bytes: &[u8]) {
        let to_server = self.to_server.as_mut().unwrap();
        self.runtime.block_on(to_server.write_all(bytes)).unwrap();
    }

    pub(super) fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub(super) fn notify(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request; its id comes back.
    pub(super) fn ask(&mut self, method: &str, params: &Value) -> i64 {
        self.next_id += 1;
        self.send(&json!({ "jsonrpc": "2.0", "id": self.next_id, "method": method, "params": params }));
        self.next_id
    }

    /// Sends a request and waits for its result.
    pub(super) fn request(&mut self, method: &str, params: &Value) -> Value {
        let id = self.ask(method, params);
        let answer = self.answer(&json!(id));
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// Waits for the answer to a request. Answers may come in any order.
    pub(super) fn answer(&mut self, id: &Value) -> Value {
        self.wait_until(|it| it.get("method").is_none() && it["id"] == *id)
    }

    /// Waits for a message the server sends unasked.
    pub(super) fn wait_for(&mut self, method: &str) -> Value {
        self.wait_until(|it| it["method"] == method)
    }

    pub(super) fn wait_until(&mut self, which: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.unasked.iter().position(&which) {
            return self.unasked.remove(at);
        }
        loop {
            let message = self.receive().expect("the server ended the session");
            if which(&message) {
                return message;
            }
            self.unasked.push(message);
        }
    }

    /// The codes that were published for a version of a document, with their ranges as `line:from-to`.
    pub(super) fn diagnostics(&mut self, uri: &str, version: Option<i32>) -> Vec<String> {
        let message = self.wait_until(|it| {
            let params = &it["params"];
            it["method"] == "textDocument/publishDiagnostics"
                && params["uri"] == uri
                && params["version"] == json!(version)
        });
        let line = |it: &Value| {
            let (start, end) = (&it["range"]["start"], &it["range"]["end"]);
            format!(
                "{} {}:{}-{}",
                it["code"].as_str().unwrap(),
                start["line"],
                start["character"],
                end["character"]
            )
        };
        message["params"]["diagnostics"].as_array().unwrap().iter().map(line).collect()
    }

    pub(super) fn open(&mut self, uri: &str, version: i32, text: &str) {
        let document = json!({ "uri": uri, "languageId": "technol", "version": version, "text": text });
        self.notify("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    pub(super) fn close(&mut self, uri: &str) {
        self.notify("textDocument/didClose", &json!({ "textDocument": { "uri": uri } }));
    }

    /// Replaces the range by `text`: (line, character, line, character).
    pub(super) fn edit(&mut self, uri: &str, version: i32, range: (u32, u32, u32, u32), text: &str) {
        let range = json!({ "start": { "line": range.0, "character": range.1 }, "end": { "line": range.2, "character": range.3 } });
        let changes = json!([{ "range": range, "text": text }]);
        self.notify(
            "textDocument/didChange",
            &json!({ "textDocument": { "uri": uri, "version": version }, "contentChanges": changes }),
        );
    }

    /// The next message; `None` when the server has closed its side.
    pub(super) fn receive(&mut self) -> Option<Value> {
        let Client { runtime, from_server, buffer, .. } = self;
        runtime.block_on(async {
            loop {
                if let Some(message) = first_message(buffer) {
                    return Some(message);
                }
                let read = tokio::time::timeout(PATIENCE, from_server.read_buf(buffer)).await;
                if read.expect("the server says nothing").unwrap() == 0 {
                    return None;
                }
            }
        })
    }

    /// Closes the server's input.
    pub(super) fn hang_up(&mut self) {
        self.to_server = None;
    }

    /// Waits for the end of the session.
    pub(super) fn outcome(mut self) -> Outcome {
        while self.receive().is_some() {}
        self.server.join().unwrap()
    }
}

fn first_message(buffer: &mut Vec<u8>) -> Option<Value> {
    let text = String::from_utf8_lossy(buffer);
    let (header, _) = text.split_once("\r\n\r\n")?;
    let length: usize = header.strip_prefix("Content-Length: ").expect("a strict header").parse().unwrap();
    let start = header.len() + 4;
    if buffer.len() < start + length {
        return None;
    }
    let message = serde_json::from_slice(&buffer[start..start + length]).unwrap();
    buffer.drain(..start + length);
    Some(message)
}
