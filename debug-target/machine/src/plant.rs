//! The machine as a whole.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use technol_image::program::FASTEST_PERIODS;

use crate::block::{BlockStart, Program};
use crate::compile::{Compiler, ConfigError};
use crate::config::MachineConfig;
use crate::contact::Contact;
use crate::encoder::Encoder;
use crate::fault::Fault;
use crate::key::Key;
use crate::limit::Limit;
use crate::signal::{INPUT_PORTS, OUTPUT_PORTS, Signal};
use crate::turret::Turret;

/// Period of MODULE_FASTEST in microseconds when nothing is said.
const DEFAULT_FASTEST: u16 = 1000;

/// Something the machine does besides changing inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlantEvent {
    /// The control starts a block.
    StartBlock(BlockStart),
}

/// There is no fault or key of that name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName {
    /// The name asked for.
    pub name: String,
    /// Those there are.
    pub known: Vec<String>,
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.known.is_empty() {
            write!(f, "`{}` is not known: machine.toml defines none", self.name)
        } else {
            write!(f, "`{}` is not known; there is {}", self.name, self.known.join(", "))
        }
    }
}

impl core::error::Error for UnknownName {}

/// A machine that works.
#[derive(Clone, Debug, Default)]
pub struct Plant {
    millis: u64,
    contacts: Vec<Contact>,
    limits: Vec<Limit>,
    encoders: Vec<Encoder>,
    turrets: Vec<Turret>,
    keys: Vec<Key>,
    faults: Vec<Fault>,
    programs: Vec<Program>,
    fast_inputs: Vec<u8>,
    /// 0: the default.
    fastest_period: u16,
    fast_outputs: Vec<u8>,
}

impl Plant {
    /// Makes a machine from its description. `resolve` finds the bit behind a name; names of ports are
    /// understood by `|name| name.parse().ok()`.
    ///
    /// # Errors
    /// All that is wrong: unknown names, inputs in the place of outputs, inputs with two sources, times of 0.
    pub fn compile(
        config: &MachineConfig,
        resolve: &dyn Fn(&str) -> Option<Signal>,
    ) -> Result<Plant, Vec<ConfigError>> {
        let mut compiler = Compiler::new(resolve);
        let mut plant = Plant::default();
        for (index, element) in config.contact.iter().enumerate() {
            compiler.enter("contact", Some(index));
            plant.contacts.extend(Contact::compile(element, &mut compiler));
        }
        for (index, element) in config.limit.iter().enumerate() {
            compiler.enter("limit", Some(index));
            plant.limits.push(Limit::compile(element, &mut compiler));
        }
        for (index, element) in config.encoder.iter().enumerate() {
            compiler.enter("encoder", Some(index));
            plant.encoders.push(Encoder::compile(element, &mut compiler));
        }
        for (index, element) in config.turret.iter().enumerate() {
            compiler.enter("turret", Some(index));
            plant.turrets.push(Turret::compile(element, &mut compiler));
        }
        for (index, key) in config.key.iter().enumerate() {
            compiler.enter("key", Some(index));
            compiler.unique(&key.name, config.key[..index].iter().map(|k| k.name.as_str()));
            plant.keys.extend(Key::compile(key, &mut compiler));
        }
        for (index, fault) in config.fault.iter().enumerate() {
            compiler.enter("fault", Some(index));
            compiler.unique(&fault.name, config.fault[..index].iter().map(|f| f.name.as_str()));
            plant.faults.extend(Fault::compile(fault, &mut compiler));
        }
        plant.programs = Program::compile(&config.block, &mut compiler);
        crate::control::config::check(config, &mut compiler);
        compiler.enter("io", None);
        let fast = &config.io;
        plant.fast_inputs =
            fast.fast_inputs.iter().filter_map(|n| compiler.port("fast-inputs", n, true)).collect();
        plant.fast_outputs =
            fast.fast_outputs.iter().filter_map(|n| compiler.port("fast-outputs", n, false)).collect();
        let fastest = fast.fastest_period_us.unwrap_or(DEFAULT_FASTEST);
        if FASTEST_PERIODS.contains(&fastest) {
            plant.fastest_period = fastest;
        } else {
            let message =
                format!("{fastest} µs is no period of MODULE_FASTEST; use 100, 200, 250, 500 or 1000");
            compiler.error("fastest-period-us", message);
        }
        if compiler.errors.is_empty() { Ok(plant) } else { Err(compiler.errors) }
    }

