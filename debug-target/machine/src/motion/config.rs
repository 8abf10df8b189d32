//! What `machine.toml` says about axes and spindles. Lengths are millimetres or degrees, speeds mm/min, accelerations
//! mm/s²; names of signals are checked with the rest of the machine.

use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use super::number::Thousandths;

const fn mm(value: i32) -> Thousandths {
    Thousandths::whole(value)
}

/// `[[axis]]`: an axis of the control and the machine part it moves. What is not said has the value it has for the
/// axes that are not described.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Axis {
    /// For people.
    pub name: String,
    /// Number of the axis, 1 (X) to 16.
    pub number: u8,
    /// Where it stands at power-on, in the machine's own coordinate.
    pub start: Thousandths,
    /// Manual feed.
    pub feed: Thousandths,
    /// Rapid traverse, and the greatest feed.
    pub feed_rapid: Thousandths,
    /// Feed on a slow-down limit switch and in the zone before a software limit.
    pub feed_slow: Thousandths,
    /// Ramp of feed, manual movement and positioning to the zero pulse.
    pub acceleration: Thousandths,
    /// Ramp of rapid traverse and of reference runs.
    pub acceleration_rapid: Thousandths,
    /// Ramp on a limit switch and in an emergency stop.
    pub acceleration_emergency: Thousandths,
    /// Gain of the position loop in 1/s: the position error is speed / gain.
    pub gain: u32,
    /// Gains of the regulator sets 1 to 4 (REGUL_X …), where they differ from `gain`.
    pub gains: Vec<u32>,
    /// Greatest position error; 0 does not check it.
    pub difference_limit: Thousandths,
    /// Position error up to which the axis counts as in position.
    pub tolerance: Thousandths,
    /// Increments of the drive per millimetre.
    pub increments: u32,
    /// Software limit in positive direction.
    pub limit_plus: Option<Thousandths>,
    /// Software limit in negative direction.
    pub limit_minus: Option<Thousandths>,
    /// Zone before a software limit in which the feed is `feed-slow`.
    pub limit_zone: Thousandths,
    /// Distance of the zero pulses of its encoder.
    pub pulse_distance: Thousandths,
    /// One of them, in the machine's own coordinate.
    pub pulse_at: Thousandths,
    /// Which bits let it move in manual movement.
    pub jog_enable: JogEnable,
    /// Numbers of the servo loops that move it; its own number when empty.
    pub servos: Vec<u8>,
    /// Method of the reference run: 1, 5, or 9 to 15.
    pub ref_method: u8,
    /// Single references always go through the program.
    pub ref_via_plc: bool,
    /// How the reference switch is tested.
    pub ref_switch: RefSwitch,
    /// The slow-down switch is tested.
    pub slow_down_switch: bool,
    /// The run goes in negative direction.
    pub invert_ref_direction: bool,
    /// Speed of the run.
    pub ref_speed: Thousandths,
    /// Speed behind the switch or the reversal.
    pub ref_speed_low: Thousandths,
    /// Movement after the reference.
    pub after_ref: AfterRef,
    /// Where to, or how far.
    pub pos_after_ref: Thousandths,
    /// Coordinate of the reference mark.
    pub machine_null_point: Thousandths,
    /// The feed override counts in the run.
    pub ref_override: bool,
    /// Switches at positions of the axis.
    pub switch: Vec<Switch>,
}

impl Default for Axis {
    fn default() -> Self {
        Axis {
            name: String::new(),
            number: 0,
            start: mm(0),
            feed: mm(2000),
            feed_rapid: mm(10_000),
            feed_slow: mm(500),
            acceleration: mm(500),
            acceleration_rapid: mm(1000),
            acceleration_emergency: mm(2000),
            gain: 400,
            gains: Vec::new(),
            difference_limit: mm(1),
            tolerance: Thousandths(20),
            increments: 1000,
            limit_plus: None,
            limit_minus: None,
            limit_zone: mm(0),
            pulse_distance: mm(10),
            pulse_at: mm(0),
            jog_enable: JogEnable::Program,
            servos: Vec::new(),
            ref_method: 9,
            ref_via_plc: false,
            ref_switch: RefSwitch::Edge,
            slow_down_switch: false,
            invert_ref_direction: false,
            ref_speed: mm(10_000),
            ref_speed_low: mm(50),
            after_ref: AfterRef::None,
            pos_after_ref: mm(0),
            machine_null_point: mm(0),
            ref_override: true,
            switch: Vec::new(),
        }
    }
}

/// Bits that enable manual movement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum JogEnable {
    /// MPXPI … as for every movement.
    #[default]
    Program,
    /// MPXMAN ….
    Manual,
}

/// How the reference switch KRX … is tested.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RefSwitch {
    /// Not at all.
    None,
    /// It must go on during the run.
    #[default]
    Edge,
    /// It must be on.
    Level,
}

/// The movement after the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AfterRef {
    /// None.
    #[default]
    None,
    /// By `pos-after-ref` from the mark.
    Relative,
    /// To the coordinate `pos-after-ref`.
    Absolute,
}

/// A switch that is on between two positions of an axis.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Switch {
    /// The input it drives.
    pub input: String,
    /// On from here, in the machine's own coordinate; without it from anywhere.
    pub from: Option<Thousandths>,
    /// Up to here; without it to anywhere.
    pub to: Option<Thousandths>,
    /// Servo loop (one of those of the axis) on whose side it is; without it that of the axis as a whole.
    pub servo: Option<u8>,
    /// It is off there and on elsewhere.
    #[serde(default)]
    pub invert: bool,
}

/// `[[spindle]]`: a spindle of the control.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Spindle {
    /// For people.
    pub name: String,
    /// 1 or 2.
    pub number: u8,
    /// Greatest programmed speed in rev/min; 0: that of the highest gear.
    pub speed_limit: u32,
    /// How fast its motor changes speed, rev/min per second.
    pub acceleration: u32,
    /// Analogue output (1 to 16) whose value drives it.
    pub port: Option<u8>,
    /// Rotary axis (1 to 16) that works as this spindle.
    pub axis: Option<u8>,
    /// Axis (1 to 16) whose coordinate is the radius for a constant cutting speed.
    pub cutting_axis: u8,
    /// It has an encoder; without one its speed is what the program writes to SIM_SPEED_PT.
    pub encoder: bool,
    /// Gears, the lowest first; at least one.
    pub gear: Vec<Gear>,
}

impl Default for Spindle {
    fn default() -> Self {
        Spindle {
            name: String::new(),
            number: 1,
            speed_limit: 0,
            acceleration: 1000,
            port: None,
            axis: None,
            cutting_axis: 1,
            encoder: true,
            gear: Vec::new(),
        }
    }
}

/// A gear of a spindle.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Gear {
    /// Greatest speed in rev/min.
    pub max_speed: u32,
    /// Output value of that speed, 1 to 32767 (10 V).
    #[serde(default = "full_output")]
    pub max_output: u16,
}

fn full_output() -> u16 {
    0x7FFF
}
