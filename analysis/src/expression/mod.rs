//! Expressions of the debugger: what a watch, a hover or `technol run --print` may name.
//!
//! | form | means |
//! |---|---|
//! | `RLO`, `DR`, `DR8` … `DR64`, `DR_REAL`, `BX` | a register |
//! | `name` | a bit, a cell at its declared type, a text, a constant, the activation bit of a mechanism |
//! | `TYPE.name`, `TYPE.(name+n)` | memory at another type: BYTE, WORD, HIGH, DWRD, QWRD, REAL |
//! | `name+n`, `(name+n)` | the cell n bytes further |
//! | `adr.bit`, `(adr+n).bit`, `$+n.bit` | a bit position in another byte; `bit` is a bit's name or 0 to 7 |
//! | `BLK[n].member`, `BLK[n].TYPE.member[k]` | a member of a prepared block |
//! | `CNST.5`, `0F8h`, `'A'` | a constant |
//! | `file.plc:…` | names as that file sees them |
//!
//! Names are found as the language finds them (case does not matter, 31 characters count): local names of the file at
//! hand, then global and predefined ones; then a local name of another file, when only one file has it.

mod block;
mod names;
mod parse;
mod value;

use std::fmt;

use technol_image::DebugInfo;
use technol_image::op::{Addr, Width};
use technol_image::program::Program;

use crate::catalogue;
use crate::semantics::suggest;
use names::{Found, Names};
use parse::{Address, Bit, Expression, Parser};
pub use value::{Assignment, RegisterChange, RegisterValues, Value, ValueError};

/// What an expression stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// A bit in memory.
    Bit {
        /// Byte address.
        addr: Addr,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A cell in memory.
    Cell {
        /// First byte.
        addr: Addr,
        /// How it is read.
        width: Width,
    },
    /// A text buffer.
    Text {
        /// First byte.
        addr: Addr,
        /// Maximum number of characters; one byte more belongs to it.
        len: u32,
    },
    /// A register.
    Register(Register),
    /// A constant.
    Constant(i64),
    /// A mechanism: its activation bit. Index into `Program::sequences`.
    Mechanism(u16),
}

/// A register, or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Register {
    /// The one-bit register.
    Rlo,
    /// The data register, signed, all 64 bits.
    Dr,
    /// Its low bits, unsigned; [`Width::Real`] does not occur.
    DrPart(Width),
    /// The real register.
    DrReal,
    /// The index register.
    Bx,
}

/// Why an expression has no value. Columns are bytes of the expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExpressionError {
    /// Nothing was given.
    Empty,
    /// Something stands where it cannot: its column and itself; empty at the end of the expression.
    Unexpected(usize, String),
    /// A number that is malformed or too large.
    Number(String),
    /// The program does not know the name; what is most likely meant.
    Unknown(String, Option<String>),
    /// Several files have a local symbol of this name: the name and how to say which.
    Ambiguous(String, Vec<String>),
    /// The project has no such file.
    File(String),
    /// The name has no type of its own.
    NeedsType(String),
    /// The name has no memory: what it is instead.
    NotInMemory(String, &'static str),
    /// A bit was needed: the name.
    NotABit(String),
    /// A constant was needed: the name.
    NotAConstant(String),
    /// A system name that only stands for a bit position.
    BitPosition(String),
    /// The address is negative or past 32 bits.
    Address,
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ExpressionError::Empty => write!(f, "nothing to evaluate: give a name, for instance RLO"),
            ExpressionError::Unexpected(_, found) if found.is_empty() => {
                write!(f, "the expression is not complete")
            }
            ExpressionError::Unexpected(column, found) => {
                write!(f, "`{found}` at column {} is not expected here", column + 1)
            }
            ExpressionError::Number(text) => write!(f, "`{text}` is not a number: 248, 0F8h, 0xF8 or 0101b"),
            ExpressionError::Unknown(name, near) => {
                write!(f, "{name} is not declared in this program")?;
                near.as_ref().map_or(Ok(()), |near| write!(f, "; did you mean {near}?"))
            }
            ExpressionError::Ambiguous(name, choices) => {
                write!(f, "{name} is local in several files; say {}", choices.join(" or "))
            }
            ExpressionError::File(name) => write!(f, "the program has no file {name}"),
            ExpressionError::NeedsType(name) => {
                write!(
                    f,
                    "{name} has no type; say BYTE.{name}, WORD.{name}, DWRD.{name}, QWRD.{name} or REAL.{name}"
                )
            }
            ExpressionError::NotInMemory(name, what) => {
                write!(f, "{name} is {what} and has no value in memory")
            }
            ExpressionError::NotABit(name) => {
                write!(f, "{name} is not a bit; say its name or a number from 0 to 7")
            }
            ExpressionError::NotAConstant(name) => {
                write!(f, "{name} is not a constant; an offset needs a number")
            }
            ExpressionError::BitPosition(name) => {
                write!(f, "{name} stands for a bit position only; say a byte before it: adr.{name}")
            }
            ExpressionError::Address => write!(f, "the address lies outside of memory"),
        }
    }
}

impl std::error::Error for ExpressionError {}

