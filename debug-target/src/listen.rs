//! A target that waits for debuggers: the PLC runs whether one is there or not.

use std::fmt;
use std::io;
use std::net::TcpListener;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::address::Address;
use crate::connect::{ConnectError, open_serial};
use crate::core::TargetCore;
use crate::link::Link;
use crate::serve::{ServeEnd, serve};
use crate::tcp::TcpLink;

/// How often a waiting target looks for a debugger, and for a serial device that was pulled out.
const LOOK: Duration = Duration::from_millis(10);
const LOOK_FOR_DEVICE: Duration = Duration::from_millis(500);

/// Why a target cannot wait for debuggers.
#[derive(Debug, thiserror::Error)]
pub enum ListenError {
    /// The port cannot be had.
    #[error("cannot listen at {address}: {source}; choose another port, or end the program that uses it")]
    Bind {
        /// As asked for.
        address: Address,
        /// What the system says.
        source: io::Error,
    },
    /// The serial device cannot be had.
    #[error(transparent)]
    Serial(#[from] ConnectError),
}

/// What a waiting target has to tell its user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Notice {
    /// Ready; the port is the one that was given out when 0 was asked for.
    Listening(Address),
    /// A debugger connected, from there. (A serial line cannot tell.)
    Connected(String),
    /// The debugger is gone, or the serial device was pulled out, because of that.
    Gone(String),
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Notice::Listening(address) => write!(f, "listening at {address}"),
            Notice::Connected(from) => write!(f, "debugger connected from {from}"),
            Notice::Gone(why) => write!(f, "link closed: {why}"),
        }
    }
}

/// Waits for debuggers at a TCP port, one at a time, until `shutdown` is set. A second one waits until the first is
/// gone. The target keeps its program and state from one to the next.
pub fn listen_tcp(
    host: &str,
    port: u16,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> Result<(), ListenError> {
    let refused =
        |source| ListenError::Bind { address: Address::Tcp { host: host.to_owned(), port }, source };
    let listener = TcpListener::bind((host, port)).map_err(refused)?;
    serve_listener(&listener, core, shutdown, notice).map_err(refused)
}

/// As [`listen_tcp`], with a listener that is bound already.
pub fn serve_listener(
    listener: &TcpListener,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let here = listener.local_addr()?;
    notice(Notice::Listening(Address::Tcp { host: here.ip().to_string(), port: here.port() }));
    loop {
        let accept = || {
            let (stream, from) = listener.accept().ok()?;
            // A connection that fails at once is as good as none.
            Some((TcpLink::new(stream).ok()?, from))
        };
        let Some((link, from)) = run_until(core, shutdown, LOOK, accept) else { return Ok(()) };
        notice(Notice::Connected(from.to_string()));
        if !serve_one(Box::new(link), core, shutdown, notice) {
            return Ok(());
        }
    }
}

/// Waits for debuggers at a serial line until `shutdown` is set. A device that is pulled out is waited for.
///
/// # Errors
/// The device cannot be opened at first.
pub fn serve_serial(
    device: &str,
    baud: u32,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> Result<(), ListenError> {
    let mut link = open_serial(device, baud)?;
    loop {
        notice(Notice::Listening(Address::Serial { device: device.to_owned(), baud }));
        if !serve_one(Box::new(link), core, shutdown, notice) {
            return Ok(());
        }
        match run_until(core, shutdown, LOOK_FOR_DEVICE, || open_serial(device, baud).ok()) {
            Some(again) => link = again,
            None => return Ok(()),
        }
    }
}

/// Serves a link to its end; false when there is to be no other.
fn serve_one(
    link: Box<dyn Link>,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> bool {
    match serve(link, core, shutdown) {
        ServeEnd::LinkGone(error) => {
            notice(Notice::Gone(error.to_string()));
            true
        }
        ServeEnd::Shutdown => false,
    }
}

/// Lets the PLC run until `look`, asked every so often, finds something; `None` when `shutdown` is set.
fn run_until<T>(
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    every: Duration,
    mut look: impl FnMut() -> Option<T>,
) -> Option<T> {
    let mut next_look = Instant::now();
    while !shutdown.load(Ordering::Relaxed) {
        let now = Instant::now();
        if now >= next_look {
            next_look = now + every;
            if let Some(found) = look() {
                return Some(found);
            }
        }
        let due = core.advance(now, false).map_or(next_look, |due| due.min(next_look));
        thread::sleep(due.saturating_duration_since(Instant::now()).min(LOOK));
    }
    None
}
