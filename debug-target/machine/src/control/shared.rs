//! Memory shared with screens and dialogs (manual 18): published cells and the two shared areas.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use technol_image::op::Addr;
use technol_image::service::{Arg, Service};
use technol_runtime::{Call, FaultKind, StateHash};

use super::data::Value;
use super::transfer::Transfers;

/// Length of a shared area in bytes.
pub(super) const AREA_LEN: usize = 32_000;
/// Error of SA_READ and SA_WRITE: the bytes do not lie in the area.
const OUTSIDE: i64 = 1;
/// Names of a program; more are not accepted.
const MAX_NAMES: usize = 10_000;

/// A published cell or bit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    /// Name for screens.
    pub name: Vec<u8>,
    call: u16,
    addr: Addr,
    len: u32,
    form: Form,
    limits: [Option<Addr>; 2],
}

/// How its bytes are seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Bit(u8),
    Signed,
    Unsigned,
    Real,
    Text,
    Bytes,
}

impl Shared {
    /// Its value in the memory of the program. An unsigned cell of 8 bytes above [`i64::MAX`] keeps its bits.
    #[must_use]
    pub fn value(&self, memory: &[u8]) -> Value {
        let start = self.addr as usize;
        let bytes = memory.get(start..start + self.len as usize).unwrap_or_default();
        match self.form {
            Form::Bit(bit) => Value::Int(i64::from(bytes.first().is_some_and(|byte| byte >> bit & 1 != 0))),
            Form::Signed | Form::Unsigned => Value::Int(number(bytes, self.form == Form::Signed)),
            Form::Real => Value::Real(real(memory, self.addr)),
            Form::Text => {
                let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
                Value::Text(bytes[..end].to_vec())
            }
            Form::Bytes => Value::Bytes(bytes.to_vec()),
        }
    }

    /// Smallest and largest value, as the cells hold them now.
    #[must_use]
    pub fn limits(&self, memory: &[u8]) -> [Option<f64>; 2] {
        self.limits.map(|limit| limit.map(|addr| real(memory, addr)))
    }
}

fn real(memory: &[u8], addr: Addr) -> f64 {
    let bytes = memory.get(addr as usize..addr as usize + 8).unwrap_or_default();
    bytes.try_into().map_or(0.0, f64::from_le_bytes)
}

fn number(bytes: &[u8], signed: bool) -> i64 {
    let negative = signed && bytes.last().is_some_and(|byte| *byte >= 0x80);
    let mut all = [if negative { 0xFF } else { 0 }; 8];
    for (place, byte) in all.iter_mut().zip(bytes) {
        *place = *byte;
    }
    i64::from_le_bytes(all)
}

/// The published cells and the areas.
#[derive(Clone, Debug)]
pub(super) struct SharedMemory {
    names: Vec<Shared>,
    areas: [Area; 2],
    transfers: Transfers<()>,
}

/// Its bytes.
#[derive(Clone)]
struct Area(Box<[u8]>);

impl fmt::Debug for Area {
    /// As a number: nobody reads 32,000 bytes, and the state of the control is told by what this shows.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#x}", StateHash::of_bytes(&self.0))
    }
}

impl Default for SharedMemory {
    fn default() -> SharedMemory {
        let area = || Area(alloc::vec![0; AREA_LEN].into_boxed_slice());
        SharedMemory { names: Vec::new(), areas: [area(), area()], transfers: Transfers::default() }
    }
}

impl SharedMemory {
    /// What the program published before is forgotten; the areas stay unless everything is as at power-on.
    pub(super) fn start(&mut self, cold: bool) {
        self.names.clear();
        self.transfers.forget();
        if cold {
            self.areas.iter_mut().for_each(|area| area.0.fill(0));
        }
    }

    /// Makes room for a SA_READ or SA_WRITE of the program.
    pub(super) fn prepare(&mut self, call: u16) {
        self.transfers.prepare(call, ());
    }

    /// What is published.
    pub(super) fn names(&self) -> &[Shared] {
        &self.names
    }

