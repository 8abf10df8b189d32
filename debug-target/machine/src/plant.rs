//! The machine as a whole.

use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use technol_image::program::FASTEST_PERIODS;
use technol_image::system::devices::{ANALOG_CHANNELS, ANALOG_OUTPUT};
use technol_runtime::Block;

use crate::analog::{AnalogInputs, Volts};
use crate::block::Program;
use crate::compile::{Compiler, ConfigError};
use crate::config::MachineConfig;
use crate::contact::Contact;
use crate::control::{SimulatedControl, elements, ethercat};
use crate::counter::Counter;
use crate::drive::World;
use crate::element::{Element, Mounted};
use crate::encoder::Encoder;
use crate::fault::{BusFault, Fault};
use crate::key::Key;
use crate::latch::Latch;
use crate::limit::Limit;
use crate::motion::switch::AxisSwitch;
use crate::motion::{self, Motion, PanelKey};
use crate::ramp::Ramp;
use crate::settings::{self, ControlKey, ControlKeys, ControlSettings};
use crate::signal::{BUS_INPUTS, BUS_OUTPUTS, INPUT_PORTS, InputImage, OUTPUT_PORTS, OutputImage, Signal};
use crate::slide::Slide;
use crate::turret::Turret;

/// Period of MODULE_FASTEST in microseconds when nothing is said.
const DEFAULT_FASTEST: u16 = 1000;

/// Something the machine does besides changing inputs.
#[derive(Clone, Debug, PartialEq)]
pub enum PlantEvent {
    /// The control starts a block.
    StartBlock(Block),
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
    /// What happened in the last millisecond and was not fetched yet. There is room for all that can happen in one.
    events: VecDeque<PlantEvent>,
    control_keys: ControlKeys,
    control: ControlSettings,
    fast_inputs: Vec<u8>,
    /// 0: the default.
    fastest_period: u16,
    fast_outputs: Vec<u8>,
    /// What slaves on buses give, and what they were given.
    bus_inputs: Bytes<BUS_INPUTS>,
    bus_outputs: Bytes<BUS_OUTPUTS>,
    has_slaves: bool,
    bus_faults: Vec<BusFault>,
    volts: Volts,
    sees_volts: bool,
    analog_inputs: AnalogInputs,
}

/// Bytes, all 0 at first.
#[derive(Clone, Debug)]
struct Bytes<const N: usize>([u8; N]);

