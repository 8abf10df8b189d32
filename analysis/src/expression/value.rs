//! Values: read from memory and registers, shown, and parsed to be written back.

use std::fmt;
use std::ops::Range;

use technol_image::op::{Addr, Width};

use super::parse::number;
use super::{Register, Target};

/// A value as people see it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A bit: `true` or `false`.
    Bit(bool),
    /// A cell or part of DR.
    Unsigned(u64),
    /// DR and constants.
    Signed(i64),
    /// A real.
    Real(f64),
    /// A text up to its closing zero.
    Text(String),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Bit(value) => write!(f, "{value}"),
            Value::Unsigned(value) => write!(f, "{value}"),
            Value::Signed(value) => write!(f, "{value}"),
            // Keeps the decimal point, so that a real is seen to be one.
            Value::Real(value) => write!(f, "{value:?}"),
            Value::Text(text) => write!(f, "'{}'", text.replace('\'', "''")),
        }
    }
}

/// Contents of the registers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RegisterValues {
    /// RLO.
    pub rlo: bool,
    /// DR, 64 bits.
    pub dr: i64,
    /// DR_REAL.
    pub dr_real: f64,
    /// BX.
    pub bx: u32,
}

/// What to do to give a target a new value.
#[derive(Clone, Debug, PartialEq)]
pub enum Assignment {
    /// Set or clear a bit.
    Bit {
        /// Byte address.
        addr: Addr,
        /// Bit number 0..=7.
        bit: u8,
        /// New value.
        value: bool,
    },
    /// Write bytes.
    Memory {
        /// First byte.
        addr: Addr,
        /// New content.
        bytes: Vec<u8>,
    },
    /// Replace the registers, given their present contents.
    Registers(RegisterChange),
}

/// A new value of one register.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RegisterChange {
    /// RLO.
    Rlo(bool),
    /// The low bits of DR of this width; the others stay.
    Dr(Width, u64),
    /// DR_REAL.
    DrReal(f64),
    /// BX.
    Bx(u32),
}

impl RegisterChange {
    /// The registers after the change.
    #[must_use]
    pub fn apply(self, mut registers: RegisterValues) -> RegisterValues {
        match self {
            RegisterChange::Rlo(value) => registers.rlo = value,
            RegisterChange::Dr(width, value) => {
                let mask = mask(width);
                registers.dr = ((registers.dr as u64 & !mask) | (value & mask)) as i64;
            }
            RegisterChange::DrReal(value) => registers.dr_real = value,
            RegisterChange::Bx(value) => registers.bx = value,
        }
        registers
    }
}

/// Why a text is not a value for a target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueError {
    /// A bit takes `true`, `false`, `1`, `0`: the text.
    Bit(String),
    /// Not a whole number: the text.
    Integer(String),
    /// Not a real number: the text.
    Real(String),
    /// Outside of these bounds: the text, lowest, highest.
    Range(String, i64, u64),
    /// Longer than the buffer: characters given, characters it holds.
    TextLength(usize, u32),
    /// A character that needs more than a byte.
    Character(char),
    /// A constant, or a mechanism of another program.
    ReadOnly,
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ValueError::Bit(text) => write!(f, "`{text}` is not a bit value; say true, false, 1 or 0"),
            ValueError::Integer(text) => {
                write!(f, "`{text}` is not a whole number; say for instance 248, 0F8h, 0xF8, 0101b or 'A'")
            }
            ValueError::Real(text) => write!(f, "`{text}` is not a real number; say for instance 1.5"),
            ValueError::Range(text, low, high) => write!(f, "{text} does not fit: {low} to {high}"),
            ValueError::TextLength(given, most) => {
                write!(f, "the text has {given} characters, the buffer holds {most}")
            }
            ValueError::Character(c) => write!(f, "the character `{c}` does not fit into a byte"),
            ValueError::ReadOnly => write!(f, "this cannot be changed"),
        }
    }
}

impl std::error::Error for ValueError {}

impl Target {
    /// The bytes of memory it takes; `None` for registers, constants, and mechanisms that are not
    /// [looked up](Target::in_memory) yet.
    #[must_use]
    pub fn bytes(self) -> Option<Range<Addr>> {
        let (addr, len) = match self {
            Target::Bit { addr, .. } => (addr, 1),
            Target::Cell { addr, width } => (addr, width.bytes()),
            Target::Text { addr, len } => (addr, len.saturating_add(1)),
            Target::Register(_) | Target::Constant(_) | Target::Mechanism(_) => return None,
        };
        Some(addr..addr.saturating_add(len))
    }

    /// Its value, from the bytes that [`Target::bytes`] asks for.
    #[must_use]
    pub fn decode(self, bytes: &[u8]) -> Option<Value> {
        match self {
            Target::Bit { bit, .. } => Some(Value::Bit(bytes.first()? >> bit & 1 == 1)),
            Target::Cell { width, .. } => {
                let mut raw = [0; 8];
                let len = width.bytes() as usize;
                raw.get_mut(..len)?.copy_from_slice(bytes.get(..len)?);
                Some(match width {
                    Width::Real => Value::Real(f64::from_le_bytes(raw)),
                    _ => Value::Unsigned(u64::from_le_bytes(raw)),
                })
            }
            Target::Text { .. } => {
                Some(Value::Text(bytes.iter().take_while(|b| **b != 0).map(|b| char::from(*b)).collect()))
            }
            Target::Register(_) | Target::Constant(_) | Target::Mechanism(_) => None,
        }
    }

