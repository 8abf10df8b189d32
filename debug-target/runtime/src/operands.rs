//! Reading the second operand of an operation.

use technol_image::op::{Source, Width};

use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::registers::mask;

/// Integer operand, sign-extended. A real constant has no place here (rejected at load).
#[inline]
pub(crate) fn integer(memory: &Memory, source: &Source, width: Width, bx: u32) -> Result<i64, FaultKind> {
    match source {
        Source::Mem(place) => memory.read(*place, width, bx),
        Source::Int(value) => Ok(*value),
        Source::Real(value) => Ok(*value as i64),
    }
}

/// Real operand.
#[inline]
pub(crate) fn real(memory: &Memory, source: &Source, bx: u32) -> Result<f64, FaultKind> {
    match source {
        Source::Mem(place) => Ok(f64::from_bits(memory.read(*place, Width::Real, bx)? as u64)),
        Source::Int(value) => Ok(*value as f64),
        Source::Real(value) => Ok(*value),
    }
}

/// Operand as an unsigned number of `width` bits.
#[inline]
pub(crate) fn unsigned(memory: &Memory, source: &Source, width: Width, bx: u32) -> Result<u64, FaultKind> {
    Ok((integer(memory, source, width, bx)? & mask(width)) as u64)
}

/// Number of bits to shift by: a constant, or a cell read as an unsigned byte.
#[inline]
pub(crate) fn shift_count(memory: &Memory, source: &Source, bx: u32) -> Result<u64, FaultKind> {
    match source {
        Source::Mem(place) => Ok(memory.read(*place, Width::Byte, bx)? as u8 as u64),
        Source::Int(value) => Ok(*value as u64),
        Source::Real(value) => Ok(*value as u64),
    }
}
