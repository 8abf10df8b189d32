//! Bits of the input and output ports, named as in the language.

use alloc::format;
use alloc::string::String;
use core::fmt;
use core::str::FromStr;

use crate::op::Addr;
use crate::system;

/// A bit of a port. Behind the last port ([`system::IN_PORT_COUNT`], [`system::OUT_PORT_COUNT`]) a simulated machine
/// counts on with the bytes of slaves on its buses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Signal {
    /// A bit the PLC reads.
    Input {
        /// Number of the port from 0, which is P1IN.
        port: u8,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A bit the PLC drives.
    Output {
        /// Number of the port from 0, which is P0OUT.
        port: u8,
        /// Bit number 0..=7.
        bit: u8,
    },
}

impl Signal {
    /// Bit 0 of the port that this byte of memory is.
    #[must_use]
    pub fn of_port_at(addr: Addr) -> Option<Signal> {
        let index = |start: Addr, count: u32| {
            addr.checked_sub(start).filter(|n| *n < count).and_then(|n| u8::try_from(n).ok())
        };
        let input = index(system::IN_PORTS, system::IN_PORT_COUNT);
        let output = index(system::OUT_PORTS, system::OUT_PORT_COUNT);
        input.map(Signal::input).or_else(|| output.map(Signal::output))
    }

    /// Bit 0 of the port with this name, `P5IN` or `P0OUT` in any case.
    #[must_use]
    pub fn of_port_named(text: &str) -> Option<Signal> {
        let text = text.trim();
        let rest = text.strip_prefix(['P', 'p'])?;
        let digits = rest.find(|c: char| !c.is_ascii_digit())?;
        let (number, kind) = rest.split_at(digits);
        let number: u32 = number.parse().ok()?;
        let below = |port: u32, count: u32| u8::try_from(port).ok().filter(|_| port < count);
        if kind.eq_ignore_ascii_case("IN") {
            below(number.checked_sub(1)?, system::IN_PORT_COUNT).map(Signal::input)
        } else if kind.eq_ignore_ascii_case("OUT") {
            below(number, system::OUT_PORT_COUNT).map(Signal::output)
        } else {
            None
        }
    }

    fn input(port: u8) -> Signal {
        Signal::Input { port, bit: 0 }
    }

    fn output(port: u8) -> Signal {
        Signal::Output { port, bit: 0 }
    }

    /// Another bit of the same port: number 0..=7.
    #[must_use]
    pub fn with_bit(self, bit: u8) -> Signal {
        match self {
            Signal::Input { port, .. } => Signal::Input { port, bit },
            Signal::Output { port, .. } => Signal::Output { port, bit },
        }
    }

    /// Name of its port: `P1IN`, `P0OUT`.
    #[must_use]
    pub fn port_name(self) -> String {
        match self {
            Signal::Input { port, .. } => format!("P{}IN", u32::from(port) + 1),
            Signal::Output { port, .. } => format!("P{port}OUT"),
        }
    }
}

/// The text names no bit of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotASignal;

impl FromStr for Signal {
    type Err = NotASignal;

    /// Reads `P1IN.3` or `P0OUT.4`, in any case.
    fn from_str(text: &str) -> Result<Signal, NotASignal> {
        let (port, bit) = text.trim().split_once('.').ok_or(NotASignal)?;
        let port = Signal::of_port_named(port).ok_or(NotASignal)?;
        match bit.as_bytes() {
            [digit @ b'0'..=b'7'] => Ok(port.with_bit(digit - b'0')),
            _ => Err(NotASignal),
        }
    }
}

impl fmt::Display for Signal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let behind = |port: u8, count: u32| u32::from(port).checked_sub(count);
        match *self {
            Signal::Input { port, bit } => match behind(port, system::IN_PORT_COUNT) {
                Some(byte) => write!(f, "byte {byte}.{bit} from the bus"),
                None => write!(f, "{}.{bit}", self.port_name()),
            },
            Signal::Output { port, bit } => match behind(port, system::OUT_PORT_COUNT) {
                Some(byte) => write!(f, "byte {byte}.{bit} to the bus"),
                None => write!(f, "{}.{bit}", self.port_name()),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn signals_are_named_as_in_the_language() {
        let table = [
            ("P1IN.0", Some(Signal::Input { port: 0, bit: 0 })),
            ("p128in.7", Some(Signal::Input { port: 127, bit: 7 })),
            (" P0OUT.4 ", Some(Signal::Output { port: 0, bit: 4 })),
            ("P95out.7", Some(Signal::Output { port: 95, bit: 7 })),
            ("P0IN.0", None),
            ("P129IN.0", None),
            ("P96OUT.0", None),
            ("P1IN.8", None),
            ("P1IN.", None),
            ("P1IN", None),
            ("PIN.1", None),
            ("P1INX.1", None),
            ("P99999999999IN.1", None),
            ("SPINDLE_ON", None),
            ("", None),
        ];
        for (text, expected) in table {
            let signal = text.parse::<Signal>().ok();
            assert_eq!(signal, expected, "{text}");
            if let Some(signal) = signal {
                assert_eq!(signal.to_string(), text.trim().to_uppercase());
            }
        }
    }

    #[test]
    fn bytes_of_memory_are_ports_as_far_as_there_are_any() {
        for (addr, expected) in [
            (system::IN_PORTS, Some("P1IN")),
            (system::IN_PORTS + 127, Some("P128IN")),
            (system::OUT_PORTS, Some("P0OUT")),
            (system::OUT_PORTS + 95, Some("P95OUT")),
            (system::OUT_PORTS + 96, None),
            (u32::MAX, None),
        ] {
            let signal = Signal::of_port_at(addr);
            assert_eq!(signal.map(Signal::port_name).as_deref(), expected, "{addr:#x}");
            assert_eq!(signal, expected.and_then(Signal::of_port_named), "{addr:#x}");
        }
    }
}
