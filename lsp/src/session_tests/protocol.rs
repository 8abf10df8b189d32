//! Order, cancellation, errors and the end of a session.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::client::Client;
use crate::Outcome;

const DOCUMENT: &str = "untitled:Untitled-1";

fn started() -> Client {
    Client::start(None, &json!({}), &json!(null))
}

fn position(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": DOCUMENT }, "position": { "line": line, "character": character } })
}

fn code(answer: &Value) -> i64 {
    answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("an error was expected: {answer}"))
}

#[test]
fn requests_before_initialize_and_after_shutdown_are_refused() {
    let mut client = Client::connect();
    client.notify("initialized", &json!({}));
    let early = client.ask("textDocument/hover", &position(0, 0));
    assert_eq!(code(&client.answer(&json!(early))), -32002);
    let bad = client.ask("initialize", &json!({ "capabilities": 7 }));
    assert_eq!(code(&client.answer(&json!(bad))), -32602);
    client.request("initialize", &json!({ "processId": null, "capabilities": {} }));
    let twice = client.ask("initialize", &json!({ "processId": null, "capabilities": {} }));
    assert_eq!(code(&client.answer(&json!(twice))), -32600);
    assert_eq!(client.request("shutdown", &Value::Null), Value::Null);
    let late = client.ask("textDocument/hover", &position(0, 0));
    assert_eq!(code(&client.answer(&json!(late))), -32600);
    client.notify("exit", &Value::Null);
    assert_eq!(client.outcome(), Outcome::Exit);
}

#[test]
fn exit_ends_the_session_while_the_input_is_held_open() {
    let mut client = started();
    client.request("shutdown", &Value::Null);
    client.notify("exit", &Value::Null);
    assert_eq!(client.outcome(), Outcome::Exit); // the client's end of the input is dropped only in here, after the end
}

#[test]
fn shutdown_and_exit_sent_together_are_both_honoured() {
    let mut client = started();
    let id = client.ask("shutdown", &Value::Null);
    client.notify("exit", &Value::Null);
    client.hang_up();
    assert_eq!(client.answer(&json!(id))["result"], Value::Null);
    assert_eq!(client.outcome(), Outcome::Exit);
}

#[test]
fn exit_without_shutdown_and_the_end_of_input_are_told_apart() {
    let mut client = started();
    client.notify("exit", &Value::Null);
    assert_eq!(client.outcome(), Outcome::ExitWithoutShutdown);
    let mut client = started();
    client.hang_up();
    assert_eq!(client.outcome(), Outcome::InputClosed);
    let mut client = Client::connect();
    client.hang_up();
    assert_eq!(client.outcome(), Outcome::InputClosed);
}

#[test]
fn exit_does_not_wait_for_work_and_what_was_asked_is_answered() {
    let mut client = started();
    client.open(DOCUMENT, 1, "");
    let id = client.ask("test/keepChecking", &json!(30_000));
    let start = Instant::now();
    client.notify("exit", &Value::Null);
    assert_eq!(code(&client.answer(&json!(id))), -32800);
    client.outcome();
    assert!(start.elapsed() < Duration::from_secs(15));
}

#[cfg(unix)]
#[test]
fn a_parent_that_is_gone_ends_the_session() {
    let mut parent = std::process::Command::new("sleep").arg("0").spawn().unwrap();
    parent.wait().unwrap();
    let mut client = Client::connect();
    client.request("initialize", &json!({ "processId": parent.id(), "capabilities": {} }));
    assert_eq!(client.outcome(), Outcome::ParentGone);
}

#[test]
fn unknown_requests_are_refused_and_unknown_notifications_ignored() {
    let mut client = started();
    client.notify("$/whatever", &json!([1]));
    client.notify("textDocument/unheardOf", &json!({}));
    let id = client.ask("textDocument/unheardOf", &json!({}));
    assert_eq!(code(&client.answer(&json!(id))), -32601);
    let id = client.ask("textDocument/hover", &json!({ "position": "here" }));
    assert_eq!(code(&client.answer(&json!(id))), -32602);
}

#[test]
fn what_cannot_be_read_is_answered_and_the_session_goes_on() {
    let mut client = started();
    client.send_raw(b"Content-Length: 9\r\n\r\n{\"jsonrpc");
    assert_eq!(code(&client.answer(&Value::Null)), -32700);
    client.send(&json!({ "jsonrpc": "2.0", "id": 5 }));
    assert_eq!(code(&client.answer(&json!(5))), -32600);
    client.send_raw(b"Content-Length: nonsense\r\n\r\n");
    assert_eq!(code(&client.answer(&Value::Null)), -32700);
    assert_eq!(client.request("workspace/symbol", &json!({ "query": "" })), json!([]));
}

#[test]
fn ids_may_come_in_any_order_and_be_words() {
    let mut client = started();
    client.open(DOCUMENT, 1, "");
    for id in [json!(900), json!("word"), json!(-3), json!(0)] {
        client.send(
            &json!({ "jsonrpc": "2.0", "id": id, "method": "workspace/symbol", "params": { "query": "" } }),
        );
        assert_eq!(client.answer(&id)["result"], json!([]), "{id}");
    }
}

