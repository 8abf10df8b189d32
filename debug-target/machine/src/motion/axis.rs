//! An axis: what is demanded of it, where it is, and where it is said to be.

use super::ramp::{Goal, Ramp};
use super::settings::AxisSettings;
use super::units::TICK;

/// Spaces of coordinates: POS0, behind interpolation, to POS6, the machine.
pub(crate) const SPACES: usize = 7;
/// Servo loops that an axis may have.
pub(crate) const SERVOS: usize = 4;
/// A position error smaller than this has gone: 0.01 µm.
const SETTLED: f64 = 0.01;

/// Who moves an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Work {
    /// Nobody; it is at the disposal of the NC.
    #[default]
    Free,
    /// Its positioning unit.
    Unit,
    /// Manual movement.
    Jog,
    /// A block of the part program.
    Block,
    /// A reference run, or positioning to the zero pulse.
    Run,
    /// The program, as a spindle.
    Spindle,
}

/// One axis; micrometres and seconds.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) settings: AxisSettings,
    /// What is demanded, in the machine's own coordinate: that in which its switches lie.
    pub(crate) ramp: Ramp,
    /// Where it is, in the machine's own coordinate.
    pub(crate) actual: f64,
    /// Where it was a tick ago.
    pub(crate) previous: f64,
    /// The demanded position in each space, as the control knows it.
    pub(crate) coordinates: [f64; SPACES],
    pub(crate) work: Work,
    /// Regulator set in force, from 0.
    pub(crate) set: usize,
    /// The independent shift by the handwheel, and where it shall lead.
    pub(crate) offset: Ramp,
    pub(crate) offset_target: f64,
    /// What it has moved the axis in this tick.
    pub(crate) offset_step: f64,
    /// How far each of its servo loops is ahead of it in the machine…
    pub(crate) skew: [f64; SERVOS],
    /// …and how far it was when they were levelled.
    level: [f64; SERVOS],
    /// Its cells hold what it is, and nothing changes any more.
    pub(crate) settled: bool,
}

impl Axis {
    pub(crate) fn new(settings: AxisSettings) -> Axis {
        let ramp = Ramp { position: settings.start, velocity: 0.0 };
        Axis {
            actual: ramp.position,
            previous: ramp.position,
            ramp,
            settings,
            coordinates: [0.0; SPACES],
            work: Work::Free,
            set: 0,
            offset: Ramp::default(),
            offset_target: 0.0,
            offset_step: 0.0,
            skew: [0.0; SERVOS],
            level: [0.0; SERVOS],
            settled: false,
        }
    }

    /// One tick towards a goal; the position changes in `space` and those behind it.
    pub(crate) fn advance(&mut self, goal: Goal, accel: f64, space: usize) -> bool {
        let before = self.ramp.position;
        let reached = self.ramp.tick(goal, accel);
        self.shift(self.ramp.position - before, space);
        reached
    }

    /// The demand is elsewhere by `way`.
    pub(crate) fn shift(&mut self, way: f64, space: usize) {
        for coordinate in &mut self.coordinates[space.min(SPACES - 1)..] {
            *coordinate += way;
        }
    }

    /// The independent shift shall become `target`.
    pub(crate) fn set_offset(&mut self, target: f64) {
        if self.offset_target.to_bits() != target.to_bits() {
            self.offset_target = target;
            self.settled = false;
        }
    }

    /// The coordinate of the place `machine` becomes `value` in every space; no shift is left between them.
    pub(crate) fn set_zero(&mut self, machine: f64, value: f64) {
        (self.offset, self.offset_target) = (Ramp::default(), 0.0);
        self.coordinates = [value + self.ramp.position - machine; SPACES];
        self.settled = false;
    }

    /// These servo loops (a bit each) do not take part in the last movement of the axis.
    pub(crate) fn stand(&mut self, loops: u8, way: f64) {
        for (nth, skew) in self.skew.iter_mut().enumerate() {
            if loops >> nth & 1 != 0 {
                *skew -= way;
            }
        }
    }

    /// Its servo loops count as level where they are.
    pub(crate) fn level(&mut self) {
        self.level = self.skew;
    }

    /// How far a servo loop is ahead, as the control knows it.
    pub(crate) fn ahead(&self, nth: usize) -> f64 {
        self.skew[nth] - self.level[nth]
    }

    /// The difference counter.
    pub(crate) fn error(&self) -> f64 {
        self.ramp.position - self.actual
    }

    /// The position loop: the machine follows the demand while the loop is closed. `false`: the difference is too
    /// great, the counter was cleared and the demand is where the machine is.
    pub(crate) fn follow(&mut self, closed: bool) -> bool {
        self.previous = self.actual;
        if closed {
            self.actual += self.error() * (self.settings.gains[self.set] * TICK);
            if self.error().abs() < SETTLED {
                self.actual = self.ramp.position;
            }
        }
        let limit = self.settings.difference_limit;
        if limit <= 0.0 || self.error().abs() <= limit {
            return true;
        }
        let error = self.error();
        self.shift(-error, 0);
        self.ramp = Ramp { position: self.actual, velocity: 0.0 };
        false
    }

    /// It stands where it is demanded to be.
    pub(crate) fn rests(&self) -> bool {
        self.ramp.velocity == 0.0 && self.offset.velocity == 0.0 && self.error() == 0.0 && !self.shifts()
    }

    /// The independent shift is not where it shall be. That of a spindle or of a run waits until they are done.
    pub(crate) fn shifts(&self) -> bool {
        self.may_shift() && self.offset.position.to_bits() != self.offset_target.to_bits()
    }

    /// Runs and spindles bear no independent shift beside them.
    pub(crate) fn may_shift(&self) -> bool {
        !matches!(self.work, Work::Run | Work::Spindle)
    }

    /// The position error is within the tolerance.
    pub(crate) fn in_tolerance(&self) -> bool {
        self.error().abs() <= self.settings.tolerance
    }
}
