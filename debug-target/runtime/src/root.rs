//! Square roots without a library.

/// Square root by Newton's method: the same bits on every computer, and no library is needed. What has none (a negative number, NaN)
/// gives 0.
#[must_use]
pub fn root(value: f64) -> f64 {
    if value.is_nan() || value <= 0.0 {
        return 0.0;
    }
    // Half of the exponent is a start within a few per cent; each step doubles the digits that are right.
    let mut root = f64::from_bits((value.to_bits() >> 1) + 0x1FF8_0000_0000_0000);
    for _ in 0..5 {
        root = 0.5 * (root + value / root);
    }
    root
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // exact results are what is tested
mod tests {
    extern crate std;

    use super::*;

    #[test]
    fn roots_are_right_to_the_last_digits() {
        for n in 0..2000_i32 {
            let value = f64::from(n) * f64::from(n) * 0.37 + f64::from(n) * 1e-9;
            let expected = value.sqrt();
            assert!((root(value) - expected).abs() <= expected * 4e-16, "{value}");
        }
        assert_eq!(root(-1.0), 0.0);
        assert!((root(1e-12) - 1e-6).abs() < 1e-20 && (root(1e15) - 1e15_f64.sqrt()).abs() < 1e-8);
    }
}
