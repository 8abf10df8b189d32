//! The language server as an editor meets it: the real program as a child process, on the lathe of `examples/`.

#[path = "common/binary.rs"]
mod binary;

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use binary::{root, technol};

/// Longer than anything here takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A running server.
struct Server {
    child: Child,
    /// `None` once it was closed.
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// Messages that came while another was waited for.
    put_by: Vec<Value>,
    next_id: i64,
}

impl Server {
    fn spawn() -> Server {
        let mut child = Command::new(technol())
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let input = child.stdin.take();
        let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            while let Some(message) = read_message(&mut output) {
                if sender.send(message).is_err() {
                    break;
                }
            }
        });
        Server { child, input, messages, put_by: Vec::new(), next_id: 0 }
    }

    /// A session on the lathe.
    fn on_the_lathe(process_id: Option<u32>) -> Server {
        let mut server = Server::spawn();
        let folder = json!([{ "uri": uri(""), "name": "lathe" }]);
        let options = json!({ "language": "en" });
        let params = json!({
            "processId": process_id, "rootUri": null, "capabilities": {},
            "workspaceFolders": folder, "initializationOptions": options,
        });
        let result = server.request("initialize", &params);
        assert_eq!(result["serverInfo"]["name"], "technol");
        server.notify("initialized", &json!({}));
        server
    }

    fn write(&mut self, messages: &[Value]) {
        let mut bytes = Vec::new();
        for message in messages {
            let body = message.to_string();
            bytes.extend(format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes());
        }
        self.write_raw(&bytes);
    }

    fn write_raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("the input is open");
        input.write_all(bytes).expect("the server reads");
        input.flush().expect("the server reads");
    }

    fn notify(&mut self, method: &str, params: &Value) {
        self.write(&[json!({ "jsonrpc": "2.0", "method": method, "params": params })]);
    }

    fn request(&mut self, method: &str, params: &Value) -> Value {
        self.next_id += 1;
        let id = self.next_id;
        self.write(&[json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params })]);
        let answer = self.wait_for(|it| it.get("method").is_none() && it["id"] == id);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    fn wait_for(&mut self, which: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.put_by.iter().position(&which) {
            return self.put_by.remove(at);
        }
        loop {
            let message = self.messages.recv_timeout(PATIENCE).expect("the server says something");
            if which(&message) {
                return message;
            }
            self.put_by.push(message);
        }
    }

    /// The diagnostics' codes for a version of a file.
    fn diagnostics(&mut self, uri: &str, version: i32) -> Vec<String> {
        let message = self.wait_for(|it| {
            let params = &it["params"];
            it["method"] == "textDocument/publishDiagnostics"
                && params["uri"] == uri
                && params["version"] == version
        });
        let found = message["params"]["diagnostics"].as_array().expect("a list");
        found.iter().map(|it| it["code"].as_str().expect("a code").to_owned()).collect()
    }

    fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "technol", "version": 1, "text": text });
        self.notify("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    /// Waits for the end of the process: its exit code.
    fn exit_code(&mut self) -> Option<i32> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if let Some(status) = self.child.try_wait().expect("the child can be waited for") {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        panic!("the server did not end");
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // A failed test leaves no process behind; one that has ended already is no error.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn read_message(output: &mut impl BufRead) -> Option<Value> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim_end() {
            "" => break,
            line => length = line.strip_prefix("Content-Length: ").map(str::to_owned).or(length),
        }
    }
    let mut body = vec![0; length?.parse().ok()?];
    output.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

/// The address of a file of the lathe.
fn uri(name: &str) -> String {
    let folder = root().join("examples").join("lathe").to_string_lossy().replace('\\', "/");
    format!("file://{}{folder}/{name}", if folder.starts_with('/') { "" } else { "/" })
        .trim_end_matches('/')
        .to_owned()
}

fn text(name: &str) -> String {
    std::fs::read_to_string(root().join("examples").join("lathe").join(name)).expect("the example is there")
}

/// Line and column of the first `word` that follows `before`.
fn place(text: &str, before: &str, word: &str) -> (u64, u64) {
    let start = text.find(before).unwrap_or_else(|| panic!("{before} is in the text"));
    let at = start + text[start..].find(word).unwrap_or_else(|| panic!("{word} is in the text"));
    let line = text[..at].matches('\n').count();
    let column = text[..at].rsplit('\n').next().map_or(0, |line| line.encode_utf16().count());
    (line as u64, column as u64)
}

fn at(uri: &str, (line, character): (u64, u64)) -> Value {
    json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } })
}

