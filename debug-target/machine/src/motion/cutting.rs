//! Constant cutting speed: the spindle turns the faster, the nearer the tool is to the middle (manual 23.1).

use technol_image::op::Addr;
use technol_image::system::motion as place;
use technol_runtime::BlockSpindle;

use super::axis::Axis;
use super::cells::Cells;
use super::units::{UM, rounded_dword};
use super::{Motion, spindle};

/// A turn at the radius 1.
const TURN: f64 = core::f64::consts::TAU;
/// Parts of a micrometre in the cells of the radius.
const EIGHTHS: f64 = 8.0;
/// Space of the coordinate of the tool, and of the slide without its corrections.
const TOOL: usize = 0;
const SLIDE: usize = 5;

/// What is in force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cutting {
    /// G96 with this speed in mm/min.
    speed: Option<f64>,
    /// SLIM in rev/min; 0 for none.
    limit: f64,
    /// The value for the spindle, 0 to 7FFFh, and the greatest one; `None` while the programmed speed counts.
    pub(crate) output: Option<spindle::Cut>,
}

impl Cutting {
    /// A block says what counts from now on.
    pub(crate) fn program(&mut self, block: &BlockSpindle) {
        (self.speed, self.limit) = (block.cutting_speed, block.speed_limit);
    }
}

impl Motion {
    /// A tick: the speed for where the axis is.
    pub(crate) fn cut(&mut self, cells: &mut Cells<'_>) {
        let active = self.cutting.speed.is_some() || cells.bit(place::CUTTING_REQ);
        if !active {
            if self.cutting.output.take().is_some() {
                (0..9).for_each(|nth| cells.set_dword(place::CUTTING_SPEED_ACT + 4 * nth, 0));
            }
            return;
        }
        let given = |bit, at: Addr, own: f64| if cells.bit(bit) { f64::from(cells.dword(at)) } else { own };
        let thousandths = |bit, at, own: f64| given(bit, at, own * UM);
        let gear = self.spindles[0].gear(cells, true);
        let speed =
            given(place::CUTTING_SPEED_GIVEN, place::CUTTING_SPEED, self.cutting.speed.unwrap_or(0.0));
        let limit = thousandths(place::CUTTING_LIMIT_GIVEN, place::CUTTING_LIMIT, self.cutting.limit);
        let distance = given(place::CUTTING_DISTANCE_GIVEN, place::CUTTING_DISTANCE, 0.0);
        let correction = given(place::CUTTING_CORRECTION_GIVEN, place::CUTTING_CORRECTION, 0.0);
        let own = self.radius(cells);
        let radius = given(place::CUTTING_RADIUS_GIVEN, place::CUTTING_RADIUS, own);
        let greatest = thousandths(place::CUTTING_GEAR_GIVEN, place::CUTTING_GEAR_SPEED, gear.max_speed);
        let range = given(place::CUTTING_RANGE_GIVEN, place::CUTTING_RANGE, gear.max_output);
        let cut = turn((speed + correction).max(0.0), (radius + distance).abs(), greatest, limit);
        let share = |speed: f64| if greatest > 0.0 { speed / greatest * range } else { 0.0 };
        let most = if limit > 0.0 { greatest.min(limit) } else { greatest };
        self.cutting.output = Some(spindle::Cut { value: share(cut), most: share(most) });
        let told = [speed, limit, distance, correction, radius, greatest, range, cut, share(cut)];
        for (nth, value) in (0..).zip(told) {
            cells.set_dword(place::CUTTING_SPEED_ACT + 4 * nth, rounded_dword(value));
        }
    }

    /// The radius at which the tool cuts, in 1/8 µm.
    fn radius(&self, cells: &Cells<'_>) -> f64 {
        let space = if cells.bit(place::CUTTING_FROM_SLIDE) { SLIDE } else { TOOL };
        self.axes
            .get(self.spindles[0].cutting_axis)
            .map_or(0.0, |axis: &Axis| axis.coordinates[space] * EIGHTHS)
    }
}

/// Speed in 1/1000 rev/min for a cutting speed in mm/min at a radius in 1/8 µm: no faster than the gear, nor than the limit
/// unless that is 0.
fn turn(speed: f64, radius: f64, gear: f64, limit: f64) -> f64 {
    let most = if limit > 0.0 { gear.min(limit) } else { gear };
    let radius = radius / (EIGHTHS * UM);
    // In the middle nothing can turn fast enough.
    if speed <= 0.0 { 0.0 } else { (speed / (TURN * radius) * UM).min(most) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_is_that_of_the_circumference() {
        // m/min, mm, rev/min of the gear and of the limit, rev/min by v / (2 π r).
        for (speed, radius, gear, limit, expected) in [
            (90.0, 150.0, 3000.0, 0.0, 95.493),
            (90.0, 25.0, 3000.0, 1000.0, 572.958),
            (90.0, 10.0, 3000.0, 1000.0, 1000.0),
            (90.0, 10.0, 3000.0, 0.0, 1432.394),
            (90.0, 1.0, 3000.0, 0.0, 3000.0),
            (90.0, 0.0, 3000.0, 0.0, 3000.0),
            (0.0, 0.0, 3000.0, 0.0, 0.0),
        ] {
            let found = turn(speed * UM, radius * UM * EIGHTHS, gear * UM, limit * UM) / UM;
            assert!((found - expected).abs() < 0.001, "{speed} m/min at {radius} mm: {found}");
        }
    }
}