    /// One millisecond: from the outputs to the inputs. Input bits that no element drives stay as they are.
    pub fn step(&mut self, outputs: &[u8; OUTPUT_PORTS], inputs: &mut [u8; INPUT_PORTS]) -> Vec<PlantEvent> {
        let mut outputs = *outputs;
        for fault in &self.faults {
            fault.spoil_outputs(&mut outputs);
        }
        for contact in &mut self.contacts {
            contact.step(&outputs, inputs);
        }
        for limit in &mut self.limits {
            limit.step(&outputs, inputs);
        }
        for encoder in &mut self.encoders {
            encoder.step(&outputs, inputs);
        }
        for turret in &mut self.turrets {
            turret.step(&outputs, inputs);
        }
        for key in &self.keys {
            key.step(inputs);
        }
        for fault in &self.faults {
            fault.spoil_inputs(inputs);
        }
        let mut events = Vec::new();
        for program in &mut self.programs {
            let blocks = program.step(self.millis, &outputs, inputs);
            events.extend(blocks.iter().cloned().map(PlantEvent::StartBlock));
        }
        self.millis += 1;
        events
    }

    /// The PLC starts: `at-cycle` counts from here. With `cold` every element is where it was at first; faults
    /// and keys stay as they are switched.
    pub fn start(&mut self, cold: bool) {
        self.millis = 0;
        for program in &mut self.programs {
            program.reset();
        }
        if cold {
            self.contacts.iter_mut().for_each(Contact::reset);
            self.limits.iter_mut().for_each(Limit::reset);
            self.encoders.iter_mut().for_each(Encoder::reset);
            self.turrets.iter_mut().for_each(Turret::reset);
        }
    }

    /// Switches a fault.
    pub fn set_fault(&mut self, name: &str, on: bool) -> Result<(), UnknownName> {
        match self.faults.iter_mut().find(|f| f.name == name) {
            Some(fault) => {
                fault.active = on;
                Ok(())
            }
            None => Err(unknown(name, self.faults.iter().map(|f| f.name.as_str()))),
        }
    }

    /// Presses (`down`) or releases a key.
    pub fn press(&mut self, name: &str, down: bool) -> Result<(), UnknownName> {
        match self.keys.iter_mut().find(|k| k.name == name) {
            Some(key) => {
                key.pressed = down;
                Ok(())
            }
            None => Err(unknown(name, self.keys.iter().map(|k| k.name.as_str()))),
        }
    }

    /// The faults and whether they are on.
    pub fn faults(&self) -> impl Iterator<Item = (&str, bool)> {
        self.faults.iter().map(|f| (f.name.as_str(), f.active))
    }

    /// The keys and whether they are pressed.
    pub fn keys(&self) -> impl Iterator<Item = (&str, bool)> {
        self.keys.iter().map(|k| (k.name.as_str(), k.pressed))
    }

    /// Indices of the input ports (0 is P1IN) that are copied each millisecond.
    #[must_use]
    pub fn fast_inputs(&self) -> &[u8] {
        &self.fast_inputs
    }

    /// Microseconds between the passes of MODULE_FASTEST.
    #[must_use]
    pub fn fastest_period(&self) -> u16 {
        if self.fastest_period == 0 { DEFAULT_FASTEST } else { self.fastest_period }
    }

    /// Indices of the output ports (0 is P0OUT) that are copied each millisecond.
    #[must_use]
    pub fn fast_outputs(&self) -> &[u8] {
        &self.fast_outputs
    }
}

fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> UnknownName {
    UnknownName { name: name.to_string(), known: known.map(ToString::to_string).collect() }
}
