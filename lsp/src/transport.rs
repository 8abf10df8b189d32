//! The way in and out: tower-lsp's stdio server, with a service of our own behind it.
//!
//! The service does nothing but hand each message to the main loop, synchronously and in the order it came;
//! a request's answer comes back through a one-shot channel. Nothing runs on the executor but copying.

use std::convert::Infallible;
use std::pin::Pin;
use std::task::{Context, Poll};

use crossbeam_channel::Sender;
use futures::channel::{mpsc, oneshot};
use futures::future::BoxFuture;
use futures::sink::Sink;
use tokio::io::{AsyncRead, AsyncWrite};
use tower_lsp::jsonrpc::{Id, Request, Response};
use tower_lsp::{Loopback, Server};
use tower_service::Service;

use crate::frames;

/// A message on its way to the main loop.
#[derive(Debug)]
pub(crate) struct Incoming {
    /// Method name.
    pub(crate) method: String,
    /// Parameters as they came.
    pub(crate) params: Option<serde_json::Value>,
    /// Where the answer goes; a notification has none.
    pub(crate) reply: Option<Reply>,
}

/// Takes the one answer of a request.
#[derive(Debug)]
pub(crate) struct Reply {
    /// The request's id.
    pub(crate) id: Id,
    sender: oneshot::Sender<Response>,
}

impl Reply {
    /// Answers. A client that is gone by now is no error.
    pub(crate) fn send(self, body: tower_lsp::jsonrpc::Result<serde_json::Value>) {
        let _ = self.sender.send(Response::from_parts(self.id, body));
    }
}

/// What the transport tells the main loop.
#[derive(Debug)]
pub(crate) enum FromClient {
    /// A request or notification.
    Message(Incoming),
    /// The answer to a request of ours.
    Answer(Response),
}

/// Runs the transport until the input ends or `exit` was read, and everything taken was answered.
pub(crate) async fn serve<R, W, E>(
    input: R,
    output: W,
    intake: Sender<E>,
    outgoing: mpsc::UnboundedReceiver<Request>,
) where
    R: AsyncRead + Unpin,
    W: AsyncWrite,
    E: From<FromClient> + Send + 'static,
{
    let (guarded, checked) = tokio::io::duplex(256 * 1024);
    let socket = Socket { outgoing, answers: Answers { intake: intake.clone() } };
    // No limit of its own: with one, a `$/cancelRequest` would wait behind the requests it is to cancel.
    let server = Server::new(checked, output, socket).concurrency_level(usize::MAX).serve(Intake { intake });
    tokio::select! {
        () = server => {}
        () = async { frames::guard(input, guarded).await; std::future::pending().await } => {}
    }
}

/// Hands messages to the main loop.
struct Intake<E> {
    intake: Sender<E>,
}

impl<E: From<FromClient> + Send + 'static> Service<Request> for Intake<E> {
    type Response = Option<Response>;
    type Error = Infallible;
    type Future = BoxFuture<'static, Result<Option<Response>, Infallible>>;

    fn poll_ready(&mut self, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn call(&mut self, request: Request) -> Self::Future {
        let (method, id, params) = request.into_parts();
        // What the guard could not read is answered like a request, under the id it found or none.
        let id = if method == frames::UNREADABLE { Some(unreadable_id(params.as_ref())) } else { id };
        let (sender, receiver) = oneshot::channel();
        let reply = id.map(|id| Reply { id, sender });
        let message = Incoming { method: method.into_owned(), params, reply };
        // A main loop that has ended takes nothing any more; its receiver is gone and the reply with it.
        let _ = self.intake.send(FromClient::Message(message).into());
        Box::pin(async move { Ok(receiver.await.ok()) })
    }
}

fn unreadable_id(params: Option<&serde_json::Value>) -> Id {
    params
        .and_then(|it| it.get("id"))
        .and_then(|id| serde_json::from_value(id.clone()).ok())
        .unwrap_or(Id::Null)
}

/// The way from us to the client.
struct Socket<E> {
    outgoing: mpsc::UnboundedReceiver<Request>,
    answers: Answers<E>,
}

impl<E: From<FromClient> + Send + 'static> Loopback for Socket<E> {
    type RequestStream = mpsc::UnboundedReceiver<Request>;
    type ResponseSink = Answers<E>;

    fn split(self) -> (Self::RequestStream, Self::ResponseSink) {
        (self.outgoing, self.answers)
    }
}

/// Takes the client's answers.
struct Answers<E> {
    intake: Sender<E>,
}

impl<E: From<FromClient>> Sink<Response> for Answers<E> {
    type Error = Infallible;

    fn poll_ready(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn start_send(self: Pin<&mut Self>, response: Response) -> Result<(), Infallible> {
        let _ = self.intake.send(FromClient::Answer(response).into());
        Ok(())
    }

    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn poll_close(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }
}
