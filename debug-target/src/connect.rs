//! The debugger's way to a target.

use std::io::{self, ErrorKind};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;

use crate::address::Address;
use crate::link::Link;
use crate::serial::SerialLink;
use crate::tcp::TcpLink;

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

/// Opens a link to a target.
///
/// # Errors
/// Whatever keeps it from being opened. That somebody answers is only known after a Hello.
pub fn connect(address: &Address) -> Result<Box<dyn Link>, ConnectError> {
    match address {
        Address::Embedded => Err(ConnectError::Embedded),
        Address::Tcp { host, port } => {
            let stream = connect_tcp(address, host, *port)?;
            let link = TcpLink::new(stream)
                .map_err(|source| ConnectError::NoTarget { address: address.clone(), source })?;
            Ok(Box::new(link))
        }
        Address::Serial { device, baud } => Ok(Box::new(open_serial(device, *baud)?)),
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
pub(crate) fn open_serial(device: &str, baud: u32) -> Result<SerialLink, ConnectError> {
    SerialLink::open(device, baud).map_err(|source| {
        let device = device.to_owned();
        match source.kind() {
            serialport::ErrorKind::NoDevice | serialport::ErrorKind::Io(ErrorKind::NotFound) => {
                // A device that is in use is reported as missing by some systems.
                if std::path::Path::new(&device).exists() {
                    ConnectError::Device { device, source }
                } else {
                    ConnectError::NoDevice { device, available: available_devices() }
                }
            }
            serialport::ErrorKind::Io(ErrorKind::PermissionDenied) => ConnectError::Permission { device },
            _ => ConnectError::Device { device, source },
        }
    })
}

fn available_devices() -> String {
    let ports = serialport::available_ports().unwrap_or_default();
    let names: Vec<_> = ports.into_iter().map(|port| port.port_name).collect();
    if names.is_empty() { "none was found".to_owned() } else { format!("there is {}", names.join(", ")) }
}
