//! What devices on a bus hold: values with a key, some of them only to be read.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

/// Why a value was not written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refused {
    Missing,
    ReadOnly,
    TooShort,
    TooLong,
}

#[derive(Clone, Debug)]
struct Object {
    value: Vec<u8>,
    power_on: Vec<u8>,
    read_only: bool,
}

/// The values of a device by their keys.
#[derive(Clone, Debug)]
pub(super) struct Objects<K> {
    all: BTreeMap<K, Object>,
}

impl<K> Default for Objects<K> {
    fn default() -> Objects<K> {
        Objects { all: BTreeMap::new() }
    }
}

impl<K: Ord> Objects<K> {
    /// Adds a value as it is at power-on, or replaces it.
    pub(super) fn set(&mut self, key: K, value: &[u8], read_only: bool) {
        self.all.insert(key, Object { value: value.to_vec(), power_on: value.to_vec(), read_only });
    }

    pub(super) fn get(&self, key: &K) -> Option<&[u8]> {
        self.all.get(key).map(|object| object.value.as_slice())
    }

    /// Some key is in this range.
    pub(super) fn has(&self, keys: core::ops::RangeInclusive<K>) -> bool {
        self.all.range(keys).next().is_some()
    }

    /// From the bus: the length must be that of the value.
    pub(super) fn write(&mut self, key: &K, value: &[u8]) -> Result<(), Refused> {
        let object = self.all.get_mut(key).ok_or(Refused::Missing)?;
        if object.read_only {
            return Err(Refused::ReadOnly);
        }
        match value.len().cmp(&object.value.len()) {
            core::cmp::Ordering::Less => Err(Refused::TooShort),
            core::cmp::Ordering::Greater => Err(Refused::TooLong),
            core::cmp::Ordering::Equal => {
                object.value.copy_from_slice(value);
                Ok(())
            }
        }
    }

    /// From the device itself: as many bytes as the value has.
    pub(super) fn update(&mut self, key: &K, value: &[u8]) {
        if let Some(object) = self.all.get_mut(key)
            && let Some(value) = value.get(..object.value.len())
        {
            object.value.copy_from_slice(value);
        }
    }

    /// All values as at power-on.
    pub(super) fn restore(&mut self) {
        for object in self.all.values_mut() {
            object.value.clone_from(&object.power_on);
        }
    }
}

/// A dictionary of CANopen: index and subindex.
pub(super) type Dictionary = Objects<(u16, u8)>;

/// Codes with which CANopen refuses an access.
pub(super) mod abort {
    pub(in super::super) const COMMAND: u32 = 0x0504_0001;
    pub(in super::super) const ACCESS: u32 = 0x0601_0000;
    pub(in super::super) const READ_ONLY: u32 = 0x0601_0002;
    pub(in super::super) const NO_OBJECT: u32 = 0x0602_0000;
    pub(in super::super) const TOO_LONG: u32 = 0x0607_0012;
    pub(in super::super) const TOO_SHORT: u32 = 0x0607_0013;
    pub(in super::super) const NO_SUBINDEX: u32 = 0x0609_0011;
}

impl Dictionary {
    /// The value of an object, or the code of CANopen.
    pub(super) fn upload(&self, index: u16, subindex: u8) -> Result<&[u8], u32> {
        self.get(&(index, subindex)).ok_or_else(|| self.missing(index))
    }

    /// Writes an object, or tells the code of CANopen.
    pub(super) fn download(&mut self, index: u16, subindex: u8, value: &[u8]) -> Result<(), u32> {
        self.write(&(index, subindex), value).map_err(|refused| match refused {
            Refused::Missing => self.missing(index),
            Refused::ReadOnly => abort::READ_ONLY,
            Refused::TooShort => abort::TOO_SHORT,
            Refused::TooLong => abort::TOO_LONG,
        })
    }

    fn missing(&self, index: u16) -> u32 {
        if self.has((index, 0)..=(index, u8::MAX)) { abort::NO_SUBINDEX } else { abort::NO_OBJECT }
    }
}
