//! What `machine.toml` says, as plain data. Every signal is still a name; [`Plant::compile`](crate::Plant::compile)
//! checks them. Times are milliseconds.

use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use crate::block::{BlockFlag, BlockMode};
pub use crate::control::elements::config::{Input, Link, Number, Output, Value};
use crate::drive::{Outputs, Signals};
use crate::motion::config::{Axis, Spindle};
use crate::motion::{PanelKey, Thousandths};

pub use crate::control::config::{
    CanDrive, CanUnit, Kind, Licences, Master, Object, ProcessData, ProcessType, Register, Serial, Slave,
};

/// A machine.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct MachineConfig {
    /// `[machine]`.
    pub machine: About,
    /// `[io]`.
    pub io: Io,
    /// `[keep]`.
    pub keep: Kept,
    /// `[[contact]]`.
    pub contact: Vec<Contact>,
    /// `[[limit]]`.
    pub limit: Vec<Limit>,
    /// `[[encoder]]`.
    pub encoder: Vec<Encoder>,
    /// `[[turret]]`.
    pub turret: Vec<Turret>,
    /// `[[latch]]`.
    pub latch: Vec<Latch>,
    /// `[[counter]]`.
    pub counter: Vec<Counter>,
    /// `[[ramp]]`.
    pub ramp: Vec<Ramp>,
    /// `[[slide]]`.
    pub slide: Vec<Slide>,
    /// `[control]`.
    pub control: Control,
    /// `[[m-function]]`.
    pub m_function: Vec<MFunction>,
    /// `[[axis]]`.
    pub axis: Vec<Axis>,
    /// `[[spindle]]`.
    pub spindle: Vec<Spindle>,
    /// `[[key]]`.
    pub key: Vec<Key>,
    /// `[[fault]]`.
    pub fault: Vec<Fault>,
    /// `[[block]]`.
    pub block: Vec<Block>,
    /// `[[input]]`.
    pub input: Vec<Input>,
    /// `[[output]]`.
    pub output: Vec<Output>,
    /// `[[link]]`.
    pub link: Vec<Link>,
    /// `[licences]`.
    pub licences: Licences,
    /// `[[serial]]`.
    pub serial: Vec<Serial>,
    /// `[[can-unit]]`.
    pub can_unit: Vec<CanUnit>,
    /// `[[can-drive]]`.
    pub can_drive: Vec<CanDrive>,
    /// `[ethercat-master]`.
    pub ethercat_master: Master,
    /// `[[ethercat]]`.
    pub ethercat: Vec<Slave>,
}

/// About the machine.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct About {
    /// For people.
    pub name: String,
}

/// What is kept in files while nothing runs.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Kept {
    /// File of PLC_MEM_BACKUP, beside the machine file.
    pub backup: Option<String>,
    /// Changed PLC tables are written back to their files.
    pub tables: bool,
}

/// Which ports are copied each millisecond, and how fast the fastest module is.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Io {
    /// Input ports, for instance `P5IN`.
    pub fast_inputs: Vec<String>,
    /// Output ports, for instance `P3OUT`.
    pub fast_outputs: Vec<String>,
    /// Microseconds between the passes of MODULE_FASTEST; 1000 unless given.
    pub fastest_period_us: Option<u16>,
}

/// An output drives a feedback input after a delay: contactors, relays, valves with a pressure switch.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Contact {
    /// For people.
    #[serde(default)]
    pub name: String,
    /// Drives it.
    pub output: Outputs,
    /// Tells that it has switched.
    pub input: String,
    /// From the output going on to the input changing.
    #[serde(default)]
    pub on_delay_ms: u32,
    /// From the output going off to the input changing.
    #[serde(default)]
    pub off_delay_ms: u32,
    /// The input is off while the contact is on (a normally closed contact).
    #[serde(default)]
    pub invert: bool,
}

/// A moving element with a switch at one or both ends: doors, cylinders, chucks, tailstocks.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Limit {
    /// For people.
    #[serde(default)]
    pub name: String,
    /// Moves it from the start towards the end.
    pub output_forward: Outputs,
    /// Moves it back. Without: it returns by itself (a spring) when `output-forward` is off.
    pub output_backward: Option<Outputs>,
    /// From one end to the other.
    pub travel_ms: u32,
    /// Back again, if that takes another time.
    pub return_ms: Option<u32>,
    /// On while it is at the start.
    pub input_at_start: Option<String>,
    /// On while it is at the end.
    pub input_at_end: Option<String>,
    /// Where it is at first.
    #[serde(default)]
    pub initially: End,
}

/// An end of a travel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum End {
    /// Where `output-backward` leads.
    #[default]
    Start,
    /// Where `output-forward` leads.
    End,
}

