//! The handwheel: it jogs the preselected axis, or shifts it independently of the path (manual 20.2 and 20.3).

use technol_image::system::motion as place;

use super::axis::{Axis, Work};
use super::cells::Cells;
use super::feed::Feed;
use super::gate::Gate;
use super::jog::Jog;
use super::ramp::{Goal, Ramp};
use super::signals::has;

/// Axes that may be shifted independently.
const SHIFTED: usize = 6;
/// The space in which the independent shift shows, and those behind it.
const SPACE: usize = 5;

/// What turns and what it means.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wheel {
    /// Steps since the last tick.
    pub(crate) steps: i32,
    /// Index of the preselected axis.
    pub(crate) selected: Option<usize>,
    /// A key of preselection has been pressed and not looked at.
    pub(crate) pressed: Option<usize>,
    /// Where the wheel leads the preselected axis in manual movement, in the machine's own coordinate.
    pub(crate) target: Option<f64>,
}

impl Wheel {
    /// Preselection and steps of this tick.
    pub(crate) fn tick(&mut self, cells: &mut Cells<'_>, jog: &Jog, axes: &mut [Axis]) {
        self.select(cells, jog);
        let way = f64::from(core::mem::take(&mut self.steps)) * f64::from(cells.word(place::WHEEL_STEP));
        let mode = cells.bit(place::OFFSET_MODE);
        let shifts = mode && cells.bit(place::OFFSET_ACTIVE);
        let allowed = u16::from(cells.byte(place::OFFSET_ALLOWED));
        let shifted = self.selected.filter(|&axis| shifts && axis < SHIFTED && has(allowed, axis));
        cells.set_byte(place::OFFSET_AXIS, shifted.map_or(0, |axis| 1 << axis));
        for axis in axes.iter_mut().take(SHIFTED).filter(|_| !mode) {
            // Without the mode the axes go back to their places.
            axis.set_offset(0.0);
        }
        if let Some(axis) = shifted {
            let to = axes[axis].offset_target + way;
            axes[axis].set_offset(to);
        }
        let jogged = self.selected.filter(|&axis| jog.active && !shifts && !has(jog.moving(), axis));
        match jogged.map(|axis| &axes[axis]) {
            Some(axis) if way != 0.0 => {
                let from = self.target.unwrap_or(axis.ramp.position);
                self.target = Some(from + way);
            }
            Some(axis) if axis.work == Work::Jog && axis.ramp.velocity == 0.0 => {
                self.target = self.target.filter(|target| (target - axis.ramp.position).abs() > 0.0);
            }
            Some(_) => {}
            None => self.target = None,
        }
    }

    /// An axis is preselected by its key, by the program, or by a jog key unless AUTMAN_WHEEL_DIS says otherwise.
    fn select(&mut self, cells: &Cells<'_>, jog: &Jog) {
        let before = self.selected;
        if let Some(axis) = self.pressed.take() {
            let off = cells.bit(place::WHEEL_TOGGLE) && before == Some(axis);
            self.selected = Some(axis).filter(|_| !off);
        } else if jog.selecting != 0 {
            self.selected = Some(jog.selecting.trailing_zeros() as usize);
        } else if jog.from_panel && jog.moving() != 0 && !cells.bit(place::NO_WHEEL) {
            self.selected = Some(jog.moving().trailing_zeros() as usize);
        }
        if self.selected != before {
            self.target = None;
        }
    }

    /// The axis that the wheel shall move, a bit an axis.
    pub(crate) fn moving(&self) -> u16 {
        self.selected.filter(|_| self.target.is_some()).map_or(0, |axis| 1 << axis)
    }
}

/// Moves the offset of an axis, and the axis with it.
pub(crate) fn shift(axis: &mut Axis, feed: &Feed, gate: &Gate) {
    let way = axis.offset_target - axis.offset.position;
    if way == 0.0 && axis.offset.velocity == 0.0 {
        return;
    }
    let speed = if gate.blocks(way) { 0.0 } else { feed.working(axis.settings.feed, axis.settings.rapid) };
    let before = axis.offset.position;
    let goal = Goal::Position { target: axis.offset_target, speed, approach: 0.0 };
    axis.offset.tick(goal, axis.settings.acceleration);
    let step = axis.offset.position - before;
    axis.ramp = Ramp { position: axis.ramp.position + step, ..axis.ramp };
    axis.shift(step, SPACE);
    axis.offset_step = step;
}
