//! What keeps an axis from going where it shall: limit switches, software limits, slow zones.

use super::axis::Axis;
use super::ramp::Goal;
use super::signals::{Signals, has};

/// Closer than this to a software limit, it is reached: 1 µm.
const AT_LIMIT: f64 = 1.0;

/// A value for the positive and one for the negative direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ways<T> {
    pub(crate) plus: T,
    pub(crate) minus: T,
}

/// Limits of one axis in this tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gate {
    /// A limit switch is in the way: it must not move there.
    pub(crate) stop: Ways<bool>,
    /// The greatest speeds.
    speed: Ways<f64>,
    /// The positions it may take, in the machine's own coordinate.
    low: f64,
    high: f64,
    /// Software limits that are reached.
    pub(crate) at_limit: Ways<bool>,
    /// It is in the zone before one.
    pub(crate) in_zone: Ways<bool>,
}

impl Gate {
    /// Limits of the axis with this index. By hand it may leave a limit switch; otherwise it stands on one, whatever
    /// the direction.
    pub(crate) fn of(axis: &Axis, index: usize, signals: &Signals, by_hand: bool) -> Gate {
        let settings = &axis.settings;
        let switches = Ways { plus: has(signals.limit_plus, index), minus: has(signals.limit_minus, index) };
        let any = switches.plus || switches.minus;
        let stop = if by_hand { switches } else { Ways { plus: any, minus: any } };
        let slow = if has(signals.slow_limit, index) { settings.slow } else { f64::INFINITY };
        let no = Ways { plus: false, minus: false };
        let mut gate = Gate {
            stop,
            speed: Ways { plus: slow, minus: slow },
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            at_limit: no,
            in_zone: no,
        };
        if has(signals.soft_limits, index) {
            let here = axis.coordinates[6];
            let (above, below) = (here - settings.limit_minus, settings.limit_plus - here);
            gate.low = axis.ramp.position - above;
            gate.high = axis.ramp.position + below;
            gate.at_limit = Ways { plus: below < AT_LIMIT, minus: above < AT_LIMIT };
            let zone = settings.limit_zone;
            gate.in_zone = Ways { plus: zone > 0.0 && below < zone, minus: zone > 0.0 && above < zone };
            if gate.in_zone.plus {
                gate.speed.plus = settings.slow;
            }
            if gate.in_zone.minus {
                gate.speed.minus = settings.slow;
            }
        }
        gate
    }

    /// The goal that remains, its slope, and whether the way is cut short.
    pub(crate) fn apply(&self, goal: Goal, accel: f64, axis: &Axis) -> (Goal, f64, bool) {
        let (here, velocity) = (axis.ramp.position, axis.ramp.velocity);
        let way = match goal {
            Goal::Position { target, .. } => target - here,
            Goal::Velocity(wanted) => wanted,
        };
        let into = |velocity: f64| velocity > 0.0 && self.stop.plus || velocity < 0.0 && self.stop.minus;
        if into(way) || into(velocity) {
            return (Goal::Velocity(0.0), axis.settings.emergency, true);
        }
        // Beyond a limit already, it may stay where it is.
        let (low, high) = (self.low.min(here), self.high.max(here));
        let (greatest, end) = if way < 0.0 { (self.speed.minus, low) } else { (self.speed.plus, high) };
        match goal {
            Goal::Position { target, speed, approach } => {
                let cut = !(low..=high).contains(&target);
                let target = target.clamp(low, high);
                (Goal::Position { target, speed: speed.min(greatest), approach }, accel, cut)
            }
            Goal::Velocity(wanted) if wanted != 0.0 && end.is_finite() => {
                let speed = wanted.abs().min(greatest);
                (Goal::Position { target: end, speed, approach: 0.0 }, accel, true)
            }
            Goal::Velocity(wanted) => (Goal::Velocity(wanted.clamp(-greatest, greatest)), accel, false),
        }
    }

    /// Whether a movement in the direction of `way` must stop here.
    pub(crate) fn blocks(&self, way: f64) -> bool {
        let (stop, limit) = if way < 0.0 {
            (self.stop.minus, self.at_limit.minus)
        } else {
            (self.stop.plus, self.at_limit.plus)
        };
        way != 0.0 && (stop || limit)
    }

    /// How far it is to the software limit in the direction of `way`.
    pub(crate) fn room(&self, way: f64, axis: &Axis) -> f64 {
        if way < 0.0 { axis.ramp.position - self.low } else { self.high - axis.ramp.position }
    }

    /// The greatest speed in the direction of `way`.
    pub(crate) fn greatest(&self, way: f64) -> f64 {
        if way < 0.0 { self.speed.minus } else { self.speed.plus }
    }
}
