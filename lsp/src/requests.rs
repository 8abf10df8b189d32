//! Requests that wait for their answer. Each is answered exactly once, whoever comes first: the work, its
//! cancellation, or the end of the session.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::Value;
use tower_lsp::jsonrpc::{Error, ErrorCode, Id, Result};

use crate::transport::Reply;

/// The requests in work.
#[derive(Debug, Default)]
pub(crate) struct Requests {
    open: HashMap<Id, Open>,
    serial: u64,
}

#[derive(Debug)]
struct Open {
    reply: Reply,
    ticket: Ticket,
}

/// Goes with the work of a request.
#[derive(Clone, Debug)]
pub(crate) struct Ticket {
    id: Id,
    /// Tells a request from a later one with the same id.
    serial: u64,
    cancelled: Arc<AtomicBool>,
}

impl Ticket {
    /// Nobody waits for the answer any more.
    pub(crate) fn cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

impl Requests {
    /// Takes a request in. One whose id is still in use is refused at once, and `None` comes back.
    pub(crate) fn take(&mut self, reply: Reply) -> Option<Ticket> {
        if self.open.contains_key(&reply.id) {
            let message = format!("request id {} is still in use", reply.id);
            reply.send(Err(error(ErrorCode::InvalidRequest, message)));
            return None;
        }
        self.serial += 1;
        let ticket = Ticket { id: reply.id.clone(), serial: self.serial, cancelled: Arc::default() };
        self.open.insert(ticket.id.clone(), Open { reply, ticket: ticket.clone() });
        Some(ticket)
    }

    /// Answers a request, unless it was answered before.
    pub(crate) fn answer(&mut self, ticket: &Ticket, body: Result<Value>) {
        if self.open.get(&ticket.id).is_some_and(|it| it.ticket.serial == ticket.serial)
            && let Some(open) = self.open.remove(&ticket.id)
        {
            open.reply.send(body);
        }
    }

    /// The client no longer wants the answer: it is told so now, and work not yet begun is not begun.
    pub(crate) fn cancel(&mut self, id: &Id) {
        if let Some(open) = self.open.remove(id) {
            open.ticket.cancelled.store(true, Ordering::Relaxed);
            open.reply.send(Err(error(ErrorCode::RequestCancelled, "the request was cancelled")));
        }
    }

    /// Cancels everything.
    pub(crate) fn cancel_all(&mut self) {
        for id in self.open.keys().cloned().collect::<Vec<_>>() {
            self.cancel(&id);
        }
    }
}

/// An error for the client.
pub(crate) fn error(code: ErrorCode, message: impl Into<String>) -> Error {
    Error { code, message: message.into().into(), data: None }
}
