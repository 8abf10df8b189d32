//! Values of cells and bits at power-on, where the manual tells them; those of the bits of the axes stand with
//! their family in `axes`.

/// Name in upper case and value.
const DEFAULTS: &[(&str, i64)] = &[
    ("EN_AUTMAN", 1),
    ("REQ_EXT_CONT_AUTMAN", 0),
    ("REQ_EXT_FEED_AUTMAN", 0),
    ("REQ_EXT_FEED_G00_AUTMAN", 0),
    ("START_DISABLE", 0),
    ("START_SUSPEND", 0),
    ("FEED_OVR_MULTIPLIER", 1000),
    ("SPEED_OVR_MULTIPLIER", 1000),
    ("NLCSERVOENABLE", 0xFFFF),
    ("G95_AUTMAN", 0),
    ("SHIFT_ENABLE", 0x3F),
];

/// The value of the symbol `name` (upper case) at power-on.
pub(super) fn of(name: &str) -> Option<i64> {
    DEFAULTS.iter().find(|(symbol, _)| *symbol == name).map(|&(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol, symbols};

    #[test]
    fn every_value_belongs_to_a_bit_or_cell_and_fits_it() {
        for (name, value) in DEFAULTS {
            assert_eq!(symbol(name).and_then(|symbol| symbol.default), Some(*value), "{name}");
        }
        for symbol in symbols() {
            let Some(value) = symbol.default else { continue };
            let bits = match symbol.kind {
                SystemKind::Bit { .. } => 1,
                SystemKind::Cell { prefix, .. } => 8 * prefix.bytes(),
                other => panic!("{}: {other:?} has no single value", symbol.name),
            };
            assert!(bits == 64 || (0..1_i64 << bits).contains(&value), "{}: {value}", symbol.name);
        }
    }

    #[test]
    fn motion_is_enabled_and_the_position_loop_closed_at_power_on() {
        for name in ["MPXPI", "MP16PI", "VAZBA_Z", "VAZBA_4"] {
            assert_eq!(symbol(name).and_then(|symbol| symbol.default), Some(1), "{name}");
        }
        assert_eq!(symbol("MPXMAN").and_then(|symbol| symbol.default), None);
    }
}
