//! From names to bits: reports everything that is wrong, not only the first.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::drive::{Drive, Outputs, Signals, Watch};
use crate::signal::{InputBit, OutputBit, Signal};

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
    /// Who drives which input: its path.
    drivers: BTreeMap<Signal, String>,
    pub(crate) errors: Vec<ConfigError>,
    table: &'static str,
    index: Option<usize>,
}

impl<'a> Compiler<'a> {
    pub(crate) fn new(resolve: &'a dyn Fn(&str) -> Option<Signal>) -> Self {
        let (drivers, errors) = (BTreeMap::new(), Vec::new());
        Compiler { resolve, drivers, errors, table: "", index: None }
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
        let signal = (self.resolve)(name);
        if signal.is_none() {
            let message =
                format!("`{name}` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 to P95OUT.7");
            self.error(key, message);
        }
        signal
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
        let signal = (self.resolve)(name)?;
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

    /// A whole input port that this element drives.
    pub(crate) fn driven_port(&mut self, key: &'static str, name: &str) -> Option<u8> {
        let port = self.port(key, name, true)?;
        for bit in 0..8 {
            self.claim(key, Signal::Input { port, bit });
        }
        Some(port)
    }

    /// A whole port: its index in the input or output image.
    pub(crate) fn port(&mut self, key: &'static str, name: &str, input: bool) -> Option<u8> {
        match (crate::signal::parse_port(name), input) {
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
        if names.len() > most {
            self.error(key, format!("has more than {most} ports"));
        } else if !names.is_empty() && highest >> (8 * names.len() as u32) != 0 {
            self.error(key, format!("has too few ports for {highest}"));
        }
        names.iter().filter_map(|name| self.driven_port(key, name)).collect()
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
