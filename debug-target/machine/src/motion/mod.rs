//! Axes, positioning units and spindles of the control (manual 8.1, 12, 15, 19 and 20).
//!
//! [`Motion`] is called once for each millisecond of the control and once for each instruction of the program that
//! concerns an axis; everything else goes through the interface cells. The instructions leave RLO and DR as they are,
//! so that none of the methods gives them back; what was refused is told for the log only, the program finds it in
//! its status record.
//!
//! A millisecond of control and machine is: [`Motion::tick_ms`], then
//! [`Plant::place_axes`](crate::Plant::place_axes) and [`Plant::step`](crate::Plant::step), then the program. So a switch
//! that an axis reaches is seen by the program in the same millisecond, and what the program wants moves in the next.

use alloc::vec::Vec;
use core::fmt;

use technol_image::system::motion as place;
use technol_runtime::BlockSpindle;

use crate::config::MachineConfig;

pub mod config;

mod axis;
mod cells;
mod cutting;
mod drive;
mod feed;
mod gate;
mod homing;
mod instructions;
mod jog;
mod number;
mod output;
mod panel;
mod path;
mod publish;
mod ramp;
mod run;
pub(crate) mod settings;
mod signals;
pub(crate) mod spindle;
pub(crate) mod switch;
mod unit;
mod units;
mod wheel;

pub use cells::Cells;
pub use homing::Request;
pub use instructions::SpiAx;
pub use jog::Direction;
pub use number::Thousandths;
pub use output::{Analog, PORTS, Role};
pub use panel::PanelKey;
pub use path::{BlockMove, BlockState, Hold};
pub use unit::{PosControl, PosMode};

use axis::{Axis, Work};
use cutting::Cutting;
use feed::Feed;
use jog::Jog;
use output::Outputs;
use path::Path;
use run::Run;
use settings::AxisSettings;
use signals::{Signals, put};
use spindle::Spindle;
use unit::Unit;
use wheel::Wheel;

/// Axes of the control.
pub const AXES: usize = 16;
/// Axes that the program may hold at once.
const HELD_AT_ONCE: usize = 6;
/// Number in BZH13 after a position error that was too great (this implementation).
pub const DIFFERENCE_ERROR: u8 = 1;

/// Why an instruction did nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// There is no axis of this number.
    NoSuchAxis,
    /// The position loop of the axis is open (VAZBA is 0).
    LoopOpen,
    /// The control moves the axis.
    Busy,
    /// The program holds six other axes.
    TooMany,
    /// The program has not taken the axis by POS_INIT.
    NotHeld,
    /// The ramp is zero.
    NoRamp,
    /// No output is chosen, or the axis does not work as spindle.
    NoOutput,
    /// There is no regulator set of this number.
    NoSuchSet,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Refused::NoSuchAxis => "there is no such axis; axes have the numbers 1 to 16",
            Refused::LoopOpen => "the position loop of the axis is open; set its VAZBA bit",
            Refused::Busy => "the control moves the axis; wait until its motion has ended",
            Refused::TooMany => "the program holds 6 axes already; give one back with POS_RESET",
            Refused::NotHeld => "the program does not hold the axis; take it with POS_INIT",
            Refused::NoRamp => "the ramp is 0; give an acceleration of 1 mm/s² or more",
            Refused::NoSuchSet => "there is no such regulator set; sets have the numbers 1 to 4",
            Refused::NoOutput => {
                "no output is chosen by ANALOG_PORT, or the axis does not work as spindle (AX_SPI)"
            }
        })
    }
}

impl core::error::Error for Refused {}

/// The moving part of the control. Deterministic: what it does follows from its configuration, the calls and the cells.
#[derive(Clone, Debug)]
pub struct Motion {
    axes: Vec<Axis>,
    units: Vec<Unit>,
    runs: Vec<Option<Run>>,
    jog: Jog,
    wheel: Wheel,
    path: Option<Path>,
    block: BlockState,
    hold: Hold,
    /// Axes of the last block, a bit an axis.
    arriving: u16,
    /// Axes whose reference the operator has asked for and that have not begun.
    wanted: u16,
    /// What the operator has asked for since the last tick.
    requests: Vec<Request>,
    outputs: Outputs,
    /// Spindles 1 and 2.
    spindles: [Spindle; 2],
    /// Which of them the machine describes.
    described: [bool; 2],
    cutting: Cutting,
    feed_percent: u8,
    speed_percent: u8,
    /// The cells of the configuration are written.
    announced: bool,
}

impl Default for Motion {
    /// The axes and spindles that no description tells of.
    fn default() -> Motion {
        Motion::new(&MachineConfig::default())
    }
}

