//! PLC memory and the accesses of the program and of the debugger.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use technol_image::op::{Addr, BitRef, Place, Width};

use crate::fault::FaultKind;

/// A debugger access outside PLC memory, or a bit number above 7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AccessError {
    /// First byte.
    pub addr: Addr,
    /// Length in bytes.
    pub len: usize,
}

impl fmt::Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} bytes at address {:#x} are not in PLC memory", self.len, self.addr)
    }
}

impl core::error::Error for AccessError {}

/// PLC memory. Direct addresses were proven at load; indexed ones are checked at each access.
#[derive(Clone, Debug)]
pub(crate) struct Memory {
    bytes: Vec<u8>,
}

impl Memory {
    pub(crate) fn new(len: u32) -> Memory {
        Memory { bytes: vec![0; len as usize] }
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    pub(crate) fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.bytes
    }

    /// Effective address of an access of `len` bytes.
    #[inline]
    pub(crate) fn resolve(&self, addr: Addr, indexed: bool, bx: u32, len: u32) -> Result<usize, FaultKind> {
        if indexed { self.resolve_indexed(addr, bx, len) } else { Ok(addr as usize) }
    }

    #[inline(never)]
    fn resolve_indexed(&self, addr: Addr, bx: u32, len: u32) -> Result<usize, FaultKind> {
        let effective = i64::from(addr) + i64::from(bx as i32);
        let inside = effective >= 0 && effective + i64::from(len) <= self.bytes.len() as i64;
        if inside { Ok(effective as usize) } else { Err(FaultKind::BadAddress { addr: effective, len }) }
    }

    /// Integer cell, sign-extended.
    #[inline]
    pub(crate) fn read(&self, place: Place, width: Width, bx: u32) -> Result<i64, FaultKind> {
        let at = self.resolve(place.addr, place.indexed, bx, width.bytes())?;
        Ok(self.read_at(at, width))
    }

    #[inline]
    pub(crate) fn read_at(&self, at: usize, width: Width) -> i64 {
        match width {
            Width::Byte => i64::from(self.bytes[at] as i8),
            Width::Word => i64::from(i16::from_le_bytes(self.array(at))),
            Width::DWord => i64::from(i32::from_le_bytes(self.array(at))),
            Width::QWord | Width::Real => i64::from_le_bytes(self.array(at)),
        }
    }

    /// Integer cell from the low bits of `value`.
    #[inline]
    pub(crate) fn write(&mut self, place: Place, width: Width, bx: u32, value: i64) -> Result<(), FaultKind> {
        let at = self.resolve(place.addr, place.indexed, bx, width.bytes())?;
        self.write_at(at, width, value);
        Ok(())
    }

    #[inline]
    pub(crate) fn write_at(&mut self, at: usize, width: Width, value: i64) {
        match width {
            Width::Byte => self.bytes[at] = value as u8,
            Width::Word => self.store(at, (value as u16).to_le_bytes()),
            Width::DWord => self.store(at, (value as u32).to_le_bytes()),
            Width::QWord | Width::Real => self.store(at, value.to_le_bytes()),
        }
    }

    #[inline]
    pub(crate) fn bit(&self, bit: BitRef, bx: u32) -> Result<bool, FaultKind> {
        let at = self.resolve(bit.addr, bit.indexed, bx, 1)?;
        Ok(self.bytes[at] >> bit.bit & 1 != 0)
    }

    #[inline]
    pub(crate) fn set_bit(&mut self, bit: BitRef, bx: u32, value: bool) -> Result<(), FaultKind> {
        let at = self.resolve(bit.addr, bit.indexed, bx, 1)?;
        let byte = &mut self.bytes[at];
        *byte = *byte & !(1 << bit.bit) | u8::from(value) << bit.bit;
        Ok(())
    }

    /// A bit whose address is known to lie in memory (system cells, activation bits).
    pub(crate) fn flag(&self, bit: BitRef) -> bool {
        self.bytes[bit.addr as usize] >> bit.bit & 1 != 0
    }

    /// Writes a bit whose address is known to lie in memory.
    pub(crate) fn set_flag(&mut self, bit: BitRef, value: bool) {
        let byte = &mut self.bytes[bit.addr as usize];
        *byte = *byte & !(1 << bit.bit) | u8::from(value) << bit.bit;
    }

    pub(crate) fn word(&self, addr: Addr) -> u16 {
        u16::from_le_bytes(self.array(addr as usize))
    }

    pub(crate) fn set_word(&mut self, addr: Addr, value: u16) {
        self.store(addr as usize, value.to_le_bytes());
    }

    pub(crate) fn set_dword(&mut self, addr: Addr, value: u32) {
        self.store(addr as usize, value.to_le_bytes());
    }

    pub(crate) fn real(&self, addr: Addr) -> f64 {
        f64::from_le_bytes(self.array(addr as usize))
    }

    pub(crate) fn set_real(&mut self, addr: Addr, value: f64) {
        self.store(addr as usize, value.to_le_bytes());
    }

    pub(crate) fn byte(&self, addr: Addr) -> u8 {
        self.bytes[addr as usize]
    }

    pub(crate) fn set_byte(&mut self, addr: Addr, value: u8) {
        self.bytes[addr as usize] = value;
    }

    pub(crate) fn fill(&mut self, addr: usize, len: usize, value: u8) {
        self.bytes[addr..addr + len].fill(value);
    }

    pub(crate) fn copy(&mut self, src: usize, dst: usize, len: usize) {
        self.bytes.copy_within(src..src + len, dst);
    }

    /// Debugger write.
    pub(crate) fn poke(&mut self, addr: Addr, bytes: &[u8]) -> Result<(), AccessError> {
        let start = addr as usize;
        let target = start.checked_add(bytes.len()).and_then(|end| self.bytes.get_mut(start..end));
        target.ok_or(AccessError { addr, len: bytes.len() })?.copy_from_slice(bytes);
        Ok(())
    }

    #[inline]
    fn array<const N: usize>(&self, at: usize) -> [u8; N] {
        let mut out = [0; N];
        out.copy_from_slice(&self.bytes[at..at + N]);
        out
    }

    #[inline]
    fn store<const N: usize>(&mut self, at: usize, bytes: [u8; N]) {
        self.bytes[at..at + N].copy_from_slice(&bytes);
    }
}