/// Pulses and counts while an output is on: encoders, proximity switches on a cam wheel.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Encoder {
    /// For people.
    #[serde(default)]
    pub name: String,
    /// Turns it.
    pub output: Outputs,
    /// Pulses: on for the first half of each period.
    pub input: Option<String>,
    /// One pulse.
    pub period_ms: u32,
    /// Counts down while this output is on.
    pub direction: Option<Outputs>,
    /// Input ports that hold the count in binary, lowest byte first.
    #[serde(default)]
    pub position: Vec<String>,
}

/// A tool turret, or a chain magazine: stations pass by while the motor runs.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Turret {
    /// For people.
    #[serde(default)]
    pub name: String,
    /// How many, 2..=99.
    pub stations: u8,
    /// Turns it.
    pub motor: Outputs,
    /// Turns it the other way (instead of `motor`).
    pub motor_reverse: Option<Outputs>,
    /// From station to station.
    pub station_ms: u32,
    /// Inputs with the number of the station in BCD, lowest bit first: four, or up to eight, for two digits.
    #[serde(default)]
    pub code: Vec<String>,
    /// On while a station is in place.
    pub strobe: Option<String>,
    /// How long a passing station is in place; a quarter of `station-ms` unless given.
    pub strobe_ms: Option<u32>,
    /// The station in place at first.
    #[serde(default = "first_station")]
    pub initially: u8,
}

fn first_station() -> u8 {
    1
}

/// A relay that holds itself: set and reset.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Latch {
    /// For people, and for faults.
    #[serde(default)]
    pub name: String,
    /// Sets it.
    pub set: Signals,
    /// Resets it, even while it is being set.
    pub reset: Signals,
    /// On while it is set.
    pub input: String,
    /// The input is off while it is set.
    #[serde(default)]
    pub invert: bool,
    /// Set at first.
    #[serde(default)]
    pub initially: bool,
}

/// Counts pulses: parts, strokes, turns.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Counter {
    /// For people, and for faults.
    #[serde(default)]
    pub name: String,
    /// Each time one of these goes on.
    pub pulses: Signals,
    /// So many.
    pub count: u32,
    /// On once they have come.
    pub input: Option<String>,
    /// Begins anew while on. Without it the pulse after the last one begins anew.
    pub reset: Option<Signals>,
    /// Input ports that hold the count in binary, lowest byte first.
    #[serde(default)]
    pub value: Vec<String>,
}

/// An analog value: temperature, pressure, level, speed.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Ramp {
    /// For people, and for faults.
    #[serde(default)]
    pub name: String,
    /// Towards `high` while on, towards `low` while off…
    pub output: Option<Outputs>,
    /// …or towards the number in these output ports, lowest byte first, or the voltage of an analogue output.
    #[serde(default, deserialize_with = "crate::drive::names")]
    pub source: Vec<String>,
    /// Units for each volt of the source; 1 unless given.
    pub source_per_volt: Option<Thousandths>,
    /// Smallest value.
    #[serde(default)]
    pub low: u32,
    /// Largest value.
    pub high: u32,
    /// Units a second upwards.
    pub rise_per_s: Thousandths,
    /// Units a second downwards, if that is another speed.
    pub fall_per_s: Option<Thousandths>,
    /// At first; `low` unless given.
    pub initially: Option<u32>,
    /// Input ports that hold the value in binary, lowest byte first, or an analogue input that has its voltage.
    #[serde(default, deserialize_with = "crate::drive::names")]
    pub value: Vec<String>,
    /// Units for each volt of the analogue input; 1 unless given.
    pub value_per_volt: Option<Thousandths>,
    /// Switches.
    #[serde(default)]
    pub thresholds: Vec<Threshold>,
}

/// A switch of a [`Ramp`].
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Threshold {
    /// On from this value on.
    pub at: u32,
    /// Off again so far below it.
    #[serde(default)]
    pub hysteresis: u32,
    /// The switch.
    pub input: String,
    /// Off instead of on.
    #[serde(default)]
    pub invert: bool,
}

/// A driven axis without a position loop: loaders, quills, tailstocks, transfer slides.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Slide {
    /// For people, and for faults.
    #[serde(default)]
    pub name: String,
    /// Away from 0.
    pub forward: Outputs,
    /// Towards 0.
    pub backward: Outputs,
    /// At `rapid-mm-s` while on.
    pub rapid: Option<Outputs>,
    /// Speed.
    pub speed_mm_s: Thousandths,
    /// Speed in rapid.
    pub rapid_mm_s: Option<Thousandths>,
    /// Length of the way.
    pub stroke_mm: Thousandths,
    /// Where it is at first.
    #[serde(default)]
    pub initially_mm: Thousandths,
    /// Switches along the way.
    #[serde(default)]
    pub switches: Vec<Switch>,
    /// Input ports that hold the position in hundredths of a millimetre, lowest byte first.
    #[serde(default)]
    pub position: Vec<String>,
}

