//! From names to bits: reports everything that is wrong, not only the first.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::control::elements::identifier;
use crate::control::ethercat::layout::Line;
use crate::drive::{Drive, Outputs, Signals, Watch};
use crate::signal::{INPUT_PORTS, InputBit, OUTPUT_PORTS, OutputBit, Signal};

/// Something in the description of a machine that does not work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigError {
    /// Table, for instance `contact`.
    pub table: &'static str,
    /// Which one of that kind, from 0; `None`: there is only one.
    pub index: Option<usize>,
    /// Key in it; empty: the table as a whole.
    pub key: &'static str,
    /// What is wrong, and what would be right.
    pub message: String,
}

impl ConfigError {
    /// Where it is: `contact[2].input`, counted from 0.
    #[must_use]
    pub fn path(&self) -> String {
        let index = self.index.map(|n| format!("[{n}]")).unwrap_or_default();
        let dot = if self.key.is_empty() { "" } else { "." };
        format!("{}{index}{dot}{}", self.table, self.key)
    }
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path(), self.message)
    }
}

impl core::error::Error for ConfigError {}

/// Resolves names and collects errors.
pub(crate) struct Compiler<'a> {
    resolve: &'a dyn Fn(&str) -> Option<Signal>,
    /// Values of slaves, which have names too.
    lines: &'a [Line],
    /// Who drives which input: its path.
    drivers: BTreeMap<Signal, String>,
    /// The same for analogue inputs.
    analog_drivers: BTreeMap<u8, String>,
    pub(crate) errors: Vec<ConfigError>,
    table: &'static str,
    index: Option<usize>,
}

impl<'a> Compiler<'a> {
    pub(crate) fn new(resolve: &'a dyn Fn(&str) -> Option<Signal>, lines: &'a [Line]) -> Self {
        let (drivers, analog_drivers, errors) = (BTreeMap::new(), BTreeMap::new(), Vec::new());
        Compiler { resolve, lines, drivers, analog_drivers, errors, table: "", index: None }
    }

    /// What follows belongs to this table.
    pub(crate) fn enter(&mut self, table: &'static str, index: Option<usize>) {
        self.table = table;
        self.index = index;
    }

    pub(crate) fn error(&mut self, key: &'static str, message: impl Into<String>) {
        let error = ConfigError { table: self.table, index: self.index, key, message: message.into() };
        self.errors.push(error);
    }

    /// Any signal.
    pub(crate) fn signal(&mut self, key: &'static str, name: &str) -> Option<Signal> {
        let signal = self.find(name);
        if signal.is_none() {
            let message = if !is_of_slave(name) {
                format!("`{name}` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 to P95OUT.7")
            } else if slave_bytes(self.lines, name).is_some() {
                format!("`{name}` is more than a bit; choose one by `.Bit[n]` at its end")
            } else {
                format!("no slave of `[[ethercat]]` has `{name}`")
            };
            self.error(key, message);
        }
        signal
    }

    fn find(&self, name: &str) -> Option<Signal> {
        if is_of_slave(name) { slave_bit(self.lines, name) } else { (self.resolve)(name) }
    }

    /// Whole ports, or the bytes of a value of a slave: indexes in the input or output image.
    pub(crate) fn bytes(&mut self, key: &'static str, name: &str, input: bool) -> Vec<u8> {
        if !is_of_slave(name) {
            return self.port(key, name, input).into_iter().collect();
        }
        let Some(line) = slave_bytes(self.lines, name).filter(|line| line.output != input) else {
            let way = if input { "inputs" } else { "outputs" };
            self.error(key, format!("no slave of `[[ethercat]]` has `{name}` among its {way}"));
            return Vec::new();
        };
        let first = line.first + if input { INPUT_PORTS } else { OUTPUT_PORTS };
        // The image has 256 bytes; a line past its end was reported.
        (first..first + line.bytes).filter_map(|byte| u8::try_from(byte).ok()).collect()
    }

    /// Takes an analogue input for the element at hand.
    pub(crate) fn claim_analog(&mut self, key: &'static str, channel: u8) {
        let here = ConfigError { table: self.table, index: self.index, key, message: String::new() }.path();
        if let Some(other) = self.analog_drivers.get(&channel) {
            let message = format!(
                "ANALOG_INPUT_PHYSICAL[{channel}] is driven by {other} already; an input has one source"
            );
            self.error(key, message);
        } else {
            self.analog_drivers.insert(channel, here);
        }
    }

    /// Outputs of the PLC that drive something.
    pub(crate) fn drive(&mut self, key: &'static str, names: &Outputs) -> Drive {
        if names.0.is_empty() {
            self.error(key, "names no output");
        }
        Drive(names.0.iter().filter_map(|name| self.output(key, name)).collect())
    }

    /// An output of the PLC.
    pub(crate) fn output(&mut self, key: &'static str, name: &str) -> Option<OutputBit> {
        match self.signal(key, name)? {
            Signal::Output { port, bit } => Some(OutputBit::new(port, bit)),
            Signal::Input { .. } => {
                self.error(
                    key,
                    format!("`{name}` is an input; an output of the PLC is needed, such as P0OUT.0"),
                );
                None
            }
        }
    }

