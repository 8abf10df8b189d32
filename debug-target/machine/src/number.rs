//! Numbers with a decimal point, kept exactly.

use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, Visitor};

/// A number in thousandths: 2.5 is 2500. Written as an integer or with a decimal point; a fourth digit behind it is
/// rounded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Thousandths(pub i64);

/// Largest absolute value, in thousandths; a product with a time still fits.
const LIMIT: i64 = 1_000_000_000_000;

impl<'de> Deserialize<'de> for Thousandths {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = Thousandths;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number up to 1000000000")
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Thousandths, E> {
                let scaled = value.checked_mul(1000).filter(|n| n.abs() <= LIMIT);
                scaled.map(Thousandths).ok_or_else(|| E::custom("the number is too large"))
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Thousandths, E> {
                let scaled = value * 1000.0;
                if scaled.is_nan() || scaled.abs() > LIMIT as f64 {
                    return Err(E::custom("the number is too large"));
                }
                Ok(Thousandths((scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i64))
            }
        }
        deserializer.deserialize_any(Number)
    }
}

impl fmt::Display for Thousandths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (whole, rest) = (self.0 / 1000, self.0.unsigned_abs() % 1000);
        let sign = if self.0 < 0 && whole == 0 { "-" } else { "" };
        if rest == 0 {
            return write!(f, "{sign}{whole}");
        }
        let digits = [(1000, 3), (100, 2), (10, 1)];
        let (divisor, len) =
            digits.into_iter().rev().find(|(n, _)| rest % (1000 / n) == 0).unwrap_or((1000, 3));
        write!(f, "{sign}{whole}.{:0len$}", rest / (1000 / divisor))
    }
}