impl<const N: usize> Default for Bytes<N> {
    fn default() -> Bytes<N> {
        Bytes([0; N])
    }
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
        let lines = ethercat::layout::lines(&config.ethercat);
        let mut compiler = Compiler::new(resolve, &lines);
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
            plant.faults.extend(Fault::compile(fault, config, &plant.elements, &mut compiler));
        }
        plant.programs = Program::compile(&config.block, &mut compiler);
        plant.control_keys = ControlKeys::compile(config, &mut compiler);
        plant.events = VecDeque::with_capacity(plant.most_events());
        plant.control = settings::settings(config, &mut compiler);
        plant.apply_faults();
        plant.has_slaves = !lines.is_empty();
        plant.sees_volts = plant.elements.iter().any(Mounted::sees_volts);
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

    /// As much as can happen in a millisecond: two for each key, those of the control, and all programs at once.
    fn most_events(&self) -> usize {
        2 * self.keys.len() + 3 + self.block_count()
    }

    /// Blocks of all its programs.
    #[must_use]
    pub fn block_count(&self) -> usize {
        self.programs.iter().map(Program::len).sum()
    }

    /// One millisecond: from the outputs to the inputs. Input bits that no element drives stay as they are. What happens
    /// besides waits for [`Plant::next_event`] until the next step. Asks for no memory.
    pub fn step(&mut self, outputs: &[u8; OUTPUT_PORTS], inputs: &mut [u8; INPUT_PORTS]) {
        let (mut image, mut seen) = (self.input_image(inputs), self.output_image(outputs));
        let before = image;
        for fault in &self.faults {
            fault.spoil_outputs(&mut seen);
        }
        let world = World { outputs: &seen, before: &before, volts: &self.volts };
        for mounted in &mut self.elements {
            mounted.step(world, &mut image);
        }
        for switch in &self.switches {
            switch.step(&mut image);
        }
        for key in &self.keys {
            key.step(&mut image);
        }
        for fault in &self.faults {
            fault.spoil_inputs(&mut image);
        }
        inputs.copy_from_slice(&image[..INPUT_PORTS]);
        self.bus_inputs.0.copy_from_slice(&image[INPUT_PORTS..]);
        self.analog_inputs.clear();
        for mounted in &self.elements {
            mounted.show_volts(&mut self.analog_inputs);
        }
        self.happen(&seen, &image);
    }

    /// What happened in the last [`Plant::step`], in order, until there is no more.
    pub fn next_event(&mut self) -> Option<PlantEvent> {
        self.events.pop_front()
    }

    fn input_image(&self, ports: &[u8; INPUT_PORTS]) -> InputImage {
        let mut image = [0; INPUT_PORTS + BUS_INPUTS];
        image[..INPUT_PORTS].copy_from_slice(ports);
        image[INPUT_PORTS..].copy_from_slice(&self.bus_inputs.0);
        image
    }

    fn output_image(&self, ports: &[u8; OUTPUT_PORTS]) -> OutputImage {
        let mut image = [0; OUTPUT_PORTS + BUS_OUTPUTS];
        image[..OUTPUT_PORTS].copy_from_slice(ports);
        image[OUTPUT_PORTS..].copy_from_slice(&self.bus_outputs.0);
        image
    }

    /// What happens besides in a millisecond.
    fn happen(&mut self, outputs: &OutputImage, inputs: &InputImage) {
        self.events.clear();
        self.keys.iter_mut().for_each(|key| key.tell(&mut self.events));
        self.press_control_keys(outputs, inputs);
        for program in &mut self.programs {
            let blocks = program.step(self.millis, outputs, inputs);
            for block in blocks {
                self.events.push_back(PlantEvent::StartBlock(block.clone()));
            }
        }
        self.millis += 1;
    }

    fn press_control_keys(&mut self, outputs: &OutputImage, inputs: &InputImage) {
        let world = World { outputs, before: inputs, volts: &self.volts };
        let ControlKeys { start, stop, emergency_stop } = &mut self.control_keys;
        let mut down = |key: &mut Option<ControlKey>, event| {
            if key.as_mut().is_some_and(|key| key.goes_down(world)) {
                self.events.push_back(event);
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
            self.bus_inputs = Bytes::default();
            self.bus_outputs = Bytes::default();
        }
    }

    /// What the control gave the slaves of its buses and its analogue outputs; before each [`Plant::step`].
    pub fn connect(&mut self, control: &SimulatedControl, memory: &[u8]) {
        if self.has_slaves {
            self.bus_outputs.0 = *control.bus_outputs();
        }
        if self.sees_volts {
            let start = ANALOG_OUTPUT as usize;
            let end = start + 8 * usize::from(ANALOG_CHANNELS);
            self.volts.take(memory.get(start..end).unwrap_or_default(), control.motion().outputs());
        }
    }

    /// What slaves and analogue inputs tell the control, and what is wrong on its buses; after each [`Plant::step`].
    pub fn tell(&self, control: &mut SimulatedControl) {
        if self.has_slaves {
            control.set_bus_inputs(&self.bus_inputs.0);
        }
        control.set_analog_inputs(&self.analog_inputs);
        control.set_bus_faults(&self.bus_faults);
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
        let mut image = [0; OUTPUT_PORTS + BUS_OUTPUTS];
        for fault in &self.faults {
            fault.act(&mut self.elements, &mut image);
        }
        let mut shorted = [0; OUTPUT_PORTS];
        shorted.copy_from_slice(&image[..OUTPUT_PORTS]);
        self.bus_faults = self.faults.iter().filter_map(Fault::on_bus).collect();
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
        technol_runtime::StateHash::of_shown(self)
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
