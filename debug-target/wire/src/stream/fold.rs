//! What happens to memory between two samples: nothing is missed that lasts a millisecond.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::layout;
use crate::message::{Failure, Item, ItemKind, Mode};

/// An item with what has been seen of it.
#[derive(Clone, Debug)]
struct Watched {
    item: Item,
    previous: u64,
    /// Since the last sample was taken.
    least: u64,
    greatest: u64,
    /// Of the last sample taken, for the next one in case it is not sent.
    held: (u64, u64),
    rises: u16,
    falls: u16,
}

impl Watched {
    fn read(&self, memory: &[u8]) -> u64 {
        let start = self.item.addr as usize;
        let bytes = memory.get(start..start.saturating_add(layout::bytes(self.item))).unwrap_or(&[]);
        let number = bytes.iter().rev().fold(0, |n, b| n << 8 | u64::from(*b));
        match self.item.kind {
            ItemKind::Bit(bit) => number >> (bit & 7) & 1,
            _ => number,
        }
    }

    fn compare(&self, a: u64, b: u64) -> Ordering {
        match self.item.kind {
            ItemKind::Bit(_) | ItemKind::Unsigned(_) => a.cmp(&b),
            ItemKind::Signed(bytes) => {
                let unused = 64_u32.saturating_sub(u32::from(bytes) * 8);
                (((a << unused) as i64) >> unused).cmp(&(((b << unused) as i64) >> unused))
            }
            ItemKind::Real => f64::from_bits(a).total_cmp(&f64::from_bits(b)),
        }
    }

    fn observe(&mut self, memory: &[u8]) {
        let now = self.read(memory);
        match self.compare(now, self.previous) {
            Ordering::Less => self.falls = self.falls.wrapping_add(1),
            Ordering::Greater => self.rises = self.rises.wrapping_add(1),
            Ordering::Equal => {}
        }
        self.previous = now;
        self.widen(now);
    }

    fn widen(&mut self, value: u64) {
        if self.compare(value, self.least) == Ordering::Less {
            self.least = value;
        }
        if self.compare(value, self.greatest) == Ordering::Greater {
            self.greatest = value;
        }
    }

    /// A sample is taken: its extremes, with those of the one before it if that was not `sent`.
    fn close(&mut self, sent: bool) -> (u64, u64) {
        if !sent {
            self.widen(self.held.0);
            self.widen(self.held.1);
        }
        self.held = (self.least, self.greatest);
        (self.least, self.greatest) = (self.previous, self.previous);
        self.held
    }
}

/// The variables of a subscription.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    watched: Vec<Watched>,
    /// Has items that are looked at between samples.
    pub(crate) folds: bool,
    /// Has items whose change makes a sample due.
    pub(crate) on_change: bool,
    /// The last sample taken is on its way.
    sent: bool,
}

impl Watch {
    /// Begins with what is in memory now.
    pub(crate) fn new(items: &[Item], memory: &[u8]) -> Result<Watch, Failure> {
        let mut watched = Vec::with_capacity(items.len());
        for item in items {
            let end = (item.addr as usize).checked_add(layout::bytes(*item));
            end.filter(|end| *end <= memory.len()).ok_or(Failure::OutOfRange)?;
            let mut new =
                Watched { item: *item, previous: 0, least: 0, greatest: 0, held: (0, 0), rises: 0, falls: 0 };
            let value = new.read(memory);
            (new.previous, new.least, new.greatest, new.held) = (value, value, value, (value, value));
            watched.push(new);
        }
        let any = |modes: &[Mode]| items.iter().any(|i| modes.contains(&i.mode));
        Ok(Watch {
            watched,
            folds: any(&[Mode::Extremes, Mode::Edges]),
            on_change: any(&[Mode::OnChange]),
            sent: true,
        })
    }

    /// Looks at the memory; of use to the items that fold only.
    pub(crate) fn observe(&mut self, memory: &[u8]) {
        for watched in &mut self.watched {
            if matches!(watched.item.mode, Mode::Extremes | Mode::Edges) {
                watched.observe(memory);
            }
        }
    }

