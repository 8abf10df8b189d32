//! What the server says unasked.

use std::collections::HashMap;

use futures::channel::mpsc;
use tower_lsp::jsonrpc::{Id, Request, Response};
use tower_lsp::ls_types::notification::{LogMessage, Notification};
use tower_lsp::ls_types::request::Request as Method;
use tower_lsp::ls_types::{LogMessageParams, MessageType};

/// The client's mail box. Nothing here waits for the client.
#[derive(Debug)]
pub(crate) struct Outbox {
    sender: mpsc::UnboundedSender<Request>,
    next: i64,
    asked: HashMap<Id, &'static str>,
}

impl Outbox {
    /// An outbox that sends through `sender`.
    pub(crate) fn new(sender: mpsc::UnboundedSender<Request>) -> Outbox {
        Outbox { sender, next: 0, asked: HashMap::new() }
    }

    /// Sends a notification.
    pub(crate) fn notify<N: Notification>(&self, params: &N::Params) {
        self.send(Request::build(N::METHOD), params, None);
    }

    /// Sends a request; its answer is matched by [`Outbox::answered`].
    pub(crate) fn ask<R: Method>(&mut self, params: &R::Params) {
        self.next += 1;
        let id = Id::String(format!("technol-{}", self.next));
        self.asked.insert(id.clone(), R::METHOD);
        self.send(Request::build(R::METHOD), params, Some(id));
    }

    /// The method of ours that `response` answers.
    pub(crate) fn answered(&mut self, response: &Response) -> Option<&'static str> {
        self.asked.remove(response.id())
    }

    /// Writes a line to the client's log.
    pub(crate) fn log(&self, typ: MessageType, message: impl Into<String>) {
        self.notify::<LogMessage>(&LogMessageParams { typ, message: message.into() });
    }

    fn send(
        &self,
        message: tower_lsp::jsonrpc::RequestBuilder,
        params: &impl serde::Serialize,
        id: Option<Id>,
    ) {
        // The protocol's own types always have a JSON form.
        let Ok(params) = serde_json::to_value(params) else { return };
        let message = message.params(params);
        let message = if let Some(id) = id { message.id(id) } else { message };
        let _ = self.sender.unbounded_send(message.finish());
    }
}