impl Motion {
    /// Axes at rest where their descriptions say, spindles that stand; what is not described has the usual values.
    /// Descriptions are checked with the machine ([`Plant::compile`](crate::Plant::compile)).
    #[must_use]
    pub fn new(machine: &MachineConfig) -> Motion {
        let usual = config::Axis::default();
        let axis = |index: u8| {
            let described = machine.axis.iter().find(|axis| axis.number == index + 1).unwrap_or(&usual);
            Axis::new(AxisSettings::new(described, index))
        };
        let usual = config::Spindle::default();
        let spindle =
            |number: u8| Spindle::new(machine.spindle.iter().find(|s| s.number == number).unwrap_or(&usual));
        Motion {
            axes: (0..AXES as u8).map(axis).collect(),
            units: (0..AXES).map(|_| Unit::default()).collect(),
            runs: (0..AXES).map(|_| None).collect(),
            jog: Jog::default(),
            wheel: Wheel::default(),
            path: None,
            block: BlockState::None,
            hold: Hold::Go,
            arriving: 0,
            wanted: 0,
            requests: Vec::new(),
            outputs: Outputs::default(),
            spindles: [spindle(1), spindle(2)],
            described: [1, 2].map(|number| machine.spindle.iter().any(|spindle| spindle.number == number)),
            cutting: Cutting::default(),
            feed_percent: 100,
            speed_percent: 100,
            announced: false,
        }
    }

    /// Gears of a spindle (1 or 2) as the configuration of the control has them; those of the machine's description win.
    pub fn set_gears(&mut self, number: u8, gears: &[config::Gear], speed_limit: u32) {
        let index = usize::from(number).wrapping_sub(1);
        if let (Some(spindle), Some(false)) = (self.spindles.get_mut(index), self.described.get(index)) {
            spindle.set_gears(gears, speed_limit);
        }
    }

    /// The PLC starts: what the program had in hand is given back, and all cells are written anew with the next tick. With
    /// `cold` axes and spindles are as at first, without reference; else the axes stay where they are. Keys and overrides stay.
    pub fn start(&mut self, cold: bool) {
        self.stand_still();
        for axis in &mut self.axes {
            if cold {
                *axis = Axis::new(axis.settings.clone());
            }
            (axis.work, axis.settled) = (Work::Free, false);
        }
        self.units.iter_mut().for_each(|unit| *unit = Unit::default());
        self.runs.iter_mut().for_each(|run| *run = None);
        self.spindles.iter_mut().for_each(Spindle::reset);
        self.jog.end();
        self.wheel = Wheel::default();
        self.outputs = Outputs::default();
        (self.path, self.block, self.hold, self.wanted) = (None, BlockState::None, Hold::Go, 0);
        self.arriving = 0;
        self.cutting = Cutting::default();
        self.requests.clear();
        self.announced = false;
    }

    /// One millisecond, before the inputs of the program are read.
    pub fn tick_ms(&mut self, cells: &mut Cells<'_>) {
        if !self.announced {
            for (index, axis) in self.axes.iter().enumerate() {
                publish::settings(cells, index, axis);
            }
            self.announced = true;
        }
        self.answer(cells);
        let signals = Signals::read(cells);
        let feed = Feed::read(cells, self.feed_percent);
        self.assign(cells, &signals);
        self.move_block(&signals, &feed);
        self.move_axes(cells, &signals, &feed);
        self.cut(cells);
        for (nth, spindle) in self.spindles.iter_mut().enumerate() {
            let port = spindle.axis.or(spindle.port);
            let value = port.and_then(|port| self.outputs.values.get(port)).copied().unwrap_or(0);
            let cutting = if nth == 0 { self.cutting.output } else { None };
            spindle.tick(cells, nth == 0, value, self.speed_percent, cutting);
        }
        self.tell(cells, &signals);
        self.let_go();
    }

    /// A block of the part program takes its axes and requests their motion; they wait for
    /// [`release_block`](Motion::release_block). An axis that something else moves, or that the program holds, is
    /// [`Refused::Busy`]; then none is taken.
    pub fn begin_block(&mut self, cells: &mut Cells<'_>, block: &BlockMove) -> Result<(), Refused> {
        let taken = |(axis, way): (&Axis, &f64)| {
            *way != 0.0 && (axis.work != Work::Free || axis.ramp.velocity != 0.0)
        };
        if self.path.is_some() || self.axes.iter().zip(&block.travel).any(taken) {
            return Err(Refused::Busy);
        }
        self.path = Path::new(block, &self.axes);
        self.block = if self.path.is_some() { BlockState::Moving } else { BlockState::Done };
        let (mask, negative) = self.path.as_ref().map_or((0, 0), |path| (path.mask(), path.negative()));
        for (index, axis) in self.axes.iter_mut().enumerate() {
            if signals::has(mask, index) {
                axis.work = Work::Block;
            }
        }
        // MODULE_BLOCK_INIT runs before the next tick, and looks at them to unclamp axes.
        cells.set_axes(place::REQUESTED, cells.axes(place::REQUESTED) | mask);
        cells.set_axes(place::NEGATIVE, cells.axes(place::NEGATIVE) & !mask | negative);
        self.arriving = mask;
        Ok(())
    }

    /// The preparatory functions of the block are through: its axes may move.
    pub fn release_block(&mut self) {
        if let Some(path) = &mut self.path {
            path.release();
        }
    }

