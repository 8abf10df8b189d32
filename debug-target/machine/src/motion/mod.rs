//! Axes, positioning units and spindles of the control (manual 8.1, 12, 15, 19 and 20).
//!
//! [`Motion`] is called once for each millisecond of the control and once for each instruction of the program that
//! concerns an axis; everything else goes through the interface cells. The instructions leave RLO and DR as they are,
//! so that none of the methods gives them back; what was refused is told for the log only, the program finds it in
//! its status record.

use alloc::vec::Vec;
use core::fmt;

use technol_image::system::motion as place;

pub mod config;

mod axis;
mod cells;
mod gate;
mod number;
mod publish;
mod ramp;
mod settings;
mod signals;
mod unit;
mod units;

pub use cells::Cells;
pub use number::Thousandths;
pub use unit::{PosControl, PosMode};

use axis::{Axis, Work};
use gate::Gate;
pub(crate) use settings::check;
use settings::AxisSettings;
use signals::{Signals, has, put};
use unit::Unit;

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
        })
    }
}

impl core::error::Error for Refused {}

/// The moving part of the control. Deterministic: what it does follows from its configuration, the calls and the cells.
#[derive(Clone, Debug)]
pub struct Motion {
    axes: Vec<Axis>,
    units: Vec<Unit>,
}

impl Motion {
    /// Axes at rest where their descriptions say; one that is not described has the usual values. Descriptions are
    /// checked with the machine ([`Plant::compile`](crate::Plant::compile)).
    #[must_use]
    pub fn new(axes: &[config::Axis]) -> Motion {
        let usual = config::Axis::default();
        let axis = |index: u8| {
            let described = axes.iter().find(|axis| axis.number == index + 1).unwrap_or(&usual);
            Axis::new(AxisSettings::new(described, index))
        };
        Motion { axes: (0..AXES as u8).map(axis).collect(), units: (0..AXES).map(|_| Unit::default()).collect() }
    }

    /// The PLC starts: all cells are written anew. With `cold` the axes are where they were at first, without
    /// reference; else they stay, and what the program had in hand is given back.
    pub fn start(&mut self, cells: &mut Cells<'_>, cold: bool) {
        for (index, axis) in self.axes.iter_mut().enumerate() {
            let work = Work::Free;
            *axis = if cold { Axis::new(axis.settings.clone()) } else { Axis { work, settled: false, ..axis.clone() } };
            axis.ramp.velocity = 0.0;
            publish::settings(cells, index, axis);
        }
        for unit in &mut self.units {
            *unit = Unit::default();
        }
    }

    /// One millisecond.
    pub fn tick_ms(&mut self, cells: &mut Cells<'_>) {
        let signals = Signals::read(cells);
        self.move_axes(cells, &signals);
        self.tell(cells, &signals);
    }

    fn move_axes(&mut self, cells: &mut Cells<'_>, signals: &Signals) {
        for index in 0..self.axes.len() {
            self.units[index].tick_pulse(cells);
            if self.axes[index].work == Work::Free && self.axes[index].settled {
                continue;
            }
            let gate = self.gate(index, signals);
            let (axis, unit) = (&mut self.axes[index], &mut self.units[index]);
            match axis.work {
                Work::Unit => unit.tick(cells, axis, &gate),
                _ => {}
            }
            if !axis.follow(has(signals.closed, index)) {
                unit.fail();
                cells.set_byte(place::ERROR_NUMBER, DIFFERENCE_ERROR);
                let mut homing = cells.word(place::HOMING);
                put(&mut homing, index, false);
                cells.set_word(place::HOMING, homing);
            }
            if axis.work == Work::Unit && !unit.held && axis.ramp.velocity == 0.0 {
                axis.work = Work::Free;
            }
            publish::position(cells, index, axis);
            for servo in axis.settings.servos.iter().copied() {
                publish::servo(cells, servo, axis, 0.0);
            }
            axis.settled = axis.rests();
        }
    }

    /// Limits of an axis in this tick.
    fn gate(&self, index: usize, signals: &Signals) -> Gate {
        Gate { stop: has(signals.limit_plus | signals.limit_minus, index), ..Gate::OPEN }
    }

    /// Bits that tell what the axes do.
    fn tell(&mut self, cells: &mut Cells<'_>, signals: &Signals) {
        let (mut requested, mut negative) = (0, cells.axes(place::NEGATIVE));
        for (index, axis) in self.axes.iter().enumerate() {
            let wants = axis.work == Work::Unit && self.units[index].wants_motion();
            put(&mut requested, index, wants || axis.ramp.velocity != 0.0);
            if axis.ramp.velocity != 0.0 {
                put(&mut negative, index, axis.ramp.velocity < 0.0);
            }
        }
        cells.set_axes(place::REQUESTED, requested);
        cells.set_axes(place::NEGATIVE, negative);
        let stopped = signals.limit_plus | signals.limit_minus;
        cells.set_six(place::ENABLED, signals.enable & signals.closed & !stopped);
    }

    /// POS_INIT: the program takes an axis (1 to 16); `space` is where it moves, 0 to 6, 5 when the instruction names
    /// none. POS_STV_ERR is set when it cannot be taken.
    pub fn pos_init(&mut self, cells: &mut Cells<'_>, axis: u8, space: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        let held = (0..AXES).filter(|&n| n != index && self.units[n].held).count();
        let refused = match self.axes[index].work {
            Work::Free | Work::Unit => match () {
                () if !cells.bit(place::LOOP_CLOSED.of(axis - 1)) => Some(Refused::LoopOpen),
                () if held >= HELD_AT_ONCE => Some(Refused::TooMany),
                () => None,
            },
            _ => Some(Refused::Busy),
        };
        if let Some(refused) = refused {
            self.units[index].error = true;
            return Err(refused);
        }
        self.units[index].init(cells, &self.axes[index], space);
        self.axes[index].work = Work::Unit;
        Ok(())
    }

    /// POS_RESET: the axis belongs to the NC again, as soon as it has stopped by its ramp.
    pub fn pos_reset(&mut self, cells: &mut Cells<'_>, axis: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        self.units[index].reset(cells);
        Ok(())
    }

    /// POS_MODE, in both forms: a motion is prepared. POS_STV_ERR is set when it cannot be.
    pub fn pos_mode(&mut self, cells: &mut Cells<'_>, axis: u8, mode: PosMode) -> Result<(), Refused> {
        let index = index(axis)?;
        if !self.units[index].held {
            self.units[index].error = true;
            return Err(Refused::NotHeld);
        }
        self.units[index].mode(cells, &self.axes[index], mode);
        if mode.accel == 0 { Err(Refused::NoRamp) } else { Ok(()) }
    }

    /// POS_CONTROL, in both forms: speed and enable go to the unit, its state to the status record.
    pub fn pos_control(&mut self, cells: &mut Cells<'_>, axis: u8, control: PosControl) -> Result<(), Refused> {
        let index = index(axis)?;
        self.units[index].control(cells, &self.axes[index], control);
        Ok(())
    }
}

/// The index of an axis of this number.
fn index(axis: u8) -> Result<usize, Refused> {
    if (1..=16).contains(&axis) { Ok(usize::from(axis - 1)) } else { Err(Refused::NoSuchAxis) }
}
