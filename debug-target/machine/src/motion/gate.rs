//! What keeps an axis from going where it shall: limit switches, software limits, slow zones.

use super::axis::Axis;
use super::ramp::Goal;

/// Limits of one axis in this tick, in the machine's own coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gate {
    /// It must stand still: a limit switch is active.
    pub(crate) stop: bool,
    /// The greatest speed.
    pub(crate) speed: f64,
    /// The least position it may take.
    pub(crate) low: f64,
    /// The greatest.
    pub(crate) high: f64,
}

impl Gate {
    /// Nothing is in the way.
    pub(crate) const OPEN: Gate =
        Gate { stop: false, speed: f64::INFINITY, low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The goal that remains, its slope, and whether the way is cut short.
    pub(crate) fn apply(&self, goal: Goal, accel: f64, axis: &Axis) -> (Goal, f64, bool) {
        if self.stop {
            return (Goal::Velocity(0.0), axis.settings.emergency, true);
        }
        // Beyond a limit already, it may stay where it is.
        let here = axis.ramp.position;
        let (low, high) = (self.low.min(here), self.high.max(here));
        match goal {
            Goal::Position { target, speed, approach } => {
                let reachable = target.clamp(low, high);
                let speed = speed.min(self.speed);
                (Goal::Position { target: reachable, speed, approach }, accel, reachable != target)
            }
            Goal::Velocity(wanted) => {
                let speed = wanted.abs().min(self.speed);
                let end = if wanted < 0.0 { low } else { high };
                if wanted != 0.0 && end.is_finite() {
                    (Goal::Position { target: end, speed, approach: 0.0 }, accel, false)
                } else {
                    (Goal::Velocity(speed.copysign(wanted)), accel, false)
                }
            }
        }
    }
}