#[test]
fn an_id_in_use_is_refused_and_can_be_used_again_afterwards() {
    let mut client = started();
    client.open(DOCUMENT, 1, "");
    client.diagnostics(DOCUMENT, Some(1));
    let ask = |client: &mut Client, time: u64| {
        client.send(&json!({ "jsonrpc": "2.0", "id": 1000, "method": "test/keepChecking", "params": time }));
    };
    ask(&mut client, 700);
    ask(&mut client, 0);
    assert_eq!(code(&client.answer(&json!(1000))), -32600);
    assert_eq!(client.answer(&json!(1000))["result"], "done");
    ask(&mut client, 0);
    assert_eq!(client.answer(&json!(1000))["result"], "done");
}

#[test]
fn a_cancelled_request_is_answered_at_once_and_only_once() {
    let mut client = started();
    client.open(DOCUMENT, 1, "");
    client.diagnostics(DOCUMENT, Some(1));
    // More than the pool has threads: the last ones wait in its queue.
    let ids: Vec<i64> = (0..8).map(|_| client.ask("test/keepChecking", &json!(30_000))).collect();
    let start = Instant::now();
    for id in &ids {
        client.notify("$/cancelRequest", &json!({ "id": id }));
    }
    for id in &ids {
        assert_eq!(code(&client.answer(&json!(id))), -32800);
    }
    assert!(start.elapsed() < Duration::from_secs(15), "{:?}", start.elapsed());
    client.notify("$/cancelRequest", &json!({ "id": ids[0] }));
    client.notify("$/cancelRequest", &json!({ "id": "never used" }));
    client.notify("$/cancelRequest", &json!({}));
    client.edit(DOCUMENT, 2, (0, 0, 0, 0), "; frees the threads\n");
    client.request("test/keepChecking", &json!(0));
    let second = client.unasked.iter().find(|it| it.get("id").is_some());
    assert_eq!(second, None);
}

#[test]
fn a_stumbling_request_is_answered_and_the_server_lives_on() {
    let mut client = started();
    let id = client.ask("test/stumble", &json!("a stone"));
    let answer = client.answer(&json!(id));
    assert_eq!(code(&answer), -32603);
    assert!(answer["error"]["message"].as_str().unwrap().contains("stumbled over \"a stone\""));
    assert_eq!(client.request("workspace/symbol", &json!({ "query": "" })), json!([]));
}

#[test]
fn a_change_cancels_what_was_asked_of_the_old_text() {
    let mut client = started();
    client.open(DOCUMENT, 1, "; one\n");
    client.diagnostics(DOCUMENT, Some(1));
    let start = Instant::now();
    let id = client.ask("test/keepChecking", &json!(30_000));
    client.edit(DOCUMENT, 2, (0, 0, 0, 0), "; more\n");
    assert_eq!(code(&client.answer(&json!(id))), -32801);
    assert!(start.elapsed() < Duration::from_secs(15));
    client.diagnostics(DOCUMENT, Some(2));
}

#[test]
fn settings_that_are_not_known_are_logged() {
    let mut client = Client::start(None, &json!({}), &json!({ "colour": "red" }));
    let message = client.wait_for("window/logMessage");
    assert_eq!(message["params"]["message"], "Setting technol.colour is not known and was ignored.");
    client.notify(
        "workspace/didChangeConfiguration",
        &json!({ "settings": { "technol": { "language": "xx" } } }),
    );
    let message = client.wait_for("window/logMessage");
    assert!(message["params"]["message"].as_str().unwrap().contains("can be \"en\" or \"cs\""));
}

#[test]
fn watchers_are_registered_and_settings_fetched_where_the_client_offers_it() {
    let capabilities = json!({ "workspace": {
        "configuration": true,
        "didChangeWatchedFiles": { "dynamicRegistration": true },
        "didChangeConfiguration": { "dynamicRegistration": true },
    } });
    let mut client = Client::start(None, &capabilities, &json!(null));
    let ask = client.wait_for("client/registerCapability");
    let methods: Vec<_> =
        ask["params"]["registrations"].as_array().unwrap().iter().map(|it| &it["method"]).collect();
    assert_eq!(methods, ["workspace/didChangeWatchedFiles", "workspace/didChangeConfiguration"]);
    client.send(&json!({ "jsonrpc": "2.0", "id": ask["id"], "error": { "code": -32601, "message": "no" } }));
    let log = client.wait_for("window/logMessage");
    assert_eq!(log["params"]["message"], "the editor refused client/registerCapability: no");
    let ask = client.wait_for("workspace/configuration");
    client.send(&json!({ "jsonrpc": "2.0", "id": ask["id"], "result": [{ "language": "dd" }] }));
    let log = client.wait_for("window/logMessage");
    assert!(
        log["params"]["message"]
            .as_str()
            .unwrap()
            .starts_with("Setting technol.language = \"dd\" is ignored")
    );
}

#[test]
fn a_change_of_a_document_that_is_not_open_is_logged_and_survived() {
    let mut client = started();
    client.edit("untitled:nobody", 2, (0, 0, 0, 0), "x");
    let log = client.wait_for("window/logMessage");
    assert_eq!(log["params"]["message"], "untitled:nobody was changed but is not open; the change is lost");
    client.close("untitled:nobody");
    let hover =
        json!({ "textDocument": { "uri": "untitled:nobody" }, "position": { "line": 0, "character": 0 } });
    assert_eq!(client.request("textDocument/hover", &hover), Value::Null);
}