    /// An area, for screens.
    pub(super) fn area_mut(&mut self, area: usize) -> Option<&mut [u8]> {
        self.areas.get_mut(area).map(|area| &mut *area.0)
    }

    /// SHARE_VAR and SHARE_BIT: RLO tells whether the name was accepted.
    pub(super) fn share(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let accepted = match published(call)? {
            Some(new) => {
                // The same line may publish again.
                let taken = self.names.iter().any(|it| it.name == new.name && it.call != new.call);
                let free = !taken && !new.name.is_empty();
                if free {
                    self.names.retain(|it| it.name != new.name);
                }
                let room = free && self.names.len() < MAX_NAMES;
                if room {
                    self.names.push(new);
                }
                room
            }
            None => false,
        };
        call.set_rlo(accepted);
        Ok(())
    }

    /// SA_READ and SA_WRITE: the area is granted in the cycle after the first try.
    pub(super) fn exchange(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let number = |n: usize| Ok(usize::try_from(call.integer(n)?.unwrap_or(-1)).unwrap_or(usize::MAX));
        let (area, offset, size) = (number(0)?, number(1)?, number(2)?);
        let end = offset.checked_add(size).filter(|end| *end <= AREA_LEN);
        let place = self.areas.get_mut(area).zip(end).and_then(|(area, end)| area.0.get_mut(offset..end));
        let (Some(place), Some((addr, _))) = (place, call.area(3)?) else {
            call.set_rlo(false);
            call.set_dr(OUTSIDE);
            return Ok(());
        };
        if !self.transfers.is_under_way(call) {
            self.transfers.begin(call, |()| Ok(()))?;
        }
        let granted = self.transfers.end(call).is_some();
        if granted && call.service() == Service::SaRead {
            call.write(addr, place)?;
        } else if granted {
            place.copy_from_slice(call.bytes(addr, size as u32)?);
        }
        call.set_rlo(granted);
        call.set_dr(0);
        Ok(())
    }
}

/// What a call wants to publish; `None` when its bytes do not lie in memory.
fn published(call: &Call<'_>) -> Result<Option<Shared>, FaultKind> {
    let Some((addr, len)) = call.area(0)? else { return Ok(None) };
    let name = call.text(1)?.unwrap_or_default().to_vec();
    let (form, len) = if let Arg::Bit { bit, .. } = call.arg(2) {
        (Form::Bit(bit.bit), 1)
    } else {
        let word: String = call.keyword(2).unwrap_or_default().chars().filter(|c| *c != '_').collect();
        let (form, own) = form(&word);
        let given = match call.arg(3) {
            Arg::Int(given) => u32::try_from(*given).ok(),
            _ => None,
        };
        (form, own.or(given).unwrap_or(len))
    };
    if call.bytes(addr, len).is_err() {
        return Ok(None);
    }
    let mut limits = [None; 2];
    for (n, limit) in limits.iter_mut().enumerate() {
        *limit = call.area(3 + n)?.map(|(addr, _)| addr);
    }
    Ok(Some(Shared { name, call: call.index(), addr, len, form, limits }))
}

/// Form and length of a type, spelled without underscores.
fn form(word: &str) -> (Form, Option<u32>) {
    let width = |word: &str| match word {
        "8" => 1,
        "16" => 2,
        "32" => 4,
        _ => 8,
    };
    match word.strip_prefix("TYPE").unwrap_or(word) {
        "BIT" => (Form::Bit(0), Some(1)),
        "STR" => (Form::Text, None),
        "BIN" => (Form::Bytes, None),
        "REAL" => (Form::Real, Some(8)),
        "BYTE" => (Form::Unsigned, Some(1)),
        "WORD" => (Form::Unsigned, Some(2)),
        "DWORD" => (Form::Unsigned, Some(4)),
        word => match (word.strip_prefix("INT"), word.strip_prefix("UNS")) {
            (Some(bits), _) => (Form::Signed, Some(width(bits))),
            (_, Some(bits)) => (Form::Unsigned, Some(width(bits))),
            _ => (Form::Unsigned, Some(8)),
        },
    }
}
