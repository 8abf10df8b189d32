//! A millisecond of all axes.

use technol_image::system::motion as place;

use super::axis::Work;
use super::cells::Cells;
use super::config::JogEnable;
use super::feed::Feed;
use super::gate::{Gate, Ways};
use super::path::{BlockState, Hold, Path, Way};
use super::publish;
use super::ramp::{Goal, Ramp};
use super::run::Switches;
use super::signals::{Signals, has, put};
use super::{AXES, DIFFERENCE_ERROR, Motion};

/// Thousandths of a degree per second at one rev/min.
const TURN: f64 = 6000.0;

impl Motion {
    /// Who shall move what: manual movement takes axes that are free or that a held block leaves standing.
    pub(crate) fn assign(&mut self, cells: &mut Cells<'_>, signals: &Signals) {
        self.jog.tick(cells);
        self.wheel.tick(cells, &self.jog, &mut self.axes);
        self.begin_runs(cells);
        let block = self.path.as_ref().map_or(0, Path::mask);
        let held = self.hold != Hold::Go && self.path.as_ref().is_none_or(Path::stands);
        for index in 0..AXES {
            let by_hand = has(self.jog.moving() | self.wheel.moving(), index);
            let axis = &mut self.axes[index];
            axis.work = match axis.work {
                Work::Free if by_hand => Work::Jog,
                Work::Block if by_hand && held => Work::Jog,
                Work::Jog if !by_hand && axis.ramp.velocity == 0.0 => {
                    if has(block, index) {
                        Work::Block
                    } else {
                        Work::Free
                    }
                }
                work => work,
            };
            if axis.work == Work::Run && self.orientation_ends(index, signals) {
                self.break_off(cells, index);
            }
        }
    }

    /// SPI_AX ends early: by its POLOHV bit, by STOP, without enable, on a limit switch.
    fn orientation_ends(&self, index: usize, signals: &Signals) -> bool {
        let orients = self.runs[index].as_ref().is_some_and(|run| run.orients);
        let enabled = has(signals.enable, index) && self.enabled_by_hand(index, signals);
        let limit = has(signals.limit_plus | signals.limit_minus, index);
        orients && (!has(signals.orienting, index) || self.hold != Hold::Go || !enabled || limit)
    }

    fn enabled_by_hand(&self, index: usize, signals: &Signals) -> bool {
        match self.axes[index].settings.jog_enable {
            JogEnable::Program => has(signals.enable, index),
            JogEnable::Manual => has(signals.enable_manual, index),
        }
    }

    /// Moves the axes of the block along their path.
    pub(crate) fn move_block(&mut self, signals: &Signals, feed: &Feed) {
        let revolutions = self.main_revolutions();
        let Some(path) = &mut self.path else { return };
        let (mut hold, mut slow, mut room) = (self.hold, f64::INFINITY, f64::INFINITY);
        for (index, share, place) in path.places() {
            let axis = &self.axes[index];
            let gate = Gate::of(axis, index, signals, false);
            if gate.blocks(share) {
                hold = Hold::Emergency;
            } else if !has(signals.enable, index) && hold == Hold::Go {
                hold = Hold::Stop;
            }
            slow = slow.min(gate.greatest(share) / share.abs());
            room = room.min(gate.room(share, axis) / share.abs());
            let away = (axis.ramp.position - place).abs() > axis.settings.tolerance;
            if axis.work != Work::Block || away {
                // Moved by hand meanwhile: the way back is made by hand, too.
                return;
            }
        }
        if path.tick(&mut self.axes, feed, Way { hold, slow, room, revolutions }) {
            self.path = None;
            self.block = BlockState::Done;
            for axis in self.axes.iter_mut().filter(|axis| axis.work == Work::Block) {
                axis.work = Work::Free;
            }
        }
    }

    /// Moves every axis that does not rest, and lets the machine follow.
    pub(crate) fn move_axes(&mut self, cells: &mut Cells<'_>, signals: &Signals, feed: &Feed) {
        for index in 0..AXES {
            self.units[index].tick_pulse(cells);
            if self.axes[index].work == Work::Free && self.axes[index].settled {
                continue;
            }
            self.move_axis(cells, index, signals, feed);
            self.shift_axis(index, signals, feed);
            let axis = &mut self.axes[index];
            if !axis.follow(has(signals.closed, index)) {
                self.difference_too_great(cells, index);
            }
            let axis = &mut self.axes[index];
            publish::position(cells, index, axis);
            publish::servos(cells, axis);
            axis.settled = axis.rests();
        }
    }

