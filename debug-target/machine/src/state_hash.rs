//! A number for a state of the machine.

use core::fmt::{self, Debug, Write};

/// The number of a value: how it shows itself has every field of it, also those that are added later.
pub(crate) fn of(value: &dyn Debug) -> u64 {
    let mut hash = Fnv(0xCBF2_9CE4_8422_2325);
    // Writing into the hash does not fail.
    let _ = write!(hash, "{value:?}");
    hash.0
}

/// 64-bit FNV-1a of what is written.
struct Fnv(u64);

impl Write for Fnv {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
        }
        Ok(())
    }
}