#[test]
fn a_session_on_the_lathe() {
    let mut server = Server::on_the_lathe(Some(std::process::id()));
    let (spindle, source) = (uri("spindle.plc"), text("spindle.plc"));
    server.open(&spindle, &source);
    assert_eq!(server.diagnostics(&spindle, 1), Vec::<String>::new(), "the example is clean");

    // A mistake typed and taken back.
    let word = place(&source, "LDR", "SP_REQ_STOP");
    let range = |length: u64| json!({ "start": { "line": word.0, "character": word.1 }, "end": { "line": word.0, "character": word.1 + length } });
    for (version, old, new, expected) in [(2, 11, "NOBODY", &["T0301"][..]), (3, 6, "SP_REQ_STOP", &[])] {
        server.notify(
            "textDocument/didChange",
            &json!({
                "textDocument": { "uri": spindle, "version": version },
                "contentChanges": [{ "range": range(old), "text": new }],
            }),
        );
        assert_eq!(server.diagnostics(&spindle, version), expected);
    }

    // Help in both languages.
    let instruction = at(&spindle, place(&source, "TEX1", "TEX1"));
    let english = server.request("textDocument/hover", &instruction);
    server.notify(
        "workspace/didChangeConfiguration",
        &json!({ "settings": { "technol": { "language": "cs" } } }),
    );
    let czech = server.request("textDocument/hover", &instruction);
    let value = |hover: &Value| hover["contents"]["value"].as_str().expect("markdown").to_owned();
    assert!(value(&english).contains("TEX1") && value(&czech).contains("TEX1"));
    assert!(
        value(&czech).contains(['ě', 'š', 'č', 'ř', 'ž', 'ů']) && !value(&english).contains(['ě', 'ř', 'ů'])
    );

    // A name of another file.
    let found = server.request("textDocument/definition", &at(&spindle, word));
    let target = found[0]["uri"].as_str().expect("a place").to_owned();
    assert!(target.starts_with(&uri("")) && target != spindle, "{target}");
    let declared = text(target.strip_prefix(&uri("")).expect("in the project").trim_start_matches('/'));
    let line = found[0]["range"]["start"]["line"].as_u64().expect("a line") as usize;
    assert!(declared.lines().nth(line).is_some_and(|it| it.contains("SP_REQ_STOP")));

    // And everywhere it is used.
    let mut asked = at(&spindle, word);
    asked["context"] = json!({ "includeDeclaration": true });
    let uses = server.request("textDocument/references", &asked);
    let uses = uses.as_array().expect("a list");
    assert!(uses.contains(&found[0]) && uses.iter().any(|it| it["uri"] == spindle));

    assert_eq!(server.request("shutdown", &Value::Null), Value::Null);
    server.notify("exit", &Value::Null);
    assert_eq!(server.exit_code(), Some(0), "standard input is still open");
}

#[test]
fn a_request_can_be_cancelled_while_it_is_worked_on() {
    let mut server = Server::on_the_lathe(None);
    let long = "untitled:long";
    let cells: Vec<String> = (0..20_000).map(|n| format!("CELL_{n}: DS 2")).collect();
    let text = format!("DATA\n{}\nDATA_END\nMODULE_MAIN\nMODULE_MAIN_END\n", cells.join("\n"));
    let open =
        json!({ "textDocument": { "uri": long, "languageId": "technol", "version": 1, "text": text } });
    server.write(&[
        json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": open }),
        json!({ "jsonrpc": "2.0", "id": "slow", "method": "workspace/symbol", "params": { "query": "CELL" } }),
        json!({ "jsonrpc": "2.0", "method": "$/cancelRequest", "params": { "id": "slow" } }),
    ]);
    let answer = server.wait_for(|it| it["id"] == "slow");
    assert_eq!(answer["error"]["code"], -32800, "{answer}");
    let outline = server.request("textDocument/documentSymbol", &json!({ "textDocument": { "uri": long } }));
    assert!(outline.as_array().is_some_and(|it| it.len() > 20_000), "the server still answers");
    let again = server.put_by.iter().any(|it| it["id"] == "slow");
    assert!(!again, "one answer is enough");
}

#[test]
fn unreadable_messages_do_not_end_the_session() {
    let mut server = Server::on_the_lathe(None);
    server.write_raw(b"Content-Length: 3\r\n\r\n{]}");
    let answer = server.wait_for(|it| it["id"].is_null() && it.get("error").is_some());
    assert_eq!(answer["error"]["code"], -32700);
    assert!(
        server
            .request("workspace/symbol", &json!({ "query": "SP_CONTROL" }))
            .as_array()
            .is_some_and(|it| !it.is_empty())
    );
}

#[test]
fn exit_without_shutdown_and_the_end_of_input_end_the_process_with_1() {
    let mut server = Server::on_the_lathe(None);
    server.notify("exit", &Value::Null);
    assert_eq!(server.exit_code(), Some(1));

    let mut server = Server::on_the_lathe(None);
    server.input = None;
    assert_eq!(server.exit_code(), Some(1));
}

#[cfg(unix)]
#[test]
fn the_server_ends_with_its_parent_although_standard_input_is_held_open() {
    let mut parent = Command::new("sleep").arg("600").spawn().expect("sleep");
    let mut server = Server::on_the_lathe(Some(parent.id()));
    assert!(server.child.try_wait().expect("a child").is_none());
    parent.kill().expect("sleep can be ended");
    parent.wait().expect("sleep has ended");
    assert_eq!(server.exit_code(), Some(1));
}
