//! A reference run, or the positioning of a spindle to its zero pulse: from phase to phase (manual 12.4 and 15).

use super::axis::Axis;
use super::config::{AfterRef, RefSwitch};
use super::feed::Feed;
use super::gate::Gate;
use super::ramp::Goal;
use super::settings::AxisSettings;

/// How the reference mark is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    /// 5: coded scales; the position is known after two zero pulses.
    Coded,
    /// 9, and the positioning of spindles: the zero pulse behind the switch.
    Pulse,
    /// 10: reversal on the switch; the mark is where the switch goes off.
    Reversal,
    /// 11: the mark is where the switch goes on.
    Straight,
    /// 12, and 15 with `wait`: as 10 with a switch for each servo loop; with `wait` a loop that is on its switch stands
    /// until the others are.
    Level { wait: bool },
    /// 13: here.
    Here,
    /// 14: what the drive measures absolutely.
    Absolute,
}

impl Method {
    /// A method of the configuration that the control itself carries out.
    pub(crate) fn of(number: u8) -> Option<Method> {
        Some(match number {
            5 => Method::Coded,
            9 => Method::Pulse,
            10 => Method::Reversal,
            11 => Method::Straight,
            12 => Method::Level { wait: false },
            13 => Method::Here,
            14 => Method::Absolute,
            15 => Method::Level { wait: true },
            _ => return None,
        })
    }
}

/// What a run is to do; µm and s.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plan {
    pub(crate) method: Method,
    pub(crate) switch: RefSwitch,
    pub(crate) slow_down: bool,
    pub(crate) inverted: bool,
    pub(crate) speed: f64,
    pub(crate) speed_low: f64,
    pub(crate) accel: f64,
    pub(crate) after: AfterRef,
    pub(crate) position_after: f64,
    pub(crate) speed_after: f64,
    pub(crate) null_point: f64,
    pub(crate) override_counts: bool,
}

impl Plan {
    /// The reference run of an axis; `None` when the program makes it (method 1).
    pub(crate) fn reference(settings: &AxisSettings) -> Option<Plan> {
        let of = &settings.reference;
        Some(Plan {
            method: Method::of(of.method)?,
            switch: of.switch,
            slow_down: of.slow_down,
            inverted: of.inverted,
            speed: of.speed,
            speed_low: of.speed_low,
            accel: settings.acceleration_rapid,
            after: of.after,
            position_after: of.position_after,
            speed_after: of.speed,
            null_point: of.null_point,
            override_counts: of.override_counts,
        })
    }
}

/// Switches of the axis in this tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Switches {
    pub(crate) reference: bool,
    pub(crate) reversing: bool,
    pub(crate) slow_down: bool,
    /// Those of all servo loops.
    pub(crate) servos: u16,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// Towards the switch.
    Seek,
    /// Towards the zero pulse.
    Pulse,
    /// Back, off the switch.
    Leave,
    /// Down the ramp behind the mark.
    Stop,
    /// The movement after the reference.
    After,
    Done,
}

/// A run in progress.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) plan: Plan,
    /// It positions a spindle (SPI_AX).
    pub(crate) orients: bool,
    phase: Phase,
    /// 1 or -1.
    direction: f64,
    reversed: bool,
    slowed: bool,
    /// The reference switch has been seen off.
    seen_off: bool,
    pulses: u8,
    mark: f64,
    /// Servo loops of the axis that stand while the others move, a bit each.
    pub(crate) standing: u8,
}

impl Run {
    pub(crate) fn new(plan: Plan, orients: bool) -> Run {
        Run {
            direction: if plan.inverted { -1.0 } else { 1.0 },
            plan,
            orients,
            phase: Phase::Seek,
            reversed: false,
            slowed: false,
            seen_off: false,
            pulses: 0,
            mark: 0.0,
            standing: 0,
        }
    }

    /// One tick; `true` at the end, when the axis stands. `held`: it is to stand for the time being.
    pub(crate) fn tick(
        &mut self,
        axis: &mut Axis,
        now: Switches,
        gate: &Gate,
        feed: &Feed,
        held: bool,
    ) -> bool {
        let factor = if self.plan.override_counts { feed.factor } else { 1.0 };
        self.look(axis, now, self.plan.speed_low * factor);
        let speed = |speed: f64| if held { 0.0 } else { (speed * factor).min(axis.settings.rapid) };
        let goal = match self.phase {
            Phase::Seek if !self.slowed => Goal::Velocity(self.direction * speed(self.plan.speed)),
            Phase::Seek | Phase::Pulse | Phase::Leave => {
                Goal::Velocity(self.direction * speed(self.plan.speed_low))
            }
            Phase::Stop | Phase::Done => Goal::Velocity(0.0),
            Phase::After => {
                let target = self.target(axis);
                Goal::Position { target, speed: speed(self.plan.speed_after), approach: 0.0 }
            }
        };
        let (goal, accel, cut) = gate.apply(goal, self.plan.accel, axis);
        let reached = axis.advance(goal, accel, 0);
        match self.phase {
            Phase::Stop if axis.ramp.velocity == 0.0 => {
                self.phase = if self.plan.after == AfterRef::None { Phase::Done } else { Phase::After };
            }
            Phase::After if reached && !cut => self.phase = Phase::Done,
            _ => {}
        }
        self.phase == Phase::Done
    }

