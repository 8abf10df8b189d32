//! Values of elements, and how they lie in cells (manual 27.6).

use alloc::vec::Vec;

/// The value of an input or output that is named by an identifier.
#[derive(Clone, Debug, PartialEq)]
pub enum ElementValue {
    /// A bit (0 or 1) or an integer of up to 64 bits, signed or not.
    Int(i128),
    /// A real; volts or any other unit.
    Real(f64),
    /// A text without its end mark, in the code page of the control, or a binary block.
    Bytes(Vec<u8>),
}

impl ElementValue {
    /// As a bit: a number other than 0. A text is no bit.
    #[must_use]
    pub fn is_on(&self) -> bool {
        match self {
            ElementValue::Int(value) => *value != 0,
            ElementValue::Real(value) => *value != 0.0,
            ElementValue::Bytes(_) => false,
        }
    }

    /// As a real; `None` for a text.
    #[must_use]
    pub fn as_real(&self) -> Option<f64> {
        match self {
            ElementValue::Int(value) => Some(*value as f64),
            ElementValue::Real(value) => Some(*value),
            ElementValue::Bytes(_) => None,
        }
    }
}

impl From<bool> for ElementValue {
    fn from(value: bool) -> ElementValue {
        ElementValue::Int(i128::from(value))
    }
}

impl From<i64> for ElementValue {
    fn from(value: i64) -> ElementValue {
        ElementValue::Int(i128::from(value))
    }
}

impl From<u64> for ElementValue {
    fn from(value: u64) -> ElementValue {
        ElementValue::Int(i128::from(value))
    }
}

impl From<f64> for ElementValue {
    fn from(value: f64) -> ElementValue {
        ElementValue::Real(value)
    }
}

impl From<&[u8]> for ElementValue {
    fn from(value: &[u8]) -> ElementValue {
        ElementValue::Bytes(value.to_vec())
    }
}

/// Type of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::control) enum CellType {
    /// This bit of its byte.
    Bit(u8),
    Int {
        /// 1, 2, 4 or 8.
        bytes: usize,
        signed: bool,
    },
    Real,
    /// A text with its end mark.
    Text,
    Block,
}

impl CellType {
    /// The type that a keyword names; `bit` is the position if it is a bit.
    pub(in crate::control) fn of(keyword: &str, bit: u8) -> Option<CellType> {
        let name = keyword.strip_prefix("TYPE_")?;
        let int = |bytes, signed| CellType::Int { bytes, signed };
        Some(match name {
            "BIT" => CellType::Bit(bit),
            "REAL" => CellType::Real,
            "STR" => CellType::Text,
            "BIN" => CellType::Block,
            "INT_8" | "INT8" => int(1, true),
            "INT_16" | "INT16" => int(2, true),
            "INT_32" | "INT32" => int(4, true),
            "INT_64" | "INT64" => int(8, true),
            "UNS_8" | "UNS8" | "BYTE" => int(1, false),
            "UNS_16" | "UNS16" | "WORD" => int(2, false),
            "UNS_32" | "UNS32" | "DWORD" => int(4, false),
            "UNS_64" | "UNS64" | "QWORD" => int(8, false),
            _ => return None,
        })
    }

    /// Bytes of one element in a variable of `len` bytes: texts and blocks are one element.
    pub(in crate::control) fn size(self, len: usize) -> usize {
        match self {
            CellType::Bit(_) => 1,
            CellType::Int { bytes, .. } => bytes,
            CellType::Real => 8,
            CellType::Text | CellType::Block => len,
        }
    }

    /// The value in a cell; `None` when the bytes are not as many as the type has.
    pub(in crate::control) fn read(self, cell: &[u8]) -> Option<ElementValue> {
        Some(match self {
            CellType::Bit(bit) => (cell.first()? >> bit & 1 != 0).into(),
            CellType::Int { bytes, signed } => {
                let mut all = [0; 8];
                all[..bytes].copy_from_slice(cell.get(..bytes)?);
                let value = u64::from_le_bytes(all);
                let unused = 64 - 8 * bytes as u32;
                if signed { (value.cast_signed() << unused >> unused).into() } else { value.into() }
            }
            CellType::Real => f64::from_le_bytes(cell.get(..8)?.try_into().ok()?).into(),
            CellType::Text => {
                let end = cell.iter().position(|byte| *byte == 0).unwrap_or(cell.len());
                cell[..end].into()
            }
            CellType::Block => cell.into(),
        })
    }