    /// How the last block stands.
    pub fn block(&self) -> BlockState {
        self.block
    }

    /// The last block is done and its axes are within their tolerance.
    pub fn arrived(&self) -> bool {
        let near = |(index, axis): (usize, &Axis)| !signals::has(self.arriving, index) || axis.in_tolerance();
        self.block == BlockState::Done && self.axes.iter().enumerate().all(near)
    }

    /// Milliseconds until the block reaches its target, at the speed of now.
    pub fn block_time_left(&self) -> u32 {
        self.path.as_ref().map_or(0, Path::millis_left)
    }

    /// How far an axis (1 to 16) is from a coordinate of the part program (POS0) in mm, in µm; 0 for no axis.
    pub fn way_to(&self, axis: u8, coordinate: f64) -> f64 {
        index(axis).map_or(0.0, |index| coordinate * units::UM - self.axes[index].coordinates[0])
    }

    /// Holds block and reference runs, or lets them go on; a hold ends the positioning of spindles. In an emergency stop
    /// manual movement stops, too.
    pub fn hold(&mut self, hold: Hold) {
        self.hold = hold;
    }

    /// Something waits for the end of a hold: a block or a reference run.
    pub fn is_held(&self) -> bool {
        self.hold != Hold::Go && (self.path.is_some() || self.runs.iter().any(Option::is_some))
    }

    /// A hold that nobody waits for ends by itself; one of an emergency stop not before everything stands and no key
    /// asks for manual movement.
    fn let_go(&mut self) {
        let emergency = self.hold == Hold::Emergency && (self.moves() || self.jog.moving() != 0);
        if self.hold != Hold::Go && !emergency && !self.is_held() {
            self.hold = Hold::Go;
        }
    }

    /// No axis has a position error above its tolerance.
    pub fn in_position(&self) -> bool {
        self.axes.iter().all(Axis::in_tolerance)
    }

    /// Some axis moves, spindles apart.
    pub fn moves(&self) -> bool {
        self.axes.iter().any(|axis| axis.ramp.velocity != 0.0 && axis.work != Work::Spindle)
    }

    /// A key of the panel for manual movement: `None` is released.
    pub fn jog_key(&mut self, axis: u8, direction: Option<Direction>) -> Result<(), Refused> {
        let index = index(axis)?;
        put(&mut self.jog.panel_plus, index, direction == Some(Direction::Plus));
        put(&mut self.jog.panel_minus, index, direction == Some(Direction::Minus));
        Ok(())
    }

    /// The key of the panel for rapid manual movement.
    pub fn jog_rapid(&mut self, on: bool) {
        self.jog.panel_rapid = on;
    }

    /// A key of the panel preselects an axis for the handwheel.
    pub fn select_key(&mut self, axis: u8) -> Result<(), Refused> {
        self.wheel.pressed = Some(index(axis)?);
        Ok(())
    }

    /// The handwheel has turned by some steps of KNOB_STEP µm. They move the preselected axis while manual movement is
    /// active, or shift it while ACT_ESHIFT is 1; otherwise they are lost.
    pub fn turn_wheel(&mut self, steps: i32) {
        self.wheel.steps = self.wheel.steps.saturating_add(steps);
    }

    /// Potentiometers of the panel, in per cent.
    pub fn set_overrides(&mut self, feed: u8, speed: u8) {
        (self.feed_percent, self.speed_percent) = (feed, speed);
    }

    /// A block says something about spindle 1: a programmed speed becomes PB11 and PB12, with M40 the gear follows the
    /// speed, and the constant cutting speed comes into force or ends.
    pub fn program_spindle(&mut self, cells: &mut Cells<'_>, block: &BlockSpindle) {
        self.cutting.program(block);
        self.spindles[0].program(cells, block);
    }

    /// A number that two of the same machine share when they go on the same way from here.
    pub fn state_hash(&self) -> u64 {
        technol_runtime::StateHash::of_shown(self)
    }

    /// Values of the analogue outputs; 7FFFh is 10 V.
    pub fn outputs(&self) -> &[i16; PORTS] {
        &self.outputs.values
    }

    /// Speed of a spindle (1 or 2) in rev/min, with sign.
    pub fn spindle_speed(&self, number: u8) -> f64 {
        self.spindles.get(usize::from(number).wrapping_sub(1)).map_or(0.0, |spindle| spindle.actual)
    }

    /// Where an axis (1 to 16) is in the machine's own coordinate, µm; `servo`: the side of one of its servo loops.
    pub fn place(&self, axis: u8, servo: Option<u8>) -> Option<f64> {
        let axis = &self.axes[index(axis).ok()?];
        let Some(servo) = servo else { return Some(axis.actual) };
        let nth = axis.settings.servos.iter().position(|own| own + 1 == servo)?;
        Some(axis.actual + axis.skew[nth])
    }
}

/// The index of an axis of this number.
fn index(axis: u8) -> Result<usize, Refused> {
    if (1..=16).contains(&axis) { Ok(usize::from(axis - 1)) } else { Err(Refused::NoSuchAxis) }
}
