//! Language Server Protocol server for TECHNOL: tower-lsp on one side, `technol-analysis` on the other.
//!
//! The way of a message: `transport` takes it and hands it to the main loop's thread in the order it came;
//! the main loop owns documents and projects, changes them, and sends what takes time to a pool of threads with a
//! snapshot; the answer comes back to the main loop, which is the only one to answer. See
//! `docs/design/language-server.md`.

mod capabilities;
mod client;
mod diagnostics;
mod documents;
mod features;
mod file_key;
mod frames;
mod lifecycle;
mod main_loop;
mod outbox;
mod parent;
mod pool;
mod positions;
mod project;
mod requests;
mod settings;
mod transport;
mod view;
mod workspace;

#[cfg(test)]
mod session_tests;

use std::thread;
use std::time::Duration;

use futures::channel::mpsc;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::sync::oneshot;

use main_loop::{Event, MainLoop};

/// How long what was already answered may take to reach the client once the session is over.
const LAST_WORDS: Duration = Duration::from_millis(100);

/// How a session ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// By `exit`, or by the end of input, after `shutdown`.
    Exit,
    /// By `exit` without `shutdown`.
    ExitWithoutShutdown,
    /// The input ended without a word.
    InputClosed,
    /// The process that started the server is gone.
    ParentGone,
}

impl Outcome {
    /// The process' exit code: 0 when the client took its leave as the protocol asks, else 1.
    #[must_use]
    pub const fn exit_code(self) -> u8 {
        match self {
            Outcome::Exit => 0,
            Outcome::ExitWithoutShutdown | Outcome::InputClosed | Outcome::ParentGone => 1,
        }
    }
}

/// Serves one client on standard input and output; the process' exit code comes back, see [`Outcome::exit_code`].
///
/// Returns when the session is over, even while the input is held open: the caller must then end the process, since
/// a thread may still wait for that input.
#[must_use]
pub fn run_stdio() -> u8 {
    let session = || -> std::io::Result<Outcome> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build()?;
        let outcome = runtime.block_on(run(tokio::io::stdin(), tokio::io::stdout()));
        runtime.shutdown_background();
        outcome
    };
    session().map_or_else(
        |error| {
            eprintln!("technol lsp: the system gives no threads to run with: {error}");
            1
        },
        Outcome::exit_code,
    )
}

/// Serves one client on `input` and `output`, on a tokio runtime with time. Returns when the session is over.
///
/// # Errors
/// When the system gives no threads.
pub async fn run<R, W>(input: R, output: W) -> std::io::Result<Outcome>
where
    R: AsyncRead + Unpin,
    W: AsyncWrite + Unpin,
{
    let (events, inbox) = crossbeam_channel::unbounded();
    let (outgoing, outgoing_queue) = mpsc::unbounded();
    let (over, mut is_over) = oneshot::channel();
    let main_loop = MainLoop::new(events.clone(), inbox, outgoing)?;
    thread::Builder::new().name("main loop".into()).spawn(move || {
        // A session nobody waits for any more ends all the same.
        let _ = over.send(main_loop.run());
    })?;
    let mut transport =
        std::pin::pin!(transport::serve::<_, _, Event>(input, output, events, outgoing_queue));
    tokio::select! {
        outcome = &mut is_over => {
            let _ = tokio::time::timeout(LAST_WORDS, transport).await;
            Ok(outcome.unwrap_or(Outcome::InputClosed))
        }
        () = &mut transport => Ok(is_over.await.unwrap_or(Outcome::InputClosed)),
    }
}
