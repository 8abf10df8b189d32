//! Bits of the input and output ports, named as in the language.

use core::fmt;
use core::str::FromStr;

use technol_image::system;

/// Bytes of the input image: P1IN … P128IN.
pub const INPUT_PORTS: usize = system::IN_PORT_COUNT as usize;
/// Bytes of the output image: P0OUT … P95OUT.
pub const OUTPUT_PORTS: usize = system::OUT_PORT_COUNT as usize;

/// Inputs as the machine drives them: behind those of the ports lie the bytes of slaves on buses.
pub(crate) type InputImage = [u8; 256];
/// Outputs as the machine sees them: behind those of the ports lie the bytes of slaves on buses.
pub(crate) type OutputImage = [u8; 256];
/// Bytes that slaves may give.
pub(crate) const BUS_INPUTS: usize = 256 - INPUT_PORTS;
/// Bytes that slaves may take.
pub(crate) const BUS_OUTPUTS: usize = 256 - OUTPUT_PORTS;

/// A bit of a port. A higher port than [`INPUT_PORTS`] or [`OUTPUT_PORTS`] is a byte of a slave on a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Signal {
    /// A bit the PLC reads.
    Input {
        /// Index into the input image; 0 is P1IN.
        port: u8,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A bit the PLC drives.
    Output {
        /// Index into the output image; 0 is P0OUT.
        port: u8,
        /// Bit number 0..=7.
        bit: u8,
    },
}

/// The text names no bit of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotASignal;

impl FromStr for Signal {
    type Err = NotASignal;

    /// Reads `P1IN.3` or `P0OUT.4`, in any case.
    fn from_str(text: &str) -> Result<Signal, NotASignal> {
        let (port, bit) = text.trim().split_once('.').ok_or(NotASignal)?;
        let bit = match bit.as_bytes() {
            [digit @ b'0'..=b'7'] => digit - b'0',
            _ => return Err(NotASignal),
        };
        match parse_port(port).ok_or(NotASignal)? {
            Signal::Input { port, .. } => Ok(Signal::Input { port, bit }),
            Signal::Output { port, .. } => Ok(Signal::Output { port, bit }),
        }
    }
}

impl fmt::Display for Signal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Signal::Input { port, bit } if usize::from(*port) >= INPUT_PORTS => {
                write!(f, "byte {}.{bit} from the bus", usize::from(*port) - INPUT_PORTS)
            }
            Signal::Output { port, bit } if usize::from(*port) >= OUTPUT_PORTS => {
                write!(f, "byte {}.{bit} to the bus", usize::from(*port) - OUTPUT_PORTS)
            }
            Signal::Input { port, bit } => write!(f, "P{}IN.{bit}", u32::from(*port) + 1),
            Signal::Output { port, bit } => write!(f, "P{port}OUT.{bit}"),
        }
    }
}

/// Reads the name of a whole port, `P5IN` or `P0OUT`, in any case: its bit 0.
#[must_use]
pub fn parse_port(text: &str) -> Option<Signal> {
    let text = text.trim();
    let rest = text.strip_prefix(['P', 'p'])?;
    let digits = rest.find(|c: char| !c.is_ascii_digit())?;
    let (number, kind) = rest.split_at(digits);
    let number: u32 = number.parse().ok()?;
    if kind.eq_ignore_ascii_case("IN") {
        let port = number.checked_sub(1).filter(|p| *p < system::IN_PORT_COUNT)?;
        Some(Signal::Input { port: port as u8, bit: 0 })
    } else if kind.eq_ignore_ascii_case("OUT") {
        let port = Some(number).filter(|p| *p < system::OUT_PORT_COUNT)?;
        Some(Signal::Output { port: port as u8, bit: 0 })
    } else {
        None
    }
}

/// A bit of the input image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InputBit {
    port: u8,
    mask: u8,
}

impl InputBit {
    pub(crate) fn new(port: u8, bit: u8) -> Self {
        InputBit { port, mask: 1 << bit }
    }

    pub(crate) fn set(self, inputs: &mut InputImage, value: bool) {
        let byte = &mut inputs[usize::from(self.port)];
        *byte = if value { *byte | self.mask } else { *byte & !self.mask };
    }
}

/// A bit of the output image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OutputBit {
    port: u8,
    mask: u8,
}

impl OutputBit {
    pub(crate) fn new(port: u8, bit: u8) -> Self {
        OutputBit { port, mask: 1 << bit }
    }

    pub(crate) fn get(self, outputs: &OutputImage) -> bool {
        outputs[usize::from(self.port)] & self.mask != 0
    }

    pub(crate) fn set(self, outputs: &mut OutputImage) {
        outputs[usize::from(self.port)] |= self.mask;
    }

    pub(crate) fn clear(self, outputs: &mut OutputImage) {
        outputs[usize::from(self.port)] &= !self.mask;
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
}
