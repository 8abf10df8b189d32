//! The positioning unit of an axis (manual 19).

use technol_image::op::{Addr, BitRef};

use super::axis::Axis;
use super::cells::Cells;
use super::gate::Gate;
use super::ramp::Goal;
use super::units::{UM, per_minute, unit_feed};

/// How long POS_CNT_RESET stays on: one cycle of the program (this implementation).
const RESET_PULSE: u8 = 20;

/// Bits of the control record, in its second byte.
const CNT_MP: u8 = 0;
const CNT_RESET: u8 = 1;
const CNT_INIC: u8 = 2;
const CNT_CONT: u8 = 3;

/// Operands of POS_MODE, as the instruction finds them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PosMode {
    /// First byte of the control record.
    pub control: Addr,
    /// Travel from the present position in µm, with sign.
    pub length: i32,
    /// Slope of both ramps in mm/s².
    pub accel: u16,
    /// Speed of the final approach in mm/min; 0 is none. Only the older form has it.
    pub approach: u16,
}

/// Operands of POS_CONTROL, as the instruction finds them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PosControl {
    /// First byte of the status record.
    pub status: Addr,
    /// Demanded speed in 1/65536 mm/min; a negative one counts as positive.
    pub feed: i32,
    /// Motion enable for POS_CNT_MP; `None` leaves it.
    pub mp: Option<bool>,
}

/// A programmed motion.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Travel {
    /// In the machine's own coordinate.
    target: f64,
    approach: f64,
}

/// The unit of one axis.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unit {
    /// POS_STV_DISP: the program has the axis.
    pub(crate) held: bool,
    /// POS_STV_ERR.
    pub(crate) error: bool,
    /// Where the axis moves, 0 to 6.
    space: usize,
    travel: Option<Travel>,
    /// Slope of the motion in progress, µm/s².
    accel: f64,
    /// POS_MODE was executed; the next tick takes it over.
    initiate: bool,
    /// POS_STV_PROG.
    programmed: bool,
    /// POS_STV_POL.
    reached: bool,
    /// POS_STV_SMER.
    negative: bool,
    /// Demanded speed, µm/s.
    feed: f64,
    control: Option<Addr>,
    reset_pulse: u8,
}

impl Unit {
    /// POS_INIT.
    pub(crate) fn init(&mut self, cells: &mut Cells<'_>, axis: &Axis, space: u8) {
        let accel = if self.accel > 0.0 { self.accel } else { axis.settings.acceleration };
        self.pulse_reset(cells);
        *self = Unit {
            held: true,
            space: usize::from(space.min(6)),
            accel,
            control: self.control,
            reset_pulse: self.reset_pulse,
            ..Unit::default()
        };
    }

    /// POS_RESET. A motion first stops by its ramp.
    pub(crate) fn reset(&mut self, cells: &mut Cells<'_>) {
        self.pulse_reset(cells);
        self.travel = None;
        (self.held, self.error, self.programmed, self.reached) = (false, false, false, false);
        (self.initiate, self.feed) = (false, 0.0);
    }

    /// POS_MODE of an axis that the program has; without a ramp nothing is programmed.
    pub(crate) fn mode(&mut self, cells: &mut Cells<'_>, axis: &Axis, mode: PosMode) {
        if mode.accel == 0 {
            self.error = true;
            return;
        }
        let target = axis.ramp.position + f64::from(mode.length);
        self.travel = Some(Travel { target, approach: per_minute(f64::from(mode.approach)) });
        self.accel = f64::from(mode.accel) * UM;
        self.negative = mode.length < 0;
        (self.error, self.programmed, self.reached) = (false, false, false);
        (self.initiate, self.feed) = (true, 0.0);
        self.finish_pulse(cells);
        self.control = Some(mode.control);
        self.set_control(cells, CNT_INIC, true);
    }

    /// POS_CONTROL; `velocity` is that of the axis.
    pub(crate) fn control(&mut self, cells: &mut Cells<'_>, axis: &Axis, control: PosControl) {
        self.feed = unit_feed(control.feed);
        if let Some(mp) = control.mp {
            self.set_control(cells, CNT_MP, mp);
        }
        let moves = self.held && axis.ramp.velocity != 0.0;
        let first = u8::from(moves) | u8::from(self.negative) << 1 | u8::from(self.reached) << 3;
        let second = u8::from(self.held) | u8::from(self.programmed) << 1 | u8::from(self.error) << 2;
        cells.set_byte(control.status, first);
        cells.set_byte(control.status.saturating_add(1), second);
    }

    /// One tick of an axis that the unit moves.
    pub(crate) fn tick(&mut self, cells: &mut Cells<'_>, axis: &mut Axis, gate: &Gate) {
        if self.initiate {
            self.initiate = false;
            self.programmed = true;
            self.set_control(cells, CNT_INIC, false);
            self.set_control(cells, CNT_CONT, true);
        }
        let goal = match self.travel.filter(|_| !self.reached) {
            Some(Travel { target, approach }) => {
                let speed = if self.enabled(cells) { self.feed } else { 0.0 };
                Goal::Position { target, speed, approach }
            }
            None => Goal::Velocity(0.0),
        };
        let (goal, accel, cut) = gate.apply(goal, self.accel, axis);
        if axis.advance(goal, accel, self.space) && !cut {
            self.reached = true;
            self.set_control(cells, CNT_CONT, false);
        }
    }

    /// The end of the pulse on POS_CNT_RESET, a tick at a time.
    pub(crate) fn tick_pulse(&mut self, cells: &mut Cells<'_>) {
        if self.reset_pulse > 0 {
            self.reset_pulse -= 1;
            if self.reset_pulse == 0 {
                self.set_control(cells, CNT_RESET, false);
            }
        }
    }

    /// A motion is programmed and not finished.
    pub(crate) fn wants_motion(&self) -> bool {
        self.travel.is_some() && !self.reached
    }

    /// The axis was stopped by an error of its servo loop; the motion is lost.
    pub(crate) fn fail(&mut self) {
        self.travel = None;
        (self.error, self.programmed) = (true, false);
    }

    fn enabled(&self, cells: &Cells<'_>) -> bool {
        self.control.is_some_and(|at| cells.bit(second(at, CNT_MP)))
    }

    fn set_control(&self, cells: &mut Cells<'_>, bit: u8, value: bool) {
        if let Some(at) = self.control {
            cells.set_bit(second(at, bit), value);
        }
    }

    /// The record is known from the last POS_MODE; before it there is none to pulse in.
    fn pulse_reset(&mut self, cells: &mut Cells<'_>) {
        if self.control.is_some() {
            self.set_control(cells, CNT_RESET, true);
            self.set_control(cells, CNT_INIC, false);
            self.set_control(cells, CNT_CONT, false);
            self.reset_pulse = RESET_PULSE;
        }
    }

    fn finish_pulse(&mut self, cells: &mut Cells<'_>) {
        if self.reset_pulse > 0 {
            self.reset_pulse = 1;
            self.tick_pulse(cells);
        }
    }
}

/// A bit in the second byte of a record.
fn second(record: Addr, bit: u8) -> BitRef {
    BitRef { addr: record.saturating_add(1), bit, indexed: false }
}
