//! A target that waits for debuggers: the PLC runs whether one is there or not.

use std::fmt;
use std::io;
use std::net::TcpListener;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::address::Address;
use crate::connect::ConnectError;
use crate::core::TargetCore;
use crate::link::Link;
use crate::serial::SerialPlace;
use crate::serve::{ServeEnd, serve};
use crate::tcp::TcpLink;
use crate::token::{Token, Visitors};

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
    /// Computers elsewhere would get in without a token.
    #[error(
        "{address} can be reached from other computers, and whoever reaches it can move the machine; give a token (`--token-file FILE`, or TECHNOL_TOKEN), or listen at tcp:127.0.0.1:PORT"
    )]
    TokenNeeded {
        /// As asked for.
        address: Address,
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
    /// Something to know about the way the target listens.
    Warning(String),
    /// Somebody from there did not know the token.
    Refused(String),
    /// A debugger connected, from there. (A serial line cannot tell.)
    Connected(String),
    /// The debugger is gone, or the serial device was pulled out, because of that.
    Gone(String),
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Notice::Listening(address) => write!(f, "listening at {address}"),
            Notice::Warning(text) => write!(f, "warning: {text}"),
            Notice::Refused(why) => write!(f, "refused: {why}"),
            Notice::Connected(from) => write!(f, "debugger connected from {from}"),
            Notice::Gone(why) => write!(f, "link closed: {why}"),
        }
    }
}

/// Waits for debuggers at a TCP port, one at a time, until `shutdown` is set. A second one waits until the first is
/// gone. The target keeps its program and state from one to the next. With a token, only who knows it gets in.
/// `record` may put something around each link.
///
/// # Errors
/// The port cannot be had, or can be reached from elsewhere and there is no token.
pub fn listen_tcp(
    host: &str,
    port: u16,
    token: Option<&Token>,
    record: &mut dyn FnMut(Box<dyn Link>) -> Box<dyn Link>,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> Result<(), ListenError> {
    let address = Address::Tcp { host: host.to_owned(), port };
    let refused = |source| ListenError::Bind { address: address.clone(), source };
    let listener = TcpListener::bind((host, port)).map_err(refused)?;
    let here = listener.local_addr().map_err(refused)?;
    if !here.ip().is_loopback() {
        if token.is_none() {
            return Err(ListenError::TokenNeeded { address });
        }
        notice(Notice::Warning(
            "other computers can reach this target; whoever knows the token can load programs and move the machine, \
             and what goes over the network can be read by others on it"
                .to_owned(),
        ));
    }
    serve_listener(&listener, token, record, core, shutdown, notice).map_err(refused)
}

/// As [`listen_tcp`], with a listener that is bound already, wherever that is.
pub fn serve_listener(
    listener: &TcpListener,
    token: Option<&Token>,
    record: &mut dyn FnMut(Box<dyn Link>) -> Box<dyn Link>,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let here = listener.local_addr()?;
    notice(Notice::Listening(Address::Tcp { host: here.ip().to_string(), port: here.port() }));
    let mut visitors = Visitors::default();
    loop {
        let accept = || {
            if let Ok((stream, from)) = listener.accept() {
                let link = TcpLink::new(stream);
                match (link, token) {
                    // A connection that fails at once is as good as none.
                    (Err(_), _) => {}
                    (Ok(link), None) => return Some(Ok((link, from.to_string()))),
                    (Ok(link), Some(token)) => visitors.ask(link, from.to_string(), token),
                }
            }
            visitors.admitted()
        };
        match run_until(core, shutdown, LOOK, accept) {
            None => return Ok(()),
            Some(Err(refused)) => notice(Notice::Refused(refused)),
            Some(Ok((link, from))) => {
                notice(Notice::Connected(from));
                if !serve_one(record(Box::new(link)), core, shutdown, notice) {
                    return Ok(());
                }
            }
        }
    }
}

/// Waits for debuggers at a serial line until `shutdown` is set. A device that is pulled out is waited for, and found
/// again under another name if its adapter has a number of its own.
///
/// # Errors
/// The device cannot be opened at first.
pub fn serve_serial(
    mut place: SerialPlace,
    record: &mut dyn FnMut(Box<dyn Link>) -> Box<dyn Link>,
    core: &mut TargetCore,
    shutdown: &AtomicBool,
    notice: &mut dyn FnMut(Notice),
) -> Result<(), ListenError> {
    let mut link = place.open()?;
    loop {
        notice(Notice::Listening(place.address()));
        if !serve_one(record(Box::new(link)), core, shutdown, notice) {
            return Ok(());
        }
        match run_until(core, shutdown, LOOK_FOR_DEVICE, || place.open().ok()) {
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
