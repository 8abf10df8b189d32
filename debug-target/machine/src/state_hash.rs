//! A number for a state of the machine.

use core::fmt::{self, Debug, Write};

/// The number of a value: how it shows itself has every field of it, also those that are added later.
pub(crate) fn of(value: &dyn Debug) -> u64 {
    let mut hash = Fnv::new();
    // Writing into the hash does not fail.
    let _ = write!(hash, "{value:?}");
    hash.0
}

/// The number of bytes, for areas that are too long to show each of them.
pub(crate) fn of_bytes(bytes: &[u8]) -> u64 {
    let mut hash = Fnv::new();
    hash.add(bytes);
    hash.0
}

/// 64-bit FNV-1a of what is written, over eight bytes at a time.
struct Fnv(u64);

impl Fnv {
    fn new() -> Fnv {
        Fnv(0xCBF2_9CE4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks();
        for word in words {
            self.add_word(u64::from_le_bytes(*word));
        }
        if !rest.is_empty() {
            self.add_word(rest.iter().fold(1, |word, byte| word << 8 | u64::from(*byte)));
        }
    }

    fn add_word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01B3);
        self.0 ^= self.0 >> 32;
    }
}

impl Write for Fnv {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}
