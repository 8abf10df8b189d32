//! What the control tells the program about its axes.

use technol_image::op::Addr;
use technol_image::system::motion as place;

use super::axis::Axis;
use super::cells::Cells;
use super::units::{FRACTION, TICK, rounded, rounded_dword};

/// Position cells of one axis; `index` is 0 for X.
pub(crate) fn position(cells: &mut Cells<'_>, index: usize, axis: &Axis) {
    let nth = index as Addr;
    if index < 6 {
        cells.set_dword(place::POSITION_OLD + 4 * nth, rounded_dword(axis.coordinates[0] * 8.0));
        cells.set_dword(place::INCREMENT_OLD + 4 * nth, 0);
    }
    cells.set_qword(place::POSITION + 8 * nth, rounded(axis.coordinates[0] * FRACTION));
    for (space, coordinate) in axis.coordinates[1..6].iter().enumerate() {
        let at = place::POSITION_POS1 + 128 * space as Addr + 8 * nth;
        cells.set_qword(at, rounded(coordinate * FRACTION));
    }
    cells.set_dword(place::DIFFERENCE + 4 * nth, rounded_dword(axis.error()));
}

/// Position cells of the servo loops of an axis.
pub(crate) fn servos(cells: &mut Cells<'_>, axis: &Axis) {
    for (nth, servo) in axis.settings.servos.iter().enumerate() {
        let at = 4 * Addr::from(*servo);
        let requested = axis.coordinates[6] + axis.ahead(nth);
        cells.set_dword(place::SERVO_REQUESTED + at, rounded_dword(requested));
        cells.set_dword(place::SERVO_MEASURED + at, rounded_dword(requested - axis.error()));
        let increments = (axis.actual + axis.skew[nth]) * axis.settings.increments;
        cells.set_dword(place::SERVO_INCREMENTS + at, rounded_dword(increments));
    }
}

/// What the configuration says of an axis: 1/65536 µm and milliseconds.
pub(crate) fn settings(cells: &mut Cells<'_>, index: usize, axis: &Axis) {
    let nth = 4 * index as Addr;
    let of = &axis.settings;
    for (at, acceleration) in [
        (place::ACCELERATION, of.acceleration),
        (place::ACCELERATION_RAPID, of.acceleration_rapid),
        (place::ACCELERATION_EMERGENCY, of.emergency),
    ] {
        cells.set_dword(at + nth, rounded_dword(acceleration * TICK * TICK * FRACTION));
    }
    cells.set_dword(place::FEED + nth, rounded_dword(of.feed * TICK * FRACTION));
    cells.set_dword(place::FEED_RAPID + nth, rounded_dword(of.rapid * TICK * FRACTION));
}
