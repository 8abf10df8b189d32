//! What `machine.toml` says, as plain data. Every signal is still a name; [`Plant::compile`](crate::Plant::compile)
//! checks them. Times are milliseconds.

use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use crate::block::BlockMode;
use crate::drive::Outputs;

pub use crate::control::config::{CanDrive, CanUnit, Kind, Licences, Object, Register, Serial, Slave};

/// A machine.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct MachineConfig {
    /// `[machine]`.
    pub machine: About,
    /// `[io]`.
    pub io: Io,
    /// `[[contact]]`.
    pub contact: Vec<Contact>,
    /// `[[limit]]`.
    pub limit: Vec<Limit>,
    /// `[[encoder]]`.
    pub encoder: Vec<Encoder>,
    /// `[[turret]]`.
    pub turret: Vec<Turret>,
    /// `[[key]]`.
    pub key: Vec<Key>,
    /// `[[fault]]`.
    pub fault: Vec<Fault>,
    /// `[[block]]`.
    pub block: Vec<Block>,
    /// `[licences]`.
    pub licences: Licences,
    /// `[[serial]]`.
    pub serial: Vec<Serial>,
    /// `[[can-unit]]`.
    pub can_unit: Vec<CanUnit>,
    /// `[[can-drive]]`.
    pub can_drive: Vec<CanDrive>,
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

/// A key of the operator panel, pressed by name.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Key {
    /// How it is called to be pressed.
    pub name: String,
    /// On while it is pressed.
    pub input: String,
    /// Off while it is pressed (a normally closed stop button).
    #[serde(default)]
    pub invert: bool,
}

/// Something that breaks, switched by name: a stuck input or a broken output.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Fault {
    /// How it is called to be switched.
    pub name: String,
    /// The input that is stuck…
    pub input: Option<String>,
    /// …at this value.
    pub stuck: Option<bool>,
    /// The output that no longer reaches the machine…
    pub output: Option<String>,
    /// …which is said by `broken = true`.
    pub broken: Option<bool>,
    /// Present from the start.
    #[serde(default)]
    pub active: bool,
}

/// A part-program block that the control starts. Without `at-cycle` and `on` it follows the block before it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
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
    /// How long its movement takes; 0: a block without movement.
    pub motion_ms: u32,
    /// Rapid traverse.
    pub rapid: bool,
    /// Mode of the start.
    pub mode: BlockMode,
}
