//! What the program says about the axes in this tick: masks with X in bit 0.

use technol_image::system::motion as place;

use super::cells::Cells;

/// Bits of the program for all axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Signals {
    pub(crate) enable: u16,
    pub(crate) enable_manual: u16,
    pub(crate) closed: u16,
    pub(crate) orienting: u16,
    pub(crate) reference_switch: u16,
    pub(crate) reversing_switch: u16,
    pub(crate) slow_down_switch: u16,
    pub(crate) limit_plus: u16,
    pub(crate) limit_minus: u16,
    pub(crate) slow_limit: u16,
    /// Software limits that count: switched on, and the reference is valid.
    pub(crate) soft_limits: u16,
    /// Reference switches of the servo loops.
    pub(crate) servo_switch: u16,
}

impl Signals {
    pub(crate) fn read(cells: &Cells<'_>) -> Signals {
        Signals {
            enable: cells.axes(place::ENABLE),
            enable_manual: cells.axes(place::ENABLE_MANUAL),
            closed: cells.axes(place::LOOP_CLOSED),
            orienting: cells.axes(place::ORIENTING),
            reference_switch: cells.axes(place::REFERENCE_SWITCH),
            reversing_switch: cells.axes(place::REVERSING_SWITCH),
            slow_down_switch: cells.axes(place::SLOW_DOWN_SWITCH),
            limit_plus: cells.axes(place::LIMIT_PLUS),
            limit_minus: cells.axes(place::LIMIT_MINUS),
            slow_limit: cells.axes(place::SLOW_LIMIT_PLUS) | cells.axes(place::SLOW_LIMIT_MINUS),
            soft_limits: cells.word(place::SLS_REFER) & cells.word(place::HOMING),
            servo_switch: cells.word(place::SERVO_SWITCH.addr),
        }
    }
}

/// Whether a mask has the bit of an axis.
pub(crate) fn has(mask: u16, axis: usize) -> bool {
    mask >> axis & 1 != 0
}

/// Writes the bit of an axis into a mask.
pub(crate) fn put(mask: &mut u16, axis: usize, value: bool) {
    *mask = *mask & !(1 << axis) | u16::from(value) << axis;
}
