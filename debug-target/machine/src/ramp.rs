//! A value that follows its target no faster than it can: temperature, pressure, level, speed.

use alloc::format;
use alloc::vec::Vec;

use crate::analog::{self, AnalogInputs, AnalogOutput};
use crate::compile::Compiler;
use crate::config;
use crate::drive::{Drive, World};
use crate::motion::Thousandths;
use crate::signal::{InputBit, InputImage};

/// Where the target comes from.
#[derive(Clone, Debug)]
enum Source {
    /// `high` while an output is on, else `low`.
    Drive(Drive),
    /// The number in these bytes of the outputs, lowest first.
    Ports(Vec<u8>),
    /// A voltage, and millionths of the unit for each volt.
    Volts(AnalogOutput, f64),
}

#[derive(Clone, Debug)]
struct Threshold {
    on_from: i64,
    off_below: i64,
    input: InputBit,
    invert: bool,
    on: bool,
}

/// Values are millionths: a thousandth a second is one per millisecond.
#[derive(Clone, Debug)]
pub(crate) struct Ramp {
    source: Source,
    low: i64,
    high: i64,
    rise: i64,
    fall: i64,
    initially: i64,
    now: i64,
    value: Vec<u8>,
    /// The analogue input that holds the value, and millionths of the unit for each volt.
    input: Option<(u8, f64)>,
    thresholds: Vec<Threshold>,
}

const UNIT: i64 = 1_000_000;

impl Ramp {
    pub(crate) fn compile(config: &config::Ramp, compiler: &mut Compiler<'_>) -> Option<Ramp> {
        let source = source(config, compiler);
        if config.low >= config.high {
            compiler.error("high", "must be above `low`");
        }
        let fall = config.fall_per_s.unwrap_or(config.rise_per_s);
        for (key, speed) in [("rise-per-s", config.rise_per_s), ("fall-per-s", fall)] {
            if speed.0 <= 0 {
                compiler.error(key, "must be above 0");
            }
        }
        let initially = config.initially.unwrap_or(config.low);
        if !(config.low..=config.high).contains(&initially) {
            compiler.error("initially", "must lie between `low` and `high`");
        }
        let input = analog_input(config, compiler);
        let ports = if input.is_some() { &[][..] } else { &config.value };
        let value = compiler.driven_ports("value", ports, 4, u64::from(config.high));
        let mut thresholds = Vec::new();
        for threshold in &config.thresholds {
            let on_from = i64::from(threshold.at) * UNIT;
            let off_below = on_from - i64::from(threshold.hysteresis) * UNIT;
            if !(config.low..=config.high).contains(&threshold.at) {
                compiler.error("thresholds", "`at` must lie between `low` and `high`");
            }
            let input = compiler.driven("thresholds", &threshold.input);
            let invert = threshold.invert;
            thresholds.extend(input.map(|input| Threshold { on_from, off_below, input, invert, on: false }));
        }
        if config.value.is_empty() && config.thresholds.is_empty() {
            compiler.error("", "needs `thresholds` or `value`, else nothing can be seen of it");
        }
        let scaled = |value: u32| i64::from(value) * UNIT;
        let now = scaled(initially);
        Some(Ramp {
            source: source?,
            low: scaled(config.low),
            high: scaled(config.high),
            rise: config.rise_per_s.0,
            fall: fall.0,
            initially: now,
            now,
            value,
            input,
            thresholds,
        })
    }

    pub(crate) fn reset(&mut self) {
        self.now = self.initially;
        self.thresholds.iter_mut().for_each(|threshold| threshold.on = false);
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        if moves {
            let target = self.target(world);
            self.now = if target > self.now {
                self.now.saturating_add(self.rise).min(target)
            } else {
                self.now.saturating_sub(self.fall).max(target)
            };
        }
        for threshold in &mut self.thresholds {
            let from = if threshold.on { threshold.off_below } else { threshold.on_from };
            threshold.on = self.now >= from;
            threshold.input.set(inputs, threshold.on != threshold.invert);
        }
        for (port, byte) in self.value.iter().zip((self.now / UNIT).to_le_bytes()) {
            inputs[usize::from(*port)] = byte;
        }
    }

    /// Its voltage, when an analogue input holds it.
    pub(crate) fn show_volts(&self, volts: &mut AnalogInputs) {
        if let Some((channel, per_volt)) = self.input {
            volts.push((channel, self.now as f64 / per_volt));
        }
    }

    /// It looks at a voltage.
    pub(crate) fn sees_volts(&self) -> bool {
        matches!(self.source, Source::Volts(..))
    }

    fn target(&self, world: World<'_>) -> i64 {
        match &self.source {
            Source::Drive(drive) if drive.is_on(world.outputs) => self.high,
            Source::Drive(_) => self.low,
            Source::Ports(ports) => {
                let bytes = ports.iter().rev().map(|port| i64::from(world.outputs[usize::from(*port)]));
                let number = bytes.fold(0, |number, byte| number << 8 | byte);
                (number * UNIT).clamp(self.low, self.high)
            }
            Source::Volts(output, per_volt) => {
                ((world.volts.of(*output) * per_volt) as i64).clamp(self.low, self.high)
            }
        }
    }
}

fn source(config: &config::Ramp, compiler: &mut Compiler<'_>) -> Option<Source> {
    let per_volt = per_volt("source-per-volt", config.source_per_volt, compiler);
    match (&config.output, config.source.as_slice()) {
        (Some(names), []) => Some(Source::Drive(compiler.drive("output", names))),
        (None, [name]) if analog::is_meant(name) => {
            let Some(output) = analog::output(name) else {
                let message = format!(
                    "`{name}` is no analogue output; use ANALOG_OUTPUT_PHYSICAL[0] to [99] or ANALOG_PORT[1] to [16]"
                );
                compiler.error("source", message);
                return None;
            };
            Some(Source::Volts(output, per_volt))
        }
        (None, [_, ..]) => {
            let ports: Vec<u8> =
                config.source.iter().flat_map(|name| compiler.bytes("source", name, false)).collect();
            if ports.len() > 4 {
                compiler.error("source", "has more than 4 ports");
            }
            Some(Source::Ports(ports))
        }
        _ => {
            compiler.error("", "needs either `output` or `source`");
            None
        }
    }
}

/// The analogue input that is the value, and its measure.
fn analog_input(config: &config::Ramp, compiler: &mut Compiler<'_>) -> Option<(u8, f64)> {
    let per_volt = per_volt("value-per-volt", config.value_per_volt, compiler);
    let [name] = config.value.as_slice() else { return None };
    if !analog::is_meant(name) {
        return None;
    }
    let channel = analog::input(name);
    match channel {
        Some(channel) => compiler.claim_analog("value", channel),
        None => compiler
            .error("value", format!("`{name}` is no analogue input; use ANALOG_INPUT_PHYSICAL[0] to [99]")),
    }
    // One that does not exist was reported; it is no port either.
    Some((channel.unwrap_or(0), per_volt))
}

/// Millionths of the unit for a volt.
fn per_volt(key: &'static str, given: Option<Thousandths>, compiler: &mut Compiler<'_>) -> f64 {
    match given {
        None => UNIT as f64,
        Some(given) if given.0 > 0 => given.0 as f64 * 1000.0,
        Some(_) => {
            compiler.error(key, "must be above 0");
            UNIT as f64
        }
    }
}
