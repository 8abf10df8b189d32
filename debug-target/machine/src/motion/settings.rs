//! An axis as its description says, in the units of the model.

use alloc::format;
use alloc::vec::Vec;

use super::axis::SERVOS;
use super::config::{self, AfterRef, JogEnable, RefSwitch};
use super::number::Thousandths;
use super::units::{UM, per_minute};
use crate::compile::Compiler;

/// Settings of an axis; micrometres and seconds.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AxisSettings {
    pub(crate) start: f64,
    pub(crate) feed: f64,
    pub(crate) rapid: f64,
    pub(crate) slow: f64,
    pub(crate) acceleration: f64,
    pub(crate) acceleration_rapid: f64,
    pub(crate) emergency: f64,
    /// 1/s.
    pub(crate) gain: f64,
    pub(crate) difference_limit: f64,
    pub(crate) tolerance: f64,
    /// Increments per µm.
    pub(crate) increments: f64,
    pub(crate) limit_plus: f64,
    pub(crate) limit_minus: f64,
    pub(crate) limit_zone: f64,
    pub(crate) pulse_distance: f64,
    pub(crate) pulse_at: f64,
    pub(crate) jog_enable: JogEnable,
    /// Indices of its servo loops.
    pub(crate) servos: Vec<u8>,
    pub(crate) reference: RefSettings,
}

/// Settings of the reference run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RefSettings {
    pub(crate) method: u8,
    pub(crate) via_plc: bool,
    pub(crate) switch: RefSwitch,
    pub(crate) slow_down: bool,
    pub(crate) inverted: bool,
    pub(crate) speed: f64,
    pub(crate) speed_low: f64,
    pub(crate) after: AfterRef,
    pub(crate) position_after: f64,
    pub(crate) null_point: f64,
    pub(crate) override_counts: bool,
}

/// What is wrong with one axis.
pub(crate) fn check(axis: &config::Axis, earlier: &[config::Axis], compiler: &mut Compiler<'_>) {
    if !(1..=16).contains(&axis.number) {
        compiler.error("number", "must be 1 (X) to 16");
    } else if earlier.iter().any(|other| other.number == axis.number) {
        compiler.error("number", format!("axis {} is described twice", axis.number));
    }
    for (key, value) in [
        ("feed", axis.feed),
        ("feed-rapid", axis.feed_rapid),
        ("feed-slow", axis.feed_slow),
        ("acceleration", axis.acceleration),
        ("acceleration-rapid", axis.acceleration_rapid),
        ("acceleration-emergency", axis.acceleration_emergency),
        ("tolerance", axis.tolerance),
        ("pulse-distance", axis.pulse_distance),
        ("ref-speed", axis.ref_speed),
        ("ref-speed-low", axis.ref_speed_low),
    ] {
        if value <= Thousandths(0) {
            compiler.error(key, format!("{value} must be greater than 0"));
        }
    }
    if !(1..=1000).contains(&axis.gain) {
        compiler.error("gain", "must be 1 to 1000; the loop has a tick of 1 ms");
    }
    if axis.limit_zone < Thousandths(0) {
        compiler.error("limit-zone", "must not be negative");
    }
    if let (Some(minus), Some(plus)) = (axis.limit_minus, axis.limit_plus)
        && minus >= plus
    {
        compiler.error("limit-minus", format!("{minus} must be less than `limit-plus`, {plus}"));
    }
    if !matches!(axis.ref_method, 1 | 5 | 9..=15) {
        compiler.error("ref-method", "must be 1, 5 or 9 to 15");
    }
    if matches!(axis.ref_method, 10 | 11) && axis.ref_switch == RefSwitch::None {
        compiler.error("ref-switch", format!("method {} needs the reference switch", axis.ref_method));
    }
    if axis.servos.len() > SERVOS || axis.servos.iter().any(|servo| !(1..=16).contains(servo)) {
        compiler.error("servos", "needs at most 4 numbers from 1 to 16");
    }
}

impl AxisSettings {
    /// Settings of the axis with this index, 0 to 15.
    pub(crate) fn new(axis: &config::Axis, index: u8) -> AxisSettings {
        let speed = |value: Thousandths| per_minute(value.units());
        let servos = if axis.servos.is_empty() {
            [index].to_vec()
        } else {
            axis.servos.iter().map(|number| number.saturating_sub(1).min(15)).collect()
        };
        AxisSettings {
            start: axis.start.thousandths(),
            feed: speed(axis.feed),
            rapid: speed(axis.feed_rapid),
            slow: speed(axis.feed_slow),
            acceleration: axis.acceleration.thousandths(),
            acceleration_rapid: axis.acceleration_rapid.thousandths(),
            emergency: axis.acceleration_emergency.thousandths(),
            gain: f64::from(axis.gain),
            difference_limit: axis.difference_limit.thousandths(),
            tolerance: axis.tolerance.thousandths(),
            increments: f64::from(axis.increments) / UM,
            limit_plus: axis.limit_plus.map_or(f64::INFINITY, Thousandths::thousandths),
            limit_minus: axis.limit_minus.map_or(f64::NEG_INFINITY, Thousandths::thousandths),
            limit_zone: axis.limit_zone.thousandths(),
            pulse_distance: axis.pulse_distance.thousandths().max(1.0),
            pulse_at: axis.pulse_at.thousandths(),
            jog_enable: axis.jog_enable,
            servos,
            reference: RefSettings {
                method: axis.ref_method,
                via_plc: axis.ref_via_plc,
                switch: axis.ref_switch,
                slow_down: axis.slow_down_switch,
                inverted: axis.invert_ref_direction,
                speed: speed(axis.ref_speed),
                speed_low: speed(axis.ref_speed_low),
                after: axis.after_ref,
                position_after: axis.pos_after_ref.thousandths(),
                null_point: axis.machine_null_point.thousandths(),
                override_counts: axis.ref_override,
            },
        }
    }
}
