//! Numbers of the machine description with up to three decimals, kept exactly.

use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, Visitor};

/// A number in thousandths: millimetres as micrometres, mm/min as µm/min. Written `12`, `12.5` or `-0.25`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Thousandths(pub i64);

/// The greatest magnitude, a billion: far beyond any machine, and without loss everywhere.
const GREATEST: i64 = 1_000_000_000;

impl Thousandths {
    /// A whole number.
    #[must_use]
    pub const fn whole(value: i32) -> Self {
        Thousandths(value as i64 * 1000)
    }

    /// In thousandths.
    pub(crate) fn thousandths(self) -> f64 {
        self.0 as f64
    }

    /// In whole units.
    pub(crate) fn units(self) -> f64 {
        self.0 as f64 / 1000.0
    }
}

impl fmt::Display for Thousandths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (whole, rest) = (self.0.unsigned_abs() / 1000, self.0.unsigned_abs() % 1000);
        let sign = if self.0 < 0 { "-" } else { "" };
        write!(f, "{sign}{whole}.{rest:03}")
    }
}

impl<'de> Deserialize<'de> for Thousandths {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = Thousandths;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number from -1000000000 to 1000000000, such as 12.5")
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Thousandths, E> {
                if (-GREATEST..=GREATEST).contains(&value) {
                    Ok(Thousandths(value * 1000))
                } else {
                    Err(E::invalid_value(serde::de::Unexpected::Signed(value), &self))
                }
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Thousandths, E> {
                self.visit_i64(i64::try_from(value).unwrap_or(i64::MAX))
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Thousandths, E> {
                if value.abs() <= GREATEST as f64 {
                    Ok(Thousandths(super::units::rounded(value * 1000.0)))
                } else {
                    Err(E::invalid_value(serde::de::Unexpected::Float(value), &self))
                }
            }
        }
        deserializer.deserialize_any(Number)
    }
}
