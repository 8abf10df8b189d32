//! BCD numbers: one decimal digit in four bits.

/// Value of a BCD number; `None` when a digit is above 9.
pub(crate) fn from_bcd(bcd: u32) -> Option<u32> {
    let mut value = 0;
    for shift in (0..32).step_by(4).rev() {
        let digit = bcd >> shift & 0xF;
        if digit > 9 {
            return None;
        }
        value = value * 10 + digit;
    }
    Some(value)
}

/// BCD form of a number of at most eight digits; higher digits are lost.
pub(crate) fn to_bcd(mut value: u32) -> u32 {
    let mut bcd = 0;
    for shift in (0..32).step_by(4) {
        bcd |= (value % 10) << shift;
        value /= 10;
    }
    bcd
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversion_round_trips_and_rejects_hexadecimal_digits() {
        for value in [0, 1, 9, 10, 99, 100, 9_999, 12_345_678, 99_999_999] {
            assert_eq!(from_bcd(to_bcd(value)), Some(value));
        }
        assert_eq!(to_bcd(1234), 0x1234);
        assert_eq!(from_bcd(0x000A), None);
        assert_eq!(from_bcd(0xF000_0000), None);
    }
}