    /// Whether an item whose change makes a sample due differs from the sample `last`.
    pub(crate) fn has_changed(&self, memory: &[u8], last: &[u64]) -> bool {
        let mut slot = 0;
        self.watched.iter().any(|watched| {
            let value = last.get(slot);
            slot += slots(watched.item.mode);
            watched.item.mode == Mode::OnChange && value.is_some_and(|v| *v != watched.read(memory))
        })
    }

    /// Writes the values of a sample.
    pub(crate) fn sample(&mut self, memory: &[u8], values: &mut [u64]) {
        self.observe(memory);
        let mut slot = 0;
        let sent = core::mem::take(&mut self.sent);
        for watched in &mut self.watched {
            let of_item = match watched.item.mode {
                Mode::Value | Mode::OnChange => [watched.read(memory), 0, 0],
                Mode::Extremes => {
                    let (least, greatest) = watched.close(sent);
                    [watched.previous, least, greatest]
                }
                Mode::Edges => [watched.previous, u64::from(watched.rises), u64::from(watched.falls)],
            };
            let count = slots(watched.item.mode);
            if let Some(place) = values.get_mut(slot..slot + count) {
                place.copy_from_slice(&of_item[..count]);
            }
            slot += count;
        }
    }

    /// The last sample taken is on its way: the next one tells about what came after it.
    pub(crate) fn sent(&mut self) {
        self.sent = true;
    }
}

/// Values of an item in a sample.
const fn slots(mode: Mode) -> usize {
    match mode {
        Mode::Value | Mode::OnChange => 1,
        Mode::Extremes | Mode::Edges => 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn watch(kind: ItemKind, mode: Mode, memory: &[u8]) -> Watch {
        Watch::new(&[Item { addr: 1, kind, mode }], memory).unwrap()
    }

    #[test]
    fn a_pulse_between_two_samples_is_counted() {
        let mut watch = watch(ItemKind::Bit(3), Mode::Edges, &[0, 0]);
        for byte in [8, 8, 0, 9, 1, 0xF7] {
            watch.observe(&[0, byte]);
        }
        let mut values = vec![9; 3];
        watch.sample(&[0, 8], &mut values);
        assert_eq!(values, [1, 3, 2]);
        watch.sent();
        watch.sample(&[0, 0], &mut values);
        assert_eq!(values, [0, 3, 3], "edges are counted on");
    }

    #[test]
    fn extremes_are_those_since_the_last_sample_and_know_the_sign() {
        for (kind, expected) in [(ItemKind::Unsigned(1), [5, 5, 0xF0]), (ItemKind::Signed(1), [5, 0xF0, 7])] {
            let mut watch = watch(kind, Mode::Extremes, &[0, 5]);
            watch.observe(&[0, 0xF0]);
            watch.observe(&[0, 7]);
            let mut values = vec![0; 3];
            watch.sample(&[0, 5], &mut values);
            assert_eq!(values, expected);
            watch.sample(&[0, 5], &mut values);
            assert_eq!(values, expected, "a sample that was not sent is part of the next one");
            watch.sent();
            watch.sample(&[0, 6], &mut values);
            assert_eq!(values, [6, 5, 6]);
        }
        let real = |x: f64| [&[0][..], &x.to_le_bytes()].concat();
        let mut watch = watch(ItemKind::Real, Mode::Extremes, &real(1.0));
        watch.observe(&real(-2.5));
        let mut values = vec![0; 3];
        watch.sample(&real(0.5), &mut values);
        assert_eq!(values.iter().map(|v| f64::from_bits(*v)).collect::<Vec<_>>(), [0.5, -2.5, 1.0]);
    }

    #[test]
    fn an_item_past_the_end_of_memory_is_refused() {
        let item = |addr| Item { addr, kind: ItemKind::Unsigned(4), mode: Mode::Value };
        assert!(Watch::new(&[item(4)], &[0; 8]).is_ok());
        assert_eq!(Watch::new(&[item(5)], &[0; 8]).err(), Some(Failure::OutOfRange));
        assert_eq!(Watch::new(&[item(u32::MAX)], &[0; 8]).err(), Some(Failure::OutOfRange));
    }
}
