//! Where a target is: `embedded`, `tcp:HOST:PORT`, `serial:DEVICE[@BAUD][,rtscts]`.

use std::fmt;
use std::str::FromStr;

/// Baud rate when none is given.
pub const DEFAULT_BAUD: u32 = 115_200;
/// Baud rates that are taken.
const BAUDS: std::ops::RangeInclusive<u32> = 9_600..=921_600;
/// Behind the baud rate: the line has wires for flow control, and they are used.
const FLOW: &str = ",rtscts";
const LOOPBACK: &str = "127.0.0.1";

/// Where a target is.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Address {
    /// In this process.
    Embedded,
    /// On the network.
    Tcp {
        /// Name or number; a number with colons is written in brackets.
        host: String,
        /// Port.
        port: u16,
    },
    /// At a serial line.
    Serial {
        /// `/dev/ttyUSB0`, `COM3`, or an adapter wherever it is plugged in: `usb:0403:6001:A50285BI`.
        device: String,
        /// Bits per second.
        baud: u32,
        /// RTS/CTS flow control.
        flow: bool,
    },
}

/// The text is no address.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{text}` is not the address of a target: {reason}; write `embedded`, `tcp:HOST:PORT` or `serial:DEVICE@BAUD`"
)]
pub struct AddressError {
    /// The text.
    pub text: String,
    /// What is wrong with it.
    pub reason: &'static str,
}

impl FromStr for Address {
    type Err = AddressError;

    /// Reads an address. Without a host (`tcp:7070`) it is this computer; without a baud rate it is 115200.
    fn from_str(text: &str) -> Result<Address, AddressError> {
        let wrong = |reason| AddressError { text: text.to_owned(), reason };
        if text == "embedded" {
            Ok(Address::Embedded)
        } else if let Some(rest) = text.strip_prefix("tcp:") {
            let (host, port) = rest.rsplit_once(':').unwrap_or(("", rest));
            let port = port.parse().map_err(|_| wrong("the port is not a number from 0 to 65535"))?;
            let host = match host.strip_prefix('[') {
                Some(inner) => inner.strip_suffix(']').ok_or_else(|| wrong("the bracket is not closed"))?,
                None if host.contains(':') => return Err(wrong("a host with colons is written in brackets")),
                None if host.is_empty() => LOOPBACK,
                None => host,
            };
            Ok(Address::Tcp { host: host.to_owned(), port })
        } else if let Some(rest) = text.strip_prefix("serial:") {
            let (rest, flow) = rest.strip_suffix(FLOW).map_or((rest, false), |rest| (rest, true));
            let (device, baud) = match rest.rsplit_once('@') {
                Some((device, baud)) => (device, baud.parse().ok().filter(|baud| BAUDS.contains(baud))),
                None => (rest, Some(DEFAULT_BAUD)),
            };
            let baud =
                baud.ok_or_else(|| wrong("the baud rate behind `@` is not a number from 9600 to 921600"))?;
            if device.is_empty() {
                return Err(wrong("the device is missing"));
            }
            Ok(Address::Serial { device: device.to_owned(), baud, flow })
        } else {
            Err(wrong("it begins with none of the known words"))
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Address::Embedded => f.write_str("embedded"),
            Address::Tcp { host, port } if host.contains(':') => write!(f, "tcp:[{host}]:{port}"),
            Address::Tcp { host, port } => write!(f, "tcp:{host}:{port}"),
            Address::Serial { device, baud, flow } => {
                write!(f, "serial:{device}@{baud}{}", if *flow { FLOW } else { "" })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tcp(host: &str, port: u16) -> Address {
        Address::Tcp { host: host.into(), port }
    }

    fn serial(device: &str, baud: u32) -> Address {
        Address::Serial { device: device.into(), baud, flow: false }
    }

    #[test]
    fn addresses_are_read_and_written() {
        let table = [
            ("embedded", Address::Embedded, "embedded"),
            ("tcp:plc.local:7070", tcp("plc.local", 7070), "tcp:plc.local:7070"),
            ("tcp:7070", tcp("127.0.0.1", 7070), "tcp:127.0.0.1:7070"),
            ("tcp::7070", tcp("127.0.0.1", 7070), "tcp:127.0.0.1:7070"),
            ("tcp:[::1]:0", tcp("::1", 0), "tcp:[::1]:0"),
            ("serial:/dev/ttyUSB0", serial("/dev/ttyUSB0", 115_200), "serial:/dev/ttyUSB0@115200"),
            ("serial:COM3@9600", serial("COM3", 9600), "serial:COM3@9600"),
            (
                "serial:usb:0403:6001:A5@921600,rtscts",
                Address::Serial { device: "usb:0403:6001:A5".into(), baud: 921_600, flow: true },
                "serial:usb:0403:6001:A5@921600,rtscts",
            ),
        ];
        for (text, address, written) in table {
            assert_eq!(text.parse(), Ok(address.clone()), "{text}");
            assert_eq!(address.to_string(), written);
            assert_eq!(written.parse(), Ok(address));
        }
    }

    #[test]
    fn what_is_no_address_is_refused_with_a_reason() {
        let table = [
            ("", "it begins with none of the known words"),
            ("Embedded", "it begins with none of the known words"),
            ("/dev/ttyUSB0", "it begins with none of the known words"),
            ("tcp:", "the port is not a number from 0 to 65535"),
            ("tcp:host:70707", "the port is not a number from 0 to 65535"),
            ("tcp:::1:7070", "a host with colons is written in brackets"),
            ("tcp:[::1:7070", "the bracket is not closed"),
            ("serial:", "the device is missing"),
            ("serial:/dev/x@fast", "the baud rate behind `@` is not a number from 9600 to 921600"),
            ("serial:/dev/x@300", "the baud rate behind `@` is not a number from 9600 to 921600"),
        ];
        for (text, reason) in table {
            let error = text.parse::<Address>().unwrap_err();
            assert_eq!(error.reason, reason, "{text}");
        }
    }
}