    fn move_axis(&mut self, cells: &mut Cells<'_>, index: usize, signals: &Signals, feed: &Feed) {
        let gate = Gate::of(&self.axes[index], index, signals, self.axes[index].work == Work::Jog);
        match self.axes[index].work {
            Work::Free => {
                let axis = &mut self.axes[index];
                let accel = axis.settings.acceleration;
                axis.advance(Goal::Velocity(0.0), accel, 0);
            }
            Work::Unit => {
                let (axis, unit) = (&mut self.axes[index], &mut self.units[index]);
                unit.tick(cells, axis, &gate);
                if !unit.held && axis.ramp.velocity == 0.0 {
                    axis.work = Work::Free;
                }
            }
            Work::Jog => {
                let enabled = self.enabled_by_hand(index, signals);
                let revolutions = self.main_revolutions();
                let axis = &mut self.axes[index];
                let speed = self.jog.speed(cells, index, &axis.settings, feed, revolutions);
                let goal = match self.wheel.target.filter(|_| has(self.wheel.moving(), index)) {
                    Some(target) if !has(self.jog.moving(), index) => {
                        let speed = feed.rapid(axis.settings.rapid, axis.settings.rapid);
                        Goal::Position { target, speed: if enabled { speed } else { 0.0 }, approach: 0.0 }
                    }
                    _ => Goal::Velocity(if enabled { speed } else { 0.0 }),
                };
                let emergency = self.hold == Hold::Emergency;
                let goal = if emergency { Goal::Velocity(0.0) } else { goal };
                let accel = if emergency { axis.settings.emergency } else { axis.settings.acceleration };
                let (goal, accel, _) = gate.apply(goal, accel, axis);
                axis.advance(goal, accel, self.jog.space);
            }
            Work::Run => self.move_run(cells, index, signals, &gate, feed),
            Work::Spindle => {
                let turning = self.spindles.iter().find(|spindle| spindle.axis == Some(index));
                let velocity = turning.map_or(0.0, |spindle| spindle.actual * TURN);
                let axis = &mut self.axes[index];
                axis.ramp.velocity = velocity;
                axis.advance(Goal::Velocity(velocity), 0.0, 0);
                axis.actual = axis.ramp.position;
            }
            Work::Block => {}
        }
    }

    /// The independent shift of an axis goes on top of whatever moves it, except of runs and spindles.
    fn shift_axis(&mut self, index: usize, signals: &Signals, feed: &Feed) {
        let axis = &mut self.axes[index];
        axis.offset_step = 0.0;
        if !axis.may_shift() {
            axis.offset.velocity = 0.0;
            return;
        }
        let gate = Gate::of(axis, index, signals, false);
        super::wheel::shift(axis, feed, &gate);
        let step = axis.offset_step;
        if let Some(path) = self.path.as_mut() {
            path.shift(index, step);
        }
        self.units[index].shift(step);
    }

    fn move_run(&mut self, cells: &mut Cells<'_>, index: usize, signals: &Signals, gate: &Gate, feed: &Feed) {
        let hold = if self.hold == Hold::Go && !has(signals.enable, index) { Hold::Stop } else { self.hold };
        let now = Switches {
            reference: has(signals.reference_switch, index),
            reversing: has(signals.reversing_switch, index),
            slow_down: has(signals.slow_down_switch, index),
            servos: signals.servo_switch,
        };
        let Some(run) = &mut self.runs[index] else { return };
        let axis = &mut self.axes[index];
        let before = axis.ramp.position;
        let done = run.tick(axis, now, gate, feed, hold);
        axis.stand(run.standing, axis.ramp.position - before);
        if done {
            self.finish_run(cells, index);
        }
    }