    /// An input of the PLC, without driving it.
    pub(crate) fn input(&mut self, key: &'static str, name: &str) -> Option<InputBit> {
        match self.signal(key, name)? {
            Signal::Input { port, bit } => Some(InputBit::new(port, bit)),
            Signal::Output { .. } => {
                self.error(
                    key,
                    format!("`{name}` is an output; an input of the PLC is needed, such as P1IN.0"),
                );
                None
            }
        }
    }

    /// An input that this element drives, as the only one.
    pub(crate) fn driven(&mut self, key: &'static str, name: &str) -> Option<InputBit> {
        let bit = self.input(key, name)?;
        let signal = self.find(name)?;
        self.claim(key, signal);
        Some(bit)
    }

    /// Takes an input for the element at hand.
    fn claim(&mut self, key: &'static str, signal: Signal) {
        let here = ConfigError { table: self.table, index: self.index, key, message: String::new() }.path();
        if let Some(other) = self.drivers.get(&signal) {
            let message = format!("{signal} is driven by {other} already; an input has one source");
            self.error(key, message);
        } else {
            self.drivers.insert(signal, here);
        }
    }

    /// A whole input port, or a value of a slave, that this element drives.
    pub(crate) fn driven_bytes(&mut self, key: &'static str, name: &str) -> Vec<u8> {
        let bytes = self.bytes(key, name, true);
        for port in &bytes {
            for bit in 0..8 {
                self.claim(key, Signal::Input { port: *port, bit });
            }
        }
        bytes
    }

    /// A whole port: its index in the input or output image.
    pub(crate) fn port(&mut self, key: &'static str, name: &str, input: bool) -> Option<u8> {
        match (Signal::of_port_named(name), input) {
            (Some(Signal::Input { port, .. }), true) | (Some(Signal::Output { port, .. }), false) => {
                Some(port)
            }
            _ => {
                let (kind, range) =
                    if input { ("input", "P1IN to P128IN") } else { ("output", "P0OUT to P95OUT") };
                self.error(key, format!("`{name}` is not an {kind} port; use {range}"));
                None
            }
        }
    }

    /// Any signals, of which one is enough.
    pub(crate) fn watch(&mut self, key: &'static str, names: &Signals) -> Watch {
        if names.0.is_empty() {
            self.error(key, "names no signal");
        }
        Watch(names.0.iter().filter_map(|name| self.signal(key, name)).collect())
    }

    /// Whole input ports that this element drives, at most `most`, which hold numbers up to `highest`.
    pub(crate) fn driven_ports(
        &mut self,
        key: &'static str,
        names: &[String],
        most: usize,
        highest: u64,
    ) -> Vec<u8> {
        let bytes: Vec<u8> = names.iter().flat_map(|name| self.driven_bytes(key, name)).collect();
        let room = bytes.len().max(names.len());
        if room > most {
            self.error(key, format!("has more than {most} ports"));
        } else if room > 0 && highest >> (8 * room as u32) != 0 {
            self.error(key, format!("has too few ports for {highest}"));
        }
        bytes
    }

    /// A time that must not be zero.
    pub(crate) fn at_least(&mut self, key: &'static str, value: u32, least: u32) {
        if value < least {
            self.error(key, format!("must be at least {least}"));
        }
    }

    /// A name that people use; unique in its kind.
    pub(crate) fn unique(&mut self, name: &str, mut earlier: impl Iterator<Item = &'a str>) {
        if name.trim().is_empty() {
            self.error("name", "must not be empty; it is how this is switched");
        } else if earlier.any(|other| other == name) {
            self.error("name", format!("`{name}` is used twice; names must differ"));
        }
    }
}

/// Something of an EtherCAT slave.
fn is_of_slave(name: &str) -> bool {
    name.trim_start().get(..5).is_some_and(|group| group.eq_ignore_ascii_case("ECAT."))
}

/// A value of a slave.
fn slave_bytes<'a>(lines: &'a [Line], name: &str) -> Option<&'a Line> {
    let id = identifier(name.as_bytes()).ok()?;
    lines.iter().find(|line| line.id == id)
}

/// A value that is a bit, or the bit of one.
pub(crate) fn slave_bit(lines: &[Line], name: &str) -> Option<Signal> {
    let whole = slave_bytes(lines, name).and_then(|line| Some((line, usize::from(line.bit?))));
    let (line, bit) = whole.or_else(|| {
        let id = identifier(name.as_bytes()).ok()?;
        let (id, last) = id.rsplit_once(".bit")?;
        let digits = if last.is_empty() { Some("0") } else { last.strip_prefix('[')?.strip_suffix(']') };
        let line = lines.iter().find(|line| line.id == id && line.bit.is_none())?;
        let bit: usize = digits?.parse().ok()?;
        (bit < 8 * line.bytes).then_some((line, bit))
    })?;
    let byte = |first: usize| u8::try_from(first + line.first + bit / 8).ok();
    let bit = (bit % 8) as u8;
    Some(if line.output {
        Signal::Output { port: byte(OUTPUT_PORTS)?, bit }
    } else {
        Signal::Input { port: byte(INPUT_PORTS)?, bit }
    })
}
