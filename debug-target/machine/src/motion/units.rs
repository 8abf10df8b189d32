//! Units of the interface, and those the model counts in: micrometres and seconds. For a rotary axis read 1/1000 ° for
//! a micrometre and ° for a millimetre.

/// One tick of the servo loops in seconds.
pub(crate) const TICK: f64 = 0.001;

/// Parts of a unit in cells the manual calls 1/64000: whole units are written to the upper WORD, so it is 65536
/// (this implementation).
pub(crate) const FRACTION: f64 = 65_536.0;

/// Micrometres per millimetre.
pub(crate) const UM: f64 = 1000.0;

/// Seconds per minute.
const MINUTE: f64 = 60.0;

/// A speed in mm/min as µm/s.
pub(crate) fn per_minute(mm_per_min: f64) -> f64 {
    mm_per_min * UM / MINUTE
}

/// The feed of a positioning unit, 1/65536 mm/min, as µm/s; a negative one counts as positive.
pub(crate) fn unit_feed(cell: i32) -> f64 {
    per_minute(f64::from(cell.unsigned_abs()) / FRACTION)
}

/// To the nearest whole number, halves away from zero; saturates.
pub(crate) fn rounded(value: f64) -> i64 {
    let half = if value < 0.0 { -0.5 } else { 0.5 };
    (value + half) as i64
}

/// As [`rounded`], for a DWORD.
pub(crate) fn rounded_dword(value: f64) -> i32 {
    let half = if value < 0.0 { -0.5 } else { 0.5 };
    (value + half) as i32
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // exact results are what is tested
mod tests {
    use super::*;

    #[test]
    fn the_upper_word_of_a_feed_is_whole_millimetres_per_minute() {
        assert_eq!(unit_feed(6000 << 16), 100_000.0);
        assert_eq!(unit_feed(-(6000 << 16)), 100_000.0);
        assert_eq!(unit_feed(60 * 0x8000), 500.0, "half a mm/min sixty times");
    }

    #[test]
    fn rounding_goes_to_the_nearest_and_saturates() {
        assert_eq!([2.5, -2.5, 0.49, -0.51].map(rounded), [3, -3, 0, -1]);
        assert_eq!([1e30, -1e30].map(rounded_dword), [i32::MAX, i32::MIN]);
    }
}
