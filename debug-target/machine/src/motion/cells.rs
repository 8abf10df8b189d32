//! The interface between control and program: cells and bits in the memory of the PLC.

use technol_image::op::{Addr, BitRef};
use technol_image::system::motion::{AxisBits, SixBits};

/// The memory of the PLC, read and written by address. Outside of it everything reads as 0 and nothing is written.
#[derive(Debug)]
pub struct Cells<'a> {
    bytes: &'a mut [u8],
}

impl<'a> Cells<'a> {
    /// Cells in this memory; address 0 is its first byte.
    pub fn new(bytes: &'a mut [u8]) -> Self {
        Cells { bytes }
    }

    fn read<const N: usize>(&self, addr: Addr) -> [u8; N] {
        let at = addr as usize;
        self.bytes.get(at..at.saturating_add(N)).and_then(|cell| cell.try_into().ok()).unwrap_or([0; N])
    }

    fn write<const N: usize>(&mut self, addr: Addr, value: [u8; N]) {
        let at = addr as usize;
        if let Some(cell) = self.bytes.get_mut(at..at.saturating_add(N)) {
            cell.copy_from_slice(&value);
        }
    }

    /// A bit.
    #[must_use]
    pub fn bit(&self, place: BitRef) -> bool {
        self.byte(place.addr) >> (place.bit & 7) & 1 != 0
    }

    /// Writes a bit.
    pub fn set_bit(&mut self, place: BitRef, value: bool) {
        let mask = 1 << (place.bit & 7);
        let byte = self.byte(place.addr);
        self.set_byte(place.addr, if value { byte | mask } else { byte & !mask });
    }

    /// A BYTE cell.
    #[must_use]
    pub fn byte(&self, addr: Addr) -> u8 {
        self.read::<1>(addr)[0]
    }

    /// Writes a BYTE cell.
    pub fn set_byte(&mut self, addr: Addr, value: u8) {
        self.write(addr, [value]);
    }

    /// A WORD cell without sign.
    #[must_use]
    pub fn word(&self, addr: Addr) -> u16 {
        u16::from_le_bytes(self.read(addr))
    }

    /// Writes a WORD cell.
    pub fn set_word(&mut self, addr: Addr, value: u16) {
        self.write(addr, value.to_le_bytes());
    }

    /// A DWORD cell with sign.
    #[must_use]
    pub fn dword(&self, addr: Addr) -> i32 {
        i32::from_le_bytes(self.read(addr))
    }

    /// Writes a DWORD cell.
    pub fn set_dword(&mut self, addr: Addr, value: i32) {
        self.write(addr, value.to_le_bytes());
    }

    /// A QWORD cell.
    #[must_use]
    pub fn qword(&self, addr: Addr) -> i64 {
        i64::from_le_bytes(self.read(addr))
    }

    /// Writes a QWORD cell.
    pub fn set_qword(&mut self, addr: Addr, value: i64) {
        self.write(addr, value.to_le_bytes());
    }

    /// Writes a REAL cell.
    pub fn set_real(&mut self, addr: Addr, value: f64) {
        self.write(addr, value.to_le_bytes());
    }

    /// Bits of all axes, X in bit 0.
    #[must_use]
    pub fn axes(&self, family: AxisBits) -> u16 {
        let others = self.word(family.0 + 1);
        u16::from(self.byte(family.0) & FIRST_SIX) | others << 6
    }

    /// Writes the bits of all axes; bits that belong to no axis stay.
    pub fn set_axes(&mut self, family: AxisBits, mask: u16) {
        let first = self.byte(family.0) & !FIRST_SIX | mask.to_le_bytes()[0] & FIRST_SIX;
        self.set_byte(family.0, first);
        let others = self.word(family.0 + 1) & !OTHER_TEN | mask >> 6;
        self.set_word(family.0 + 1, others);
    }

    /// Bits of the first six axes, X in bit 0.
    #[must_use]
    pub fn six(&self, family: SixBits) -> u16 {
        u16::from(self.byte(family.0) & FIRST_SIX)
    }

    /// Writes the bits of the first six axes.
    pub fn set_six(&mut self, family: SixBits, mask: u16) {
        let byte = self.byte(family.0) & !FIRST_SIX | mask.to_le_bytes()[0] & FIRST_SIX;
        self.set_byte(family.0, byte);
    }
}

/// Bits of the axes in the first byte of a family.
const FIRST_SIX: u8 = 0x3F;
/// Bits of the axes in the two bytes behind it.
const OTHER_TEN: u16 = 0x03FF;

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn masks_of_axes_spread_over_three_bytes_and_leave_foreign_bits() {
        let mut bytes = vec![0xC0, 0x00, 0xFC];
        let mut cells = Cells::new(&mut bytes);
        cells.set_axes(AxisBits(0), 0b1100_0000_0110_0001);
        assert_eq!(cells.axes(AxisBits(0)), 0b1100_0000_0110_0001);
        for axis in 0..16 {
            assert_eq!(cells.bit(AxisBits(0).of(axis)), [0, 5, 6, 14, 15].contains(&axis), "{axis}");
        }
        assert_eq!(bytes, [0xE1, 0x01, 0xFF]);
    }

    #[test]
    fn outside_of_memory_nothing_is_read_or_written() {
        let mut bytes = vec![0xFF; 4];
        let mut cells = Cells::new(&mut bytes);
        cells.set_dword(2, 0);
        cells.set_qword(Addr::MAX, 0);
        assert_eq!((cells.word(3), cells.dword(2), cells.byte(4), cells.dword(0)), (0, 0, 0, -1));
    }
}
