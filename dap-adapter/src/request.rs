//! A request of the client, read loosely.

use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::errors::RequestError;

/// A request; arguments may be missing altogether.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Request {
    pub(crate) seq: i64,
    pub(crate) command: String,
    pub(crate) arguments: Value,
}

impl Request {
    /// Takes a message apart; `Err` says what is missing.
    pub(crate) fn from_message(message: &Value) -> Result<Request, String> {
        let Some(command) = message.get("command").and_then(Value::as_str) else {
            return Err("it has no `command`".into());
        };
        let Some(seq) = message.get("seq").and_then(Value::as_i64) else {
            return Err(format!("`{command}` has no `seq`"));
        };
        match message.get("type").and_then(Value::as_str) {
            Some("request") | None => {}
            Some(other) => return Err(format!("`{command}` is a {other}, not a request")),
        }
        let arguments = message.get("arguments").cloned().unwrap_or_default();
        Ok(Request { seq, command: command.to_owned(), arguments })
    }

    /// What can be recognised of a request in text that is not JSON, so that it is answered all the same.
    pub(crate) fn from_broken(text: &str) -> Option<Request> {
        let after = |key: &str| Some(text.split_once(key)?.1.trim_start().strip_prefix(':')?.trim_start());
        let digits: String = after("\"seq\"")?.chars().take_while(char::is_ascii_digit).collect();
        let command = after("\"command\"")?.strip_prefix('"')?.split_once('"')?.0;
        Some(Request { seq: digits.parse().ok()?, command: command.to_owned(), arguments: Value::Null })
    }

    /// The arguments as a type; missing ones are an empty object.
    pub(crate) fn parse<T: DeserializeOwned>(&self) -> Result<T, RequestError> {
        let arguments = if self.arguments.is_null() { json!({}) } else { self.arguments.clone() };
        serde_json::from_value(arguments).map_err(|error| RequestError::Arguments {
            command: self.command.clone(),
            reason: error.to_string(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_may_be_missing() {
        let request =
            Request::from_message(&json!({"seq": 3, "type": "request", "command": "threads"})).unwrap();
        assert_eq!(request, Request { seq: 3, command: "threads".into(), arguments: Value::Null });
        assert!(request.parse::<dap::requests::TerminateArguments>().is_ok());
    }

    #[test]
    fn what_is_no_request_says_why() {
        for (message, reason) in [
            (json!({"seq": 1}), "it has no `command`"),
            (json!({"command": "x"}), "`x` has no `seq`"),
            (json!([1]), "it has no `command`"),
            (json!({"seq": 1, "command": "x", "type": "response"}), "`x` is a response, not a request"),
        ] {
            assert_eq!(Request::from_message(&message), Err(reason.to_owned()));
        }
    }

    #[test]
    fn a_broken_request_is_still_recognised() {
        let broken = r#"{"seq": 12, "type":"request","command" : "evaluate", "arguments": {"#;
        let request = Request::from_broken(broken).unwrap();
        assert_eq!((request.seq, request.command.as_str()), (12, "evaluate"));
        assert_eq!(Request::from_broken("{\"seq\": x"), None);
    }
}
