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
use crate::control::elements;
use crate::counter::Counter;
use crate::drive::World;
use crate::element::{Element, Mounted};
use crate::encoder::Encoder;
use crate::fault::Fault;
use crate::key::Key;
use crate::latch::Latch;
use crate::limit::Limit;
use crate::motion::switch::AxisSwitch;
use crate::motion::{self, Motion, PanelKey};
use crate::ramp::Ramp;
use crate::settings::{self, ControlKey, ControlKeys, ControlSettings};
use crate::signal::{INPUT_PORTS, OUTPUT_PORTS, Signal};
use crate::slide::Slide;
use crate::turret::Turret;

/// Period of MODULE_FASTEST in microseconds when nothing is said.
const DEFAULT_FASTEST: u16 = 1000;

/// Something the machine does besides changing inputs.
#[derive(Clone, Debug, PartialEq)]
pub enum PlantEvent {
    /// The control starts a block.
    StartBlock(BlockStart),
    /// A key with a PLC command was pressed or released.
    Command {
        /// Its code.
        code: i32,
        /// Pressed.
        pressed: bool,
    },
    /// A key that concerns axes and spindles was pressed or released.
    Panel {
        /// Which.
        key: PanelKey,
        /// Pressed.
        pressed: bool,
    },
    /// START of the control after a stop.
    Start,
    /// STOP of the control.
    Stop {
        /// The emergency stop.
        emergency: bool,
    },
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
    elements: Vec<Mounted>,
    switches: Vec<AxisSwitch>,
    keys: Vec<Key>,
    faults: Vec<Fault>,
    /// Outputs with a short circuit; `None` while there is none.
    shorted: Option<[u8; OUTPUT_PORTS]>,
    programs: Vec<Program>,
    control_keys: ControlKeys,
    control: ControlSettings,
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
        plant.mount(config, &mut compiler);
        for (index, key) in config.key.iter().enumerate() {
            compiler.enter("key", Some(index));
            compiler.unique(&key.name, config.key[..index].iter().map(|k| k.name.as_str()));
            plant.keys.push(Key::compile(key, &mut compiler));
        }
        for (index, fault) in config.fault.iter().enumerate() {
            compiler.enter("fault", Some(index));
            compiler.unique(&fault.name, config.fault[..index].iter().map(|f| f.name.as_str()));
            plant.faults.extend(Fault::compile(fault, &plant.elements, &mut compiler));
        }
        plant.programs = Program::compile(&config.block, &mut compiler);
        plant.control_keys = ControlKeys::compile(config, &mut compiler);
        plant.control = settings::settings(config, &mut compiler);
        plant.apply_faults();
        elements::config::check(config, &mut compiler);
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

    fn mount(&mut self, config: &MachineConfig, compiler: &mut Compiler<'_>) {
        let mut add = |name: &str, element| self.elements.push(Mounted::new(name, element));
        for (index, element) in config.contact.iter().enumerate() {
            compiler.enter("contact", Some(index));
            if let Some(contact) = Contact::compile(element, compiler) {
                add(&element.name, Element::Contact(contact));
            }
        }
        for (index, element) in config.limit.iter().enumerate() {
            compiler.enter("limit", Some(index));
            add(&element.name, Element::Limit(Limit::compile(element, compiler)));
        }
        for (index, element) in config.encoder.iter().enumerate() {
            compiler.enter("encoder", Some(index));
            add(&element.name, Element::Encoder(Encoder::compile(element, compiler)));
        }
        for (index, element) in config.turret.iter().enumerate() {
            compiler.enter("turret", Some(index));
            add(&element.name, Element::Turret(Turret::compile(element, compiler)));
        }
        for (index, element) in config.latch.iter().enumerate() {
            compiler.enter("latch", Some(index));
            if let Some(latch) = Latch::compile(element, compiler) {
                add(&element.name, Element::Latch(latch));
            }
        }
        for (index, element) in config.counter.iter().enumerate() {
            compiler.enter("counter", Some(index));
            add(&element.name, Element::Counter(Counter::compile(element, compiler)));
        }
        for (index, element) in config.ramp.iter().enumerate() {
            compiler.enter("ramp", Some(index));
            if let Some(ramp) = Ramp::compile(element, compiler) {
                add(&element.name, Element::Ramp(ramp));
            }
        }
        for (index, element) in config.slide.iter().enumerate() {
            compiler.enter("slide", Some(index));
            add(&element.name, Element::Slide(Slide::compile(element, compiler)));
        }
        for (index, axis) in config.axis.iter().enumerate() {
            compiler.enter("axis", Some(index));
            motion::settings::check(axis, &config.axis[..index], compiler);
            for switch in &axis.switch {
                self.switches.extend(AxisSwitch::compile(axis, switch, compiler));
            }
        }
        for (index, spindle) in config.spindle.iter().enumerate() {
            compiler.enter("spindle", Some(index));
            motion::spindle::check(spindle, &config.spindle[..index], compiler);
        }
    }

