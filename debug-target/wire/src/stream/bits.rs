//! Bits in a row, the highest of each byte first, and the codes that samples are made of.

use alloc::vec::Vec;

/// Appends bits to bytes.
pub(crate) struct BitWriter<'a> {
    out: &'a mut Vec<u8>,
    /// Bits of the last byte that are not used yet.
    free: u32,
}

impl<'a> BitWriter<'a> {
    /// Begins behind the bytes that are there.
    pub(crate) fn new(out: &'a mut Vec<u8>) -> Self {
        BitWriter { out, free: 0 }
    }

    /// The low `count` bits of `value`.
    pub(crate) fn put(&mut self, value: u64, mut count: u32) {
        while count > 0 {
            if self.free == 0 {
                self.out.push(0);
                self.free = 8;
            }
            let step = count.min(self.free);
            let piece = value >> (count - step) & ((1 << step) - 1);
            self.free -= step;
            if let Some(last) = self.out.last_mut() {
                *last |= (piece << self.free) as u8;
            }
            count -= step;
        }
    }

    /// A number that is mostly small: `order` plain bits, and more where it needs them (exponential Golomb code).
    pub(crate) fn put_golomb(&mut self, value: u32, order: u32) {
        let shifted = u64::from(value) + (1 << order);
        let bits = 64 - shifted.leading_zeros();
        self.put(0, bits - 1 - order);
        self.put(shifted, bits);
    }

    /// A difference of values of `width` bits: how many half bytes it takes, and these.
    pub(crate) fn put_difference(&mut self, difference: u64, width: u8) {
        let folded = fold_sign(difference, width);
        let halves = half_bytes(folded);
        self.put(u64::from(halves - 1), count_bits(width));
        self.put(folded, halves * 4);
    }
}

/// Bits that [`BitWriter::put_golomb`] needs.
pub(crate) fn golomb_len(value: u32, order: u32) -> u32 {
    let bits = 64 - (u64::from(value) + (1 << order)).leading_zeros();
    2 * bits - 1 - order
}

/// Bits that [`BitWriter::put_difference`] needs.
pub(crate) fn difference_len(difference: u64, width: u8) -> u32 {
    count_bits(width) + half_bytes(fold_sign(difference, width)) * 4
}

/// Bits of the count of half bytes.
fn count_bits(width: u8) -> u32 {
    u32::from(width / 4).trailing_zeros()
}

fn half_bytes(folded: u64) -> u32 {
    (64 - folded.leading_zeros()).div_ceil(4).max(1)
}

pub(crate) const fn mask(width: u8) -> u64 {
    if width >= 64 { u64::MAX } else { (1 << width) - 1 }
}

/// Sign in the lowest bit: 0, -1, 1, -2 … become 0, 1, 2, 3 …
fn fold_sign(difference: u64, width: u8) -> u64 {
    let unused = 64 - u32::from(width);
    let signed = ((difference << unused) as i64) >> unused;
    ((signed << 1) ^ (signed >> 63)) as u64 & mask(width)
}

fn unfold_sign(folded: u64, width: u8) -> u64 {
    ((folded >> 1) ^ (folded & 1).wrapping_neg()) & mask(width)
}

/// Takes bits from bytes.
pub(crate) struct BitReader<'a> {
    bytes: &'a [u8],
    /// Bits taken.
    at: usize,
}

impl<'a> BitReader<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        BitReader { bytes, at: 0 }
    }

    fn left(&self) -> usize {
        self.bytes.len() * 8 - self.at
    }

    /// The next `count` bits, at most 64.
    pub(crate) fn take(&mut self, count: u32) -> Option<u64> {
        if self.left() < count as usize {
            return None;
        }
        let mut value = 0;
        let mut missing = count as usize;
        while missing > 0 {
            let free = 8 - self.at % 8;
            let step = missing.min(free);
            let byte = u64::from(self.bytes[self.at / 8]);
            value = value << step | byte >> (free - step) & ((1 << step) - 1);
            self.at += step;
            missing -= step;
        }
        Some(value)
    }

    /// See [`BitWriter::put_golomb`].
    pub(crate) fn take_golomb(&mut self, order: u32) -> Option<u32> {
        let mut zeros = 0;
        while self.take(1)? == 0 {
            zeros += 1;
        }
        let rest = Some(zeros + order).filter(|n| *n <= 32)?;
        let shifted = 1 << rest | self.take(rest)?;
        u32::try_from(shifted - (1 << order)).ok()
    }

    /// See [`BitWriter::put_difference`].
    pub(crate) fn take_difference(&mut self, width: u8) -> Option<u64> {
        let halves = self.take(count_bits(width))? as u32 + 1;
        Some(unfold_sign(self.take(halves * 4)?, width))
    }

    /// Nothing is left but the zeros that fill the last byte.
    pub(crate) fn is_done(&self) -> bool {
        self.left() == 0
            || self.left() < 8
                && self.bytes.last().is_some_and(|last| last.trailing_zeros() as usize >= self.left())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn codes_are_as_short_as_promised() {
        for (value, order, len) in
            [(0, 0, 1), (1, 0, 3), (2, 0, 3), (3, 0, 5), (0, 2, 3), (3, 2, 3), (4, 2, 5), (11, 2, 5)]
        {
            assert_eq!(golomb_len(value, order), len, "{value} of order {order}");
        }
        for (difference, width, len) in [
            (1, 32, 7),
            (-8_i64 as u64, 32, 7),
            (8, 32, 11),
            (-1_i64 as u64, 8, 5),
            (0x80, 8, 9),
            (i64::MIN as u64, 64, 68),
        ] {
            assert_eq!(difference_len(difference, width), len, "{difference:x} of {width} bits");
        }
    }

    proptest! {
        #[test]
        fn what_was_put_is_taken(codes in prop::collection::vec((any::<u64>(), 0_u32..64, 0..3_usize, 0..4_usize), 0..40)) {
            let mut bytes = Vec::new();
            let mut writer = BitWriter::new(&mut bytes);
            let mut expected_bits = 0;
            for (value, shift, code, pick) in &codes {
                let (value, width) = (value >> shift, [8, 16, 32, 64][*pick]);
                match code {
                    0 => writer.put(value, u32::from(width)),
                    1 => writer.put_golomb(value as u32, *pick as u32),
                    _ => writer.put_difference(value, width),
                }
                expected_bits += match code {
                    0 => u32::from(width),
                    1 => golomb_len(value as u32, *pick as u32),
                    _ => difference_len(value, width),
                };
            }
            prop_assert_eq!(bytes.len(), expected_bits.div_ceil(8) as usize);
            let mut reader = BitReader::new(&bytes);
            for (value, shift, code, pick) in codes {
                let (value, width) = (value >> shift, [8, 16, 32, 64][pick]);
                match code {
                    0 => prop_assert_eq!(reader.take(u32::from(width)), Some(value & mask(width))),
                    1 => prop_assert_eq!(reader.take_golomb(pick as u32), Some(value as u32)),
                    _ => prop_assert_eq!(reader.take_difference(width), Some(value & mask(width))),
                }
            }
            prop_assert!(reader.is_done());
        }

        #[test]
        fn any_bits_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..20), orders in prop::collection::vec(0_u32..4, 0..40)) {
            let mut reader = BitReader::new(&bytes);
            for order in orders {
                let _ = (reader.take_golomb(order), reader.take_difference(64), reader.is_done());
            }
        }
    }
}