    /// Its value in a whole memory.
    #[must_use]
    pub fn read(self, memory: &[u8], registers: &RegisterValues) -> Option<Value> {
        match self {
            Target::Register(register) => Some(register.value(registers)),
            Target::Constant(value) => Some(Value::Signed(value)),
            _ => {
                let range = self.bytes()?;
                self.decode(memory.get(range.start as usize..range.end as usize)?)
            }
        }
    }

    /// What gives it the value that `text` says.
    ///
    /// # Errors
    /// Why `text` is not a value for it.
    pub fn assign(self, text: &str) -> Result<Assignment, ValueError> {
        let text = text.trim();
        match self {
            Target::Bit { addr, bit } => Ok(Assignment::Bit { addr, bit, value: bit_value(text)? }),
            Target::Cell { addr, width: Width::Real } => {
                Ok(Assignment::Memory { addr, bytes: real_value(text)?.to_le_bytes().to_vec() })
            }
            Target::Cell { addr, width } => {
                let bytes = integer_value(text, width)?.to_le_bytes();
                Ok(Assignment::Memory {
                    addr,
                    bytes: bytes.iter().take(width.bytes() as usize).copied().collect(),
                })
            }
            Target::Text { addr, len } => Ok(Assignment::Memory { addr, bytes: text_value(text, len)? }),
            Target::Register(register) => {
                let change = match register {
                    Register::Rlo => RegisterChange::Rlo(bit_value(text)?),
                    Register::Dr => RegisterChange::Dr(Width::QWord, integer_value(text, Width::QWord)?),
                    Register::DrPart(width) => RegisterChange::Dr(width, integer_value(text, width)?),
                    Register::DrReal => RegisterChange::DrReal(real_value(text)?),
                    Register::Bx => RegisterChange::Bx(integer_value(text, Width::DWord)? as u32),
                };
                Ok(Assignment::Registers(change))
            }
            Target::Constant(_) | Target::Mechanism(_) => Err(ValueError::ReadOnly),
        }
    }
}

impl Register {
    /// Its value.
    #[must_use]
    pub fn value(self, registers: &RegisterValues) -> Value {
        match self {
            Register::Rlo => Value::Bit(registers.rlo),
            Register::Dr => Value::Signed(registers.dr),
            Register::DrPart(width) => Value::Unsigned(registers.dr as u64 & mask(width)),
            Register::DrReal => Value::Real(registers.dr_real),
            Register::Bx => Value::Unsigned(u64::from(registers.bx)),
        }
    }
}

fn mask(width: Width) -> u64 {
    u64::MAX >> (64 - width.bits())
}

fn bit_value(text: &str) -> Result<bool, ValueError> {
    match text.to_ascii_lowercase().as_str() {
        "1" | "true" => Ok(true),
        "0" | "false" => Ok(false),
        _ => Err(ValueError::Bit(text.to_owned())),
    }
}

fn real_value(text: &str) -> Result<f64, ValueError> {
    text.parse().map_err(|_| ValueError::Real(text.to_owned()))
}

/// A whole number that fits the width, signed or unsigned, as its bits.
fn integer_value(text: &str, width: Width) -> Result<u64, ValueError> {
    let not_a_number = || ValueError::Integer(text.to_owned());
    let (negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits.trim_start()),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let mut characters =
        digits.strip_prefix('\'').and_then(|t| t.strip_suffix('\'')).into_iter().flat_map(str::chars);
    let magnitude = match (characters.next(), characters.next()) {
        (Some(c), None) if (c as u32) < 256 => u64::from(c as u32),
        (None, _) => number(digits).ok_or_else(not_a_number)? as u64,
        _ => return Err(not_a_number()),
    };
    let (low, high) = (-1i64 << (width.bits() - 1), mask(width));
    let fits = if negative { magnitude <= low.unsigned_abs() } else { magnitude <= high };
    if !fits {
        return Err(ValueError::Range(text.to_owned(), low, high));
    }
    Ok(if negative { magnitude.wrapping_neg() & high } else { magnitude })
}

/// A text with or without apostrophes, filled up with zeros to the length of the buffer.
fn text_value(text: &str, len: u32) -> Result<Vec<u8>, ValueError> {
    let quoted = text.strip_prefix('\'').and_then(|t| t.strip_suffix('\''));
    let text = quoted.map_or_else(|| text.to_owned(), |t| t.replace("''", "'"));
    let count = text.chars().count();
    if count > len as usize {
        return Err(ValueError::TextLength(count, len));
    }
    let mut bytes = Vec::with_capacity(len as usize + 1);
    for c in text.chars() {
        bytes.push(u8::try_from(c as u32).map_err(|_| ValueError::Character(c))?);
    }
    bytes.resize(len as usize + 1, 0);
    Ok(bytes)
}