    /// The counter is cleared, the reference dropped, the motion stopped and the error told.
    fn difference_too_great(&mut self, cells: &mut Cells<'_>, index: usize) {
        cells.set_byte(place::ERROR_NUMBER, DIFFERENCE_ERROR);
        super::homing::set(cells, place::HOMING, index, false);
        self.units[index].fail();
        self.break_off(cells, index);
        if self.axes[index].work == Work::Block {
            self.drop_block();
        }
    }

    /// Revolutions per second of the main spindle.
    fn main_revolutions(&self) -> f64 {
        let main = self.outputs.main.and_then(|axis| self.spindles.iter().find(|s| s.axis == Some(axis)));
        main.or(self.spindles.first()).map_or(0.0, |spindle| spindle.actual.abs() / 60.0)
    }

    /// Bits that tell what the axes do.
    pub(crate) fn tell(&self, cells: &mut Cells<'_>, signals: &Signals) {
        let (mut requested, mut negative) = (self.jog.moving(), cells.axes(place::NEGATIVE));
        requested |= self.path.as_ref().map_or(0, Path::mask);
        let none = Ways { plus: 0_u16, minus: 0 };
        let (mut at_limit, mut in_zone) = (none, none);
        for (index, axis) in self.axes.iter().enumerate() {
            let unit = axis.work == Work::Unit && self.units[index].wants_motion();
            let moves = axis.ramp.velocity != 0.0 && axis.work != Work::Spindle;
            let requests = unit || moves || axis.work == Work::Run || axis.shifts();
            requested |= u16::from(requests) << index;
            if axis.ramp.velocity != 0.0 {
                put(&mut negative, index, axis.ramp.velocity < 0.0);
            } else if has(self.jog.moving(), index) {
                // In manual movement the direction is told with the request, before anything moves.
                put(&mut negative, index, has(self.jog.minus, index));
            }
            if has(signals.soft_limits, index) {
                let gate = Gate::of(axis, index, signals, false);
                put(&mut at_limit.plus, index, gate.at_limit.plus);
                put(&mut at_limit.minus, index, gate.at_limit.minus);
                put(&mut in_zone.plus, index, gate.in_zone.plus);
                put(&mut in_zone.minus, index, gate.in_zone.minus);
            }
        }
        cells.set_axes(place::REQUESTED, requested);
        cells.set_axes(place::NEGATIVE, negative);
        let switches = signals.limit_plus | signals.limit_minus;
        let limits = at_limit.plus | at_limit.minus;
        cells.set_six(place::ENABLED, signals.enable & signals.closed & !switches & !limits);
        for (at, mask) in [
            (place::SOFT_LIMIT_PLUS, at_limit.plus),
            (place::SOFT_LIMIT_MINUS, at_limit.minus),
            (place::SOFT_SLOW_PLUS, in_zone.plus),
            (place::SOFT_SLOW_MINUS, in_zone.minus),
        ] {
            cells.set_byte(at, mask.to_le_bytes()[0] & 0x3F);
        }
        cells.set_bit(place::LIMIT_SWITCH, switches != 0);
        cells.set_bit(place::SOFT_LIMIT, limits != 0);
        cells.set_bit(place::AT_STOP_POINT, self.at_stop_point());
        cells.set_bit(place::STOP_POINT_LEFT, !self.at_stop_point());
        cells.set_byte(place::FEED_PERCENT, self.feed_percent);
    }

    /// A held block stands where it was stopped; without one there is no such point.
    fn at_stop_point(&self) -> bool {
        self.hold == Hold::Go
            || self.path.as_ref().is_none_or(|path| {
                path.places().all(|(index, _, place)| {
                    let axis = &self.axes[index];
                    (axis.ramp.position - place).abs() <= axis.settings.tolerance
                })
            })
    }

    /// The block is forgotten; its axes stop by their ramps.
    pub(crate) fn drop_block(&mut self) {
        if self.path.take().is_some() {
            self.block = BlockState::None;
        }
        for axis in self.axes.iter_mut().filter(|axis| axis.work == Work::Block) {
            axis.work = Work::Free;
        }
    }

    /// An axis stands where it is; used at the start of the PLC.
    pub(crate) fn stand_still(&mut self) {
        for axis in &mut self.axes {
            axis.ramp = Ramp { velocity: 0.0, ..axis.ramp };
        }
    }
}