    /// One millisecond: from the outputs to the inputs. Input bits that no element drives stay as they are.
    pub fn step(&mut self, outputs: &[u8; OUTPUT_PORTS], inputs: &mut [u8; INPUT_PORTS]) -> Vec<PlantEvent> {
        let before = *inputs;
        let mut outputs = *outputs;
        for fault in &self.faults {
            fault.spoil_outputs(&mut outputs);
        }
        let world = World { outputs: &outputs, before: &before };
        for mounted in &mut self.elements {
            mounted.step(world, inputs);
        }
        for switch in &self.switches {
            switch.step(inputs);
        }
        for key in &self.keys {
            key.step(inputs);
        }
        for fault in &self.faults {
            fault.spoil_inputs(inputs);
        }
        let mut events = Vec::new();
        events.extend(self.keys.iter_mut().flat_map(Key::events));
        self.control_events(World { outputs: &outputs, before: inputs }, &mut events);
        for program in &mut self.programs {
            let blocks = program.step(self.millis, &outputs, inputs);
            events.extend(blocks.iter().cloned().map(PlantEvent::StartBlock));
        }
        self.millis += 1;
        events
    }

    fn control_events(&mut self, world: World<'_>, events: &mut Vec<PlantEvent>) {
        let ControlKeys { start, stop, emergency_stop } = &mut self.control_keys;
        let mut down = |key: &mut Option<ControlKey>, event| {
            if key.as_mut().is_some_and(|key| key.goes_down(world)) {
                events.push(event);
            }
        };
        down(emergency_stop, PlantEvent::Stop { emergency: true });
        down(stop, PlantEvent::Stop { emergency: false });
        down(start, PlantEvent::Start);
    }

    /// The axes are where they are now; their switches follow in the next [`Plant::step`].
    pub fn place_axes(&mut self, motion: &Motion) {
        for switch in &mut self.switches {
            switch.place(motion);
        }
    }

    /// The PLC starts: `at-cycle` counts from here. With `cold` every element is where it was at first; faults
    /// and keys stay as they are switched.
    pub fn start(&mut self, cold: bool) {
        self.millis = 0;
        for program in &mut self.programs {
            program.reset();
        }
        self.control_keys.reset();
        if cold {
            self.elements.iter_mut().for_each(Mounted::reset);
        }
    }

    /// Switches a fault.
    pub fn set_fault(&mut self, name: &str, on: bool) -> Result<(), UnknownName> {
        match self.faults.iter_mut().find(|f| f.name == name) {
            Some(fault) => {
                fault.active = on;
                self.apply_faults();
                Ok(())
            }
            None => Err(unknown(name, self.faults.iter().map(|f| f.name.as_str()))),
        }
    }

    /// What hinders the elements, and which outputs are shorted, after a fault was switched.
    fn apply_faults(&mut self) {
        for mounted in &mut self.elements {
            mounted.pace = 1;
            mounted.held = None;
        }
        let mut shorted = [0; OUTPUT_PORTS];
        for fault in &self.faults {
            fault.act(&mut self.elements, &mut shorted);
        }
        self.shorted = Some(shorted).filter(|ports| ports.iter().any(|port| *port != 0));
    }

    /// Outputs with a short circuit, one bit each; `None` while there is none.
    #[must_use]
    pub fn shorted(&self) -> Option<&[u8; OUTPUT_PORTS]> {
        self.shorted.as_ref()
    }

    /// Settings of the control.
    #[must_use]
    pub fn control(&self) -> &ControlSettings {
        &self.control
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

    /// A number that two machines of the same description share when they are in the same state.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        crate::state_hash::of(self)
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
