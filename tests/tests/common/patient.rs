//! An editor on a cable that fails: it asks again.

use std::time::Duration;

use serde_json::{Value, json};
use technol_dap::client::{Client, ClientError};

/// Asks until the link is there to answer.
pub(crate) fn ask(client: &mut Client, command: &str, arguments: &Value) -> Value {
    for _ in 0..600 {
        match client.request(command, arguments.clone()) {
            Ok(body) => return body,
            Err(ClientError::Refused { message, .. }) if message.contains("link") => {
                std::thread::sleep(Duration::from_millis(50));
            }
            Err(error) => panic!("{command}: {error}"),
        }
    }
    panic!("{command}: the link never came back");
}

/// A step; a link that is lost meanwhile may or may not have let the step happen, but then says where it is.
pub(crate) fn step(client: &mut Client, thread: i64) -> i64 {
    let mark = client.mark();
    match client.request("stepIn", json!({ "threadId": thread })) {
        Ok(_) => {}
        Err(ClientError::Refused { message, .. }) if message.contains("link") => {}
        Err(error) => panic!("{error}"),
    }
    let stopped = client.event(mark, "stopped").expect("a stop");
    stopped["threadId"].as_i64().expect("a thread")
}
