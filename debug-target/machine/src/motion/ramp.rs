//! How a position follows a demand: by linear ramps, a tick of 1 ms at a time.

use technol_runtime::root;

use super::units::TICK;

/// Closer than this the target is reached: 1 nm.
const NEAR: f64 = 0.001;
/// How long the final approach lasts before the last ramp, in seconds (this implementation).
const APPROACH_TIME: f64 = 0.1;

/// A position and its speed. Micrometres and seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Ramp {
    pub(crate) position: f64,
    /// With sign.
    pub(crate) velocity: f64,
}

/// Where a ramp shall lead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Goal {
    /// This speed, with sign.
    Velocity(f64),
    /// This position, no faster than `speed`, which is 0 for a pause.
    Position {
        target: f64,
        speed: f64,
        /// Speed of the final approach; 0 for none.
        approach: f64,
    },
}

impl Ramp {
    /// One tick with this slope, at least 0. Tells whether the target is reached; it stands then.
    pub(crate) fn tick(&mut self, goal: Goal, accel: f64) -> bool {
        match goal {
            Goal::Velocity(wanted) => {
                self.velocity = toward(self.velocity, wanted, accel * TICK);
                self.position += self.velocity * TICK;
                false
            }
            Goal::Position { target, speed, approach } => self.tick_to(target, speed, approach, accel),
        }
    }

    fn tick_to(&mut self, target: f64, speed: f64, approach: f64, accel: f64) -> bool {
        let rest = target - self.position;
        let sign = if rest < 0.0 { -1.0 } else { 1.0 };
        let rest = rest.abs();
        let change = accel * TICK;
        let allowed = allowed(rest, accel).min(before_approach(rest, approach, accel));
        // Speed towards the target; negative while it still moves away, and above what is allowed only when the
        // target came too late to stop there: then it runs past and comes back.
        let speed = toward(self.velocity * sign, speed.min(allowed), change);
        let stops = speed <= allowed + 2.0 * change && speed >= -2.0 * change;
        if stops && (rest < NEAR || speed * TICK >= rest) {
            *self = Ramp { position: target, velocity: 0.0 };
            return true;
        }
        self.velocity = speed * sign;
        self.position += self.velocity * TICK;
        false
    }
}

/// `value` nearer to `wanted` by at most `change`.
fn toward(value: f64, wanted: f64, change: f64) -> f64 {
    value + (wanted - value).clamp(-change, change)
}

/// The greatest speed from which the ramp still stops within `rest`, this tick included.
fn allowed(rest: f64, accel: f64) -> f64 {
    let half = accel * TICK / 2.0;
    root(half * half + 2.0 * accel * rest) - half
}

/// The greatest speed from which the ramp still reaches the speed of the approach in time.
fn before_approach(rest: f64, approach: f64, accel: f64) -> f64 {
    if approach <= 0.0 || accel <= 0.0 {
        return f64::INFINITY;
    }
    let way = approach * APPROACH_TIME + approach * approach / (2.0 * accel);
    if rest <= way {
        return approach;
    }
    let half = accel * TICK / 2.0;
    root(half * half + approach * approach + 2.0 * accel * (rest - way)) - half
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // exact results are what is tested
mod tests {
    use super::*;

    #[test]
    fn a_ramp_to_a_speed_changes_it_evenly() {
        let mut ramp = Ramp::default();
        for tick in 1..=10 {
            ramp.tick(Goal::Velocity(-800.0), 100_000.0);
            assert_eq!(ramp.velocity, -100.0 * f64::from(tick.min(8)));
        }
    }

    #[test]
    fn a_target_that_comes_too_late_is_passed_and_then_reached_from_the_other_side() {
        let mut ramp = Ramp { position: 0.0, velocity: 100_000.0 };
        let goal = Goal::Position { target: 100.0, speed: 50_000.0, approach: 0.0 };
        let mut farthest: f64 = 0.0;
        let ticks = (1..10_000).find(|_| {
            let reached = ramp.tick(goal, 1_000_000.0);
            farthest = farthest.max(ramp.position);
            reached
        });
        assert!(ticks.is_some());
        assert!((4900.0..=5000.0).contains(&farthest), "stops after v²/2a: {farthest}");
        assert_eq!(ramp, Ramp { position: 100.0, velocity: 0.0 });
    }

    #[test]
    fn the_last_way_is_covered_at_the_speed_of_the_approach() {
        let mut ramp = Ramp::default();
        let goal = Goal::Position { target: 50_000.0, speed: 100_000.0, approach: 1000.0 };
        let (mut slow, mut reached) = (0, false);
        for _ in 0..2000 {
            reached = reached || ramp.tick(goal, 500_000.0);
            slow += u32::from(!reached && ramp.position > 25_000.0 && ramp.velocity <= 1001.0);
        }
        assert!(reached);
        assert!((100..=104).contains(&slow), "{slow}");
    }
}