    /// What switches and zero pulses mean in this phase.
    fn look(&mut self, axis: &mut Axis, now: Switches, low: f64) {
        match self.phase {
            Phase::Seek => self.seek(axis, now),
            Phase::Pulse => {
                // A pulse on the ramp down from the speed of the run is not the one meant.
                let slow = axis.ramp.velocity.abs() <= low * 1.001;
                if let Some(pulse) = pulse_between(axis).filter(|_| slow) {
                    self.found(axis, pulse);
                }
            }
            Phase::Leave if axis.ramp.velocity * self.direction > 0.0 => {
                let off = match self.plan.method {
                    Method::Level { .. } => self.all_servos(axis, now, false),
                    _ => !now.reference,
                };
                if off {
                    self.found(axis, axis.actual);
                }
            }
            Phase::Leave | Phase::Stop | Phase::After | Phase::Done => {}
        }
    }

    fn seek(&mut self, axis: &mut Axis, now: Switches) {
        let hit = match self.plan.switch {
            RefSwitch::None => true,
            RefSwitch::Edge => self.seen_off && now.reference,
            RefSwitch::Level => now.reference,
        };
        self.seen_off |= !now.reference;
        self.slowed |= self.plan.slow_down && now.slow_down;
        match self.plan.method {
            Method::Pulse => {
                if now.reversing && !self.reversed {
                    (self.direction, self.reversed) = (-self.direction, true);
                }
                if hit {
                    self.phase = Phase::Pulse;
                }
            }
            Method::Reversal if hit => self.turn_back(),
            Method::Straight if hit => self.found(axis, axis.actual),
            Method::Level { wait } => {
                let all = self.all_servos(axis, now, true);
                if !wait {
                    self.standing = 0;
                }
                if all {
                    self.standing = 0;
                    self.turn_back();
                }
            }
            Method::Coded => {
                self.pulses += u8::from(pulse_between(axis).is_some());
                if self.pulses == 2 {
                    self.plan.null_point += axis.actual;
                    self.found(axis, axis.actual);
                }
            }
            Method::Here => self.found(axis, axis.ramp.position),
            Method::Absolute => {
                self.plan.null_point += self.direction * axis.ramp.position;
                self.found(axis, axis.ramp.position);
            }
            Method::Reversal | Method::Straight => {}
        }
    }

    fn turn_back(&mut self) {
        self.direction = -self.direction;
        self.phase = Phase::Leave;
    }

    /// Servo loops whose switch is as wanted stand; tells whether all of them do.
    fn all_servos(&mut self, axis: &Axis, now: Switches, wanted: bool) -> bool {
        let mut all = true;
        for (nth, servo) in axis.settings.servos.iter().enumerate() {
            let there = (now.servos >> servo & 1 != 0) == wanted;
            self.standing |= u8::from(there) << nth;
            all &= self.standing >> nth & 1 != 0;
        }
        all
    }

    /// The reference mark lies at this place of the machine.
    fn found(&mut self, axis: &mut Axis, mark: f64) {
        axis.set_zero(mark, self.plan.null_point);
        axis.level();
        self.mark = mark;
        self.standing = 0;
        self.phase = Phase::Stop;
    }

    fn target(&self, axis: &Axis) -> f64 {
        match self.plan.after {
            AfterRef::Absolute => axis.ramp.position + self.plan.position_after - axis.coordinates[6],
            AfterRef::Relative | AfterRef::None => self.mark + self.plan.position_after,
        }
    }
}

/// The zero pulse that the axis has passed in the last tick.
fn pulse_between(axis: &Axis) -> Option<f64> {
    let (distance, at) = (axis.settings.pulse_distance, axis.settings.pulse_at);
    let nth = |position: f64| {
        let number = (position - at) / distance;
        let whole = number as i64;
        if number < whole as f64 { whole - 1 } else { whole }
    };
    let (before, after) = (nth(axis.previous), nth(axis.actual));
    (before != after).then(|| at + before.max(after) as f64 * distance)
}