/// A switch of a [`Slide`]: on from `at` to `at + width`.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Switch {
    /// First position in mm.
    pub at: Thousandths,
    /// Length of its cam in mm.
    #[serde(default)]
    pub width: Thousandths,
    /// The switch.
    pub input: String,
    /// Off there instead of on.
    #[serde(default)]
    pub invert: bool,
}

/// Keys and settings of the control.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Control {
    /// START after a stop: the block or program goes on each time one of these goes on.
    pub start: Option<Signals>,
    /// STOP.
    pub stop: Option<Signals>,
    /// Emergency stop.
    pub emergency_stop: Option<Signals>,
    /// M01 stops.
    pub conditional_stop: bool,
    /// Local time at power-on: `2026-03-01 06:30:00`.
    pub clock: Option<String>,
    /// What local time is ahead of UTC, in minutes.
    pub utc_offset_min: i32,
}

/// An M function with a group of its own.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct MFunction {
    /// Which, 0..=99.
    pub number: u8,
    /// Its group, 1..=14.
    pub group: u8,
}

/// A key of the operator panel, pressed by name.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Key {
    /// How it is called to be pressed.
    pub name: String,
    /// On while it is pressed.
    pub input: Option<String>,
    /// PLC command that the control tells `_ON_CMD` when it is pressed and released.
    pub command: Option<i32>,
    /// What it does with axes and spindles.
    pub panel: Option<PanelKey>,
    /// Off while it is pressed (a normally closed stop button).
    #[serde(default)]
    pub invert: bool,
}

/// Something that breaks, switched by name: an input, an output or an element.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Fault {
    /// How it is called to be switched.
    pub name: String,
    /// The input that is `stuck` or `broken`…
    pub input: Option<String>,
    /// …or the output that is `broken` or `shorted`…
    pub output: Option<String>,
    /// …or the element, by its name, that is `stuck`, `jammed` or `slow`…
    pub element: Option<String>,
    /// …or the EtherCAT slave, by its name, that is `lost`, `cut` or has an `error`…
    pub slave: Option<String>,
    /// …or the CAN drive, by its axis, that is `lost` or has an `error`…
    pub can_drive: Option<u8>,
    /// …or the CAN channel that is `cut`.
    pub can: Option<u8>,
    /// It stays at this value.
    pub stuck: Option<bool>,
    /// The wire is broken: an input is off, an output does not reach the machine.
    pub broken: Option<bool>,
    /// The output has a short circuit.
    pub shorted: Option<bool>,
    /// The element does not move.
    pub jammed: Option<bool>,
    /// Everything the element does takes so many times as long.
    pub slow: Option<u32>,
    /// A slave or drive that nobody reaches.
    pub lost: Option<bool>,
    /// The cable is cut: in front of a slave, or of a CAN channel.
    pub cut: Option<bool>,
    /// The drive is in error, with this code.
    pub error: Option<u16>,
    /// Present from the start.
    #[serde(default)]
    pub active: bool,
}

/// A part-program block that the control starts. Without `at-cycle` and `on` it follows the block before it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Block {
    /// For people.
    pub name: String,
    /// In this 20 ms cycle after the start of the PLC.
    pub at_cycle: Option<u64>,
    /// Each time this signal goes on.
    pub on: Option<String>,
    /// M functions, 0..=99.
    pub m: Vec<u8>,
    /// Spindle value, 0..=32767.
    pub s: Option<u16>,
    /// Tool, at most eight digits.
    pub t: Option<u32>,
    /// H function, 0..=99.
    pub h: Option<u8>,
    /// How long its movement takes; 0: a block without movement, unless it has targets.
    pub motion_ms: u32,
    /// Rapid traverse.
    pub rapid: bool,
    /// Mode of the start.
    pub mode: BlockMode,
    /// Spindle speed in rev/min.
    pub speed: Option<f64>,
    /// Constant cutting speed in m/min, for blocks with its flag.
    pub cutting_speed: Option<f64>,
    /// Largest spindle speed at constant cutting speed in rev/min.
    pub speed_limit: Option<f64>,
    /// Feed in mm/min, or with `rev-feed` in mm/rev.
    pub feed: Option<f64>,
    /// Largest feed in mm/min.
    pub feed_max: Option<f64>,
    /// Length of the path in mm.
    pub length_mm: Option<f64>,
    /// Dwell.
    pub dwell: Option<f64>,
    /// Scale.
    pub scale: Option<f64>,
    /// Integer parameters for the PLC, at most five.
    pub integers: Vec<i32>,
    /// Real parameters for the PLC, at most five.
    pub reals: Vec<f64>,
    /// Targets in mm: NC axis, 0..=15, and position.
    pub axes: Vec<(u8, f64)>,
    /// Properties.
    pub flags: Vec<BlockFlag>,
}
