//! What the configuration of a channel says about inputs and outputs: where the identifiers of MAP_IN, MAP_OUT, MAP_AIN and
//! MAP_AOUT lead (manual 10.2 and 10.3), and which outputs go to which inputs (manual 27.5).

use alloc::string::String;
use alloc::vec::Vec;

use technol_image::op::Addr;
use technol_image::system::{self, devices};

use super::value::ElementValue;
use super::{Conversion, Group, Wire};
use crate::signal::Signal;

/// Bits of a byte of ANALOG_CONNECTED.
const INPUT_MAPPED: u8 = 1;
const OUTPUT_MAPPED: u8 = 2;

/// Inputs, outputs and connections of the configuration files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChannelWiring {
    /// `Input`, `Output`, `AnalogInput`, `AnalogOutput`. Of two of one kind and identifier the first counts.
    pub points: Vec<Mapping>,
    /// `Connection`, only those that are connected.
    pub connections: Vec<Connection>,
}

/// An input or output of the configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapping {
    /// Its identifier in the code page of the control; case counts.
    pub id: Vec<u8>,
    /// Where it leads.
    pub physical: Physical,
    /// It does lead there; otherwise its cell holds the default.
    pub connected: bool,
    /// The default.
    pub default: f64,
}

/// The physical end of an input or output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Physical {
    /// A bit of an input or output port.
    Bit {
        /// Which.
        signal: Signal,
        /// The other value.
        invert: bool,
    },
    /// An analogue input: (volts + offset) · scale, held within the limits.
    AnalogInput(Analog),
    /// An analogue output: the value, held within the limits, · scale + offset is volts.
    AnalogOutput(Analog),
}

/// An analogue channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Analog {
    /// Its number, 0 to 99.
    pub channel: u8,
    /// Factor.
    pub scale: f64,
    /// Shift.
    pub offset: f64,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
}

/// An output that goes to an input.
#[derive(Clone, Debug, PartialEq)]
pub struct Connection {
    /// Identifier of the output with its group, perhaps `.Bit[n]` at the end.
    pub source: String,
    /// Identifier of the input.
    pub destination: String,
    /// What is done on the way.
    pub conversion: Conversion,
}

impl Analog {
    fn limited(&self, value: f64) -> f64 {
        value.max(self.min).min(self.max)
    }

    /// Where its volts are.
    fn addr(&self, array: Addr) -> usize {
        array as usize + 8 * usize::from(self.channel)
    }
}

impl Physical {
    /// It belongs to MAP_OUT or MAP_AOUT.
    fn is_output(&self) -> bool {
        matches!(self, Physical::Bit { signal: Signal::Output { .. }, .. } | Physical::AnalogOutput(_))
    }

    fn is_bit(&self) -> bool {
        matches!(self, Physical::Bit { .. })
    }

    /// The bit behind a binary one.
    pub(super) fn wire(&self) -> Option<Wire> {
        match *self {
            Physical::Bit { signal, invert } => Some(Wire::to(signal, invert)),
            _ => None,
        }
    }

    /// The value of an input.
    pub(super) fn read(&self, memory: &[u8]) -> Option<ElementValue> {
        match self {
            Physical::Bit { .. } => self.wire()?.read(memory),
            Physical::AnalogInput(it) => {
                let at = it.addr(devices::ANALOG_INPUT);
                let volts = f64::from_le_bytes(memory.get(at..at + 8)?.try_into().ok()?);
                Some(it.limited((volts + it.offset) * it.scale).into())
            }
            Physical::AnalogOutput(_) => None,
        }
    }

    /// The value of an analogue output becomes volts.
    pub(super) fn write_volts(&self, value: &ElementValue, memory: &mut [u8]) {
        let (Physical::AnalogOutput(it), Some(value)) = (self, value.as_real()) else { return };
        let at = it.addr(devices::ANALOG_OUTPUT);
        if let Some(cell) = memory.get_mut(at..at + 8) {
            cell.copy_from_slice(&(it.limited(value) * it.scale + it.offset).to_le_bytes());
        }
    }
}

impl ChannelWiring {
    /// The point that an instruction means by an identifier.
    pub(super) fn find(&self, id: &[u8], group: Group, output: bool, bit: bool) -> Option<&Mapping> {
        let fits = |it: &&Mapping| it.physical.is_output() == output && it.physical.is_bit() == bit;
        let named = |it: &&Mapping| it.id.trim_ascii() == id.trim_ascii();
        self.points.iter().filter(|_| group == Group::Mapped).filter(fits).find(named)
    }

    /// ANALOG_CONNECTED, after a start from power-on.
    pub(in crate::control) fn mark_analog(&self, memory: &mut [u8]) {
        for point in self.points.iter().filter(|point| point.connected) {
            let (channel, mark) = match point.physical {
                Physical::AnalogInput(it) => (it.channel, INPUT_MAPPED),
                Physical::AnalogOutput(it) => (it.channel, OUTPUT_MAPPED),
                Physical::Bit { .. } => continue,
            };
            if let Some(byte) = memory.get_mut(devices::ANALOG_CONNECTED as usize + usize::from(channel)) {
                *byte |= mark;
            }
        }
    }
}

impl Wire {
    /// A bit of a port.
    pub(super) fn to(signal: Signal, invert: bool) -> Wire {
        let (first, port, bit) = match signal {
            Signal::Input { port, bit } => (system::IN_PORTS, port, bit),
            Signal::Output { port, bit } => (system::OUT_PORTS, port, bit),
        };
        Wire { addr: first as usize + usize::from(port), mask: 1 << bit, invert }
    }

    /// The same bit, inverted or not.
    pub(super) fn is_same_bit(&self, other: &Wire) -> bool {
        (self.addr, self.mask) == (other.addr, other.mask)
    }

    pub(super) fn read(&self, memory: &[u8]) -> Option<ElementValue> {
        memory.get(self.addr).map(|port| ((port & self.mask != 0) != self.invert).into())
    }

    pub(super) fn write(&self, on: bool, memory: &mut [u8]) {
        if let Some(port) = memory.get_mut(self.addr) {
            *port = if on == self.invert { *port & !self.mask } else { *port | self.mask };
        }
    }
}
