//! The debugger's way to a target.

use std::io::{self, ErrorKind};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;

use crate::address::Address;
use crate::devices::{Device, devices};
use crate::link::Link;
use crate::serial::{SerialLink, SerialPlace};
use crate::tcp::TcpLink;
use crate::token::Token;

const CONNECT_TIMEOUT: Duration = Duration::from_secs(3);

/// There is no link: where, why, and what to do.
#[derive(Debug, thiserror::Error)]
pub enum ConnectError {
    /// The embedded target is not connected to, it is started.
    #[error(
        "the embedded target runs inside the debugger and has no address to connect to; start it with a project"
    )]
    Embedded,
    /// The name of the computer is not known.
    #[error("cannot find the computer `{host}`: {source}; check the name, or write its number")]
    UnknownHost {
        /// As asked for.
        host: String,
        /// What the system says.
        source: io::Error,
    },
    /// Nobody listens there.
    #[error(
        "no target at {address}: {source}; start it there with `technol target --listen {address}`, or correct the address"
    )]
    NoTarget {
        /// As asked for.
        address: Address,
        /// What the system says.
        source: io::Error,
    },
    /// The target did not let us in.
    #[error("the target at {address} did not let us in: {source}; check the token")]
    Token {
        /// As asked for.
        address: Address,
        /// What happened.
        source: io::Error,
    },
    /// The serial device does not exist.
    #[error("there is no serial device `{device}`; {available}; check that the cable is plugged in")]
    NoDevice {
        /// As asked for.
        device: String,
        /// Devices there are, as a phrase.
        available: String,
    },
    /// The serial device may not be used.
    #[error(
        "no permission to use the serial device `{device}`; add your user to its group (on Linux usually `dialout`) and log in again"
    )]
    Permission {
        /// As asked for.
        device: String,
    },
    /// The serial device is in use, or does not work.
    #[error(
        "cannot use the serial device `{device}`: {source}; check that no other program has it open and that it takes the baud rate"
    )]
    Device {
        /// As asked for.
        device: String,
        /// What the system says.
        source: serialport::Error,
    },
}

/// Opens a link to a target, once.
///
/// # Errors
/// Whatever keeps it from being opened. That somebody answers is only known after a Hello.
pub fn connect(address: &Address) -> Result<Box<dyn Link>, ConnectError> {
    Connector::new(address.clone(), None).connect()
}

/// The debugger's way to one target, again and again: a serial adapter is found again under another name.
#[derive(Clone, Debug)]
pub struct Connector {
    address: Address,
    token: Option<Token>,
    serial: Option<SerialPlace>,
}

impl Connector {
    /// A way to this target; the token is what it lets in with, if it asks.
    #[must_use]
    pub fn new(address: Address, token: Option<Token>) -> Connector {
        let serial = match &address {
            Address::Serial { device, baud, flow } => Some(SerialPlace::new(device, *baud, *flow)),
            Address::Tcp { .. } | Address::Embedded => None,
        };
        Connector { address, token, serial }
    }

    /// Opens a link.
    ///
    /// # Errors
    /// Whatever keeps it from being opened. That somebody answers is only known after a Hello.
    pub fn connect(&mut self) -> Result<Box<dyn Link>, ConnectError> {
        let address = &self.address;
        match (address, &mut self.serial) {
            (Address::Tcp { host, port }, _) => {
                let stream = connect_tcp(address, host, *port)?;
                let failed = |source| ConnectError::NoTarget { address: address.clone(), source };
                let mut link = TcpLink::new(stream).map_err(failed)?;
                if let Some(token) = &self.token {
                    let refused = |source| ConnectError::Token { address: address.clone(), source };
                    token.prove(&mut link).map_err(refused)?;
                }
                Ok(Box::new(link))
            }
            (_, Some(serial)) => Ok(Box::new(serial.open()?)),
            (_, None) => Err(ConnectError::Embedded),
        }
    }
}

fn connect_tcp(address: &Address, host: &str, port: u16) -> Result<TcpStream, ConnectError> {
    let found = (host, port)
        .to_socket_addrs()
        .map_err(|source| ConnectError::UnknownHost { host: host.to_owned(), source })?;
    let mut last = io::Error::new(ErrorKind::NotFound, "the name has no number");
    for socket in found {
        match TcpStream::connect_timeout(&socket, CONNECT_TIMEOUT) {
            Ok(stream) => return Ok(stream),
            Err(error) => last = error,
        }
    }
    Err(ConnectError::NoTarget { address: address.clone(), source: last })
}

/// Opens a serial device, with errors that say what to do.
pub(crate) fn open_serial(device: &str, baud: u32, flow: bool) -> Result<SerialLink, ConnectError> {
    SerialLink::open(device, baud, flow).map_err(|source| {
        let device = device.to_owned();
        match source.kind() {
            serialport::ErrorKind::NoDevice | serialport::ErrorKind::Io(ErrorKind::NotFound) => {
                // A device that is in use is reported as missing by some systems.
                if std::path::Path::new(&device).exists() {
                    ConnectError::Device { device, source }
                } else {
                    ConnectError::NoDevice { device, available: available(&devices()) }
                }
            }
            serialport::ErrorKind::Io(ErrorKind::PermissionDenied) => ConnectError::Permission { device },
            _ => ConnectError::Device { device, source },
        }
    })
}

/// The devices there are, as a phrase.
pub(crate) fn available(devices: &[Device]) -> String {
    let names: Vec<_> = devices.iter().map(|device| device.port.as_str()).collect();
    if names.is_empty() { "none was found".to_owned() } else { format!("there is {}", names.join(", ")) }
}