/// Finds what `text` stands for, seen from the file with this place in execution order.
///
/// # Errors
/// What is wrong with the expression.
pub fn resolve(debug: &DebugInfo, file: Option<u8>, text: &str) -> Result<Target, ExpressionError> {
    let (text, file) = match text.rsplit_once(':') {
        // A colon in a character constant names no file.
        Some((name, rest)) if !name.contains('\'') => (rest, Some(names::file_order(debug, name.trim())?)),
        _ => (text, file),
    };
    if let Some(member) = block::resolve(text) {
        return member;
    }
    let names = Names { debug, file };
    match Parser::parse(text)? {
        Expression::Constant(value) => Ok(Target::Constant(value)),
        Expression::Name(name) => named(&names, &name),
        Expression::Cell { prefix, address } => cell(&names, prefix, &address),
        Expression::Bit { address, bit } => bit_at(&names, &address, &bit),
        Expression::SameByte { offset, bit } => {
            let Found::Bit { addr, bit } = names.find(&bit)? else {
                return Err(ExpressionError::NotABit(bit));
            };
            Ok(Target::Bit { addr: moved(addr, offset)?, bit })
        }
    }
}

/// The name of the program, or the predefined one, that a name nobody knows is most likely meant to be.
fn nearest<'a>(debug: &'a DebugInfo, name: &str) -> Option<&'a str> {
    let own = debug.symbols.iter().map(|symbol| symbol.name.as_str());
    suggest::nearest(name, own.chain(catalogue::symbols().map(|symbol| symbol.name)))
}

fn named(names: &Names<'_>, name: &str) -> Result<Target, ExpressionError> {
    if let Some(register) = Register::from_name(name) {
        return Ok(Target::Register(register));
    }
    match names.find(name)? {
        Found::Bit { addr, bit } => Ok(Target::Bit { addr, bit }),
        Found::Cell { addr, width } => Ok(Target::Cell { addr, width }),
        Found::Text { addr, len } => Ok(Target::Text { addr, len }),
        Found::Area { .. } => Err(ExpressionError::NeedsType(name.to_owned())),
        Found::Constant(value) => Ok(Target::Constant(value)),
        Found::Mechanism(sequence) => Ok(Target::Mechanism(sequence)),
        Found::BitPosition(_) => Err(ExpressionError::BitPosition(name.to_owned())),
        Found::Code(what) => Err(ExpressionError::NotInMemory(name.to_owned(), what)),
    }
}

fn cell(
    names: &Names<'_>,
    prefix: Option<parse::Prefix>,
    address: &Address,
) -> Result<Target, ExpressionError> {
    let (found, addr) = located(names, address)?;
    match (prefix, found) {
        (Some(prefix), _) => Ok(Target::Cell { addr: moved(addr, prefix.offset)?, width: prefix.width }),
        (None, Found::Cell { width, .. }) => Ok(Target::Cell { addr, width }),
        (None, _) => Err(ExpressionError::NeedsType(address.name.clone())),
    }
}

fn bit_at(names: &Names<'_>, address: &Address, bit: &Bit) -> Result<Target, ExpressionError> {
    let (_, addr) = located(names, address)?;
    let bit = match bit {
        Bit::Number(number) => *number,
        Bit::Name(name) => match names.find(name)? {
            Found::Bit { bit, .. } | Found::BitPosition(bit) => bit,
            _ => return Err(ExpressionError::NotABit(name.clone())),
        },
    };
    Ok(Target::Bit { addr, bit })
}

/// A name in memory and the address with its offsets.
fn located(names: &Names<'_>, address: &Address) -> Result<(Found, Addr), ExpressionError> {
    let found = names.find(&address.name)?;
    let base = match found {
        Found::Bit { addr, .. }
        | Found::Cell { addr, .. }
        | Found::Text { addr, .. }
        | Found::Area { addr } => addr,
        Found::Constant(_) => return Err(ExpressionError::NotInMemory(address.name.clone(), "a constant")),
        Found::Mechanism(_) => return Err(ExpressionError::NotInMemory(address.name.clone(), "a mechanism")),
        Found::BitPosition(_) => return Err(ExpressionError::BitPosition(address.name.clone())),
        Found::Code(what) => return Err(ExpressionError::NotInMemory(address.name.clone(), what)),
    };
    let mut offset = address.offset;
    for (minus, name) in &address.constants {
        let Found::Constant(value) = names.find(name)? else {
            return Err(ExpressionError::NotAConstant(name.clone()));
        };
        let value = if *minus { value.checked_neg() } else { Some(value) };
        offset = value.and_then(|v| offset.checked_add(v)).ok_or(ExpressionError::Address)?;
    }
    Ok((found, moved(base, offset)?))
}

fn moved(addr: Addr, offset: i64) -> Result<Addr, ExpressionError> {
    let moved = i64::from(addr).checked_add(offset).and_then(|addr| Addr::try_from(addr).ok());
    moved.ok_or(ExpressionError::Address)
}

impl Register {
    /// The register of that name, in any case.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Register> {
        let register = match name.to_ascii_uppercase().as_str() {
            "RLO" => Register::Rlo,
            "DR" => Register::Dr,
            "DR8" => Register::DrPart(Width::Byte),
            "DR16" => Register::DrPart(Width::Word),
            "DR32" => Register::DrPart(Width::DWord),
            "DR64" => Register::DrPart(Width::QWord),
            "DR_REAL" => Register::DrReal,
            "BX" => Register::Bx,
            _ => return None,
        };
        Some(register)
    }
}

impl Target {
    /// The bit or cell behind a mechanism; anything else as it is.
    #[must_use]
    pub fn in_memory(self, program: &Program) -> Target {
        let Target::Mechanism(sequence) = self else { return self };
        match program.sequences.get(usize::from(sequence)) {
            Some(cells) => Target::Bit { addr: cells.active_addr, bit: cells.active_bit },
            None => self,
        }
    }
}