    /// Writes a value, converted: an integer into a real and back (to the nearest, ties to even, held within the
    /// range of the cell), the low bits of an integer into a shorter cell, any number but 0 into a bit. Between numbers
    /// and texts nothing is converted: the cell stays.
    pub(in crate::control) fn write(self, cell: &mut [u8], value: &ElementValue) {
        match self {
            CellType::Bit(bit) => {
                if let (Some(byte), false) = (cell.first_mut(), matches!(value, ElementValue::Bytes(_))) {
                    *byte = *byte & !(1 << bit) | u8::from(value.is_on()) << bit;
                }
            }
            CellType::Int { bytes, signed } => {
                let whole = match *value {
                    ElementValue::Int(value) => value,
                    ElementValue::Real(value) => {
                        let bits = 8 * bytes as u32;
                        let (low, high) = if signed {
                            (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1)
                        } else {
                            (0, (1_i128 << bits) - 1)
                        };
                        nearest(value).clamp(low, high)
                    }
                    ElementValue::Bytes(_) => return,
                };
                if let Some(cell) = cell.get_mut(..bytes) {
                    cell.copy_from_slice(&whole.to_le_bytes()[..bytes]);
                }
            }
            CellType::Real => {
                if let (Some(cell), Some(value)) = (cell.get_mut(..8), value.as_real()) {
                    cell.copy_from_slice(&value.to_le_bytes());
                }
            }
            CellType::Text | CellType::Block => {
                let ElementValue::Bytes(bytes) = value else { return };
                // A text keeps a byte for its end mark; behind the value there are zeros.
                let room = cell.len().saturating_sub(usize::from(self == CellType::Text));
                let taken = bytes.len().min(room);
                cell.fill(0);
                cell[..taken].copy_from_slice(&bytes[..taken]);
            }
        }
    }
}

/// Nearest integer, ties to even; NaN gives 0.
fn nearest(value: f64) -> i128 {
    // From 2^52 on a double has no fraction; below, adding 2^52 leaves the rounding to the processor.
    const NO_FRACTION: f64 = 4_503_599_627_370_496.0;
    let magnitude = value.abs();
    if magnitude < NO_FRACTION {
        ((magnitude + NO_FRACTION) - NO_FRACTION).copysign(value) as i128
    } else {
        value as i128
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;
    use alloc::{format, vec};

    /// What a cell of a type, filled with EEh, holds after a value was written.
    fn written(keyword: &str, len: usize, value: impl Into<ElementValue>) -> String {
        let mut cell = vec![0xEE; len];
        CellType::of(keyword, 3).unwrap().write(&mut cell, &value.into());
        format!("{cell:02X?}")
    }

    #[test]
    fn values_are_converted_to_the_type_of_the_cell() {
        let max = u64::MAX;
        for (found, expected) in [
            (written("TYPE_BIT", 1, 4.5), "[EE]"),
            (written("TYPE_BIT", 1, 0_i64), "[E6]"),
            (written("TYPE_INT_8", 1, -2_i64), "[FE]"),
            (written("TYPE_INT_8", 1, 1000_i64), "[E8]"),
            (written("TYPE_INT_8", 1, 1000.0), "[7F]"),
            (written("TYPE_INT8", 1, -1000.0), "[80]"),
            (written("TYPE_UNS_8", 1, 1000.0), "[FF]"),
            (written("TYPE_BYTE", 1, -1.0), "[00]"),
            (written("TYPE_INT_16", 2, -2_i64), "[FE, FF]"),
            (written("TYPE_WORD", 2, 2.5), "[02, 00]"),
            (written("TYPE_UNS16", 2, 3.5), "[04, 00]"),
            (written("TYPE_INT_32", 4, f64::NAN), "[00, 00, 00, 00]"),
            (written("TYPE_INT_32", 4, -1_i64), "[FF, FF, FF, FF]"),
            (written("TYPE_UNS_64", 8, f64::INFINITY), "[FF, FF, FF, FF, FF, FF, FF, FF]"),
            (written("TYPE_QWORD", 8, max), "[FF, FF, FF, FF, FF, FF, FF, FF]"),
            (written("TYPE_REAL", 8, 1_i64), "[00, 00, 00, 00, 00, 00, F0, 3F]"),
            (written("TYPE_STR", 4, &b"ab"[..]), "[61, 62, 00, 00]"),
            (written("TYPE_STR", 3, &b"abcd"[..]), "[61, 62, 00]"),
            (written("TYPE_BIN", 3, &b"abcd"[..]), "[61, 62, 63]"),
            (written("TYPE_STR", 2, 7_i64), "[EE, EE]"),
            (written("TYPE_WORD", 2, &b"7"[..]), "[EE, EE]"),
        ] {
            assert_eq!(found, expected);
        }
        assert_eq!(CellType::of("TYPE_INT_24", 0), None);
    }

    #[test]
    fn cells_are_read_with_their_sign_only_when_they_have_one() {
        let read = |keyword, cell: &[u8]| CellType::of(keyword, 1).and_then(|kind| kind.read(cell));
        assert_eq!(read("TYPE_BIT", &[2]), Some(true.into()));
        assert_eq!(read("TYPE_INT_16", &[0xFE, 0xFF]), Some((-2_i64).into()));
        assert_eq!(read("TYPE_UNS_16", &[0xFE, 0xFF]), Some(65534_i64.into()));
        assert_eq!(read("TYPE_UNS_64", &[0xFF; 8]), Some(u64::MAX.into()));
        assert_eq!(read("TYPE_STR", b"ab\0c"), Some(b"ab"[..].into()));
        assert_eq!(read("TYPE_REAL", &[0; 4]), None);
    }
}
