//! Which values a sample of a subscription has: both ends work it out from the subscription.

use alloc::vec;
use alloc::vec::Vec;

use super::bits::mask;
use crate::message::{Failure, Item, ItemKind, MOST_STREAMS, Mode, Subject, Subscription, TracedRegister};

/// Most bytes of a sample in front of its values: head, number, cycle.
const FRONT: usize = 1 + 5 + 5;
/// Most bits of the number that tells how far extremes reach.
const REACH: u32 = 65;

/// The values of a sample, in order, with their widths.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Bits of each value: 1, 8, 16, 32 or 64.
    widths: Vec<u8>,
    extremes: bool,
}

impl Layout {
    /// The layout of a subscription's samples.
    ///
    /// # Errors
    /// [`Failure::OutOfRange`]: a number of stream, period, bit or width that there is not.
    pub fn of(subscription: &Subscription) -> Result<Layout, Failure> {
        if subscription.id >= MOST_STREAMS || subscription.period == 0 {
            return Err(Failure::OutOfRange);
        }
        let mut widths = Vec::new();
        let mut extremes = false;
        match &subscription.subject {
            Subject::Variables(items) => {
                for item in items {
                    let width = width(item.kind).ok_or(Failure::OutOfRange)?;
                    widths.push(width);
                    match item.mode {
                        Mode::Value | Mode::OnChange => {}
                        Mode::Extremes => {
                            extremes = true;
                            widths.extend([width, width]);
                        }
                        Mode::Edges => widths.extend([16, 16]),
                    }
                }
            }
            Subject::Mechanisms(sequences) => {
                widths = sequences.iter().flat_map(|_| [1, 16, 16, 32]).collect();
            }
            Subject::Trace { pcs, wide } => {
                let dr = if *wide { 64 } else { 32 };
                widths = pcs.iter().flat_map(|_| [1, 1, 1, dr]).collect();
            }
            Subject::Lines(lines) => {
                widths = lines.iter().flat_map(|line| [1, 1, 1, register_width(line.register)]).collect();
            }
        }
        Ok(Layout { widths, extremes })
    }

    /// Bits of each value.
    #[must_use]
    pub fn widths(&self) -> &[u8] {
        &self.widths
    }

    /// Number of values in a sample.
    #[must_use]
    pub fn len(&self) -> usize {
        self.widths.len()
    }

    /// There are no values.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.widths.is_empty()
    }

    /// Samples tell over how many numbers their extremes reach.
    pub(crate) fn has_extremes(&self) -> bool {
        self.extremes
    }

    /// Order of the code for the distance from one changed value to the next: the more values, the longer.
    pub(crate) fn order(&self) -> u32 {
        self.widths.len().max(1).ilog2() / 2
    }

    /// Bits of all values.
    pub(crate) fn bits(&self) -> u32 {
        self.widths.iter().map(|w| u32::from(*w)).sum()
    }

    /// Longest payload of a sample, in bytes.
    #[must_use]
    pub fn longest(&self) -> usize {
        let reach = if self.extremes { REACH } else { 0 };
        FRONT + (self.bits() + reach).div_ceil(8) as usize
    }

    pub(crate) fn zeros(&self) -> Vec<u64> {
        vec![0; self.widths.len()]
    }

    /// The bits of a value that count.
    pub(crate) fn clip(&self, index: usize, value: u64) -> u64 {
        value & self.widths.get(index).map_or(0, |w| mask(*w))
    }
}

/// Bits of an item's value; `None` for one that there is not.
fn width(kind: ItemKind) -> Option<u8> {
    match kind {
        ItemKind::Bit(0..=7) => Some(1),
        ItemKind::Unsigned(bytes @ (1 | 2 | 4 | 8)) | ItemKind::Signed(bytes @ (1 | 2 | 4 | 8)) => {
            Some(bytes * 8)
        }
        ItemKind::Real => Some(64),
        _ => None,
    }
}

fn register_width(register: TracedRegister) -> u8 {
    match register {
        TracedRegister::Dr32 => 32,
        TracedRegister::Dr64 | TracedRegister::Real => 64,
    }
}

/// Bytes of memory an item lies in.
pub(crate) fn bytes(item: Item) -> usize {
    match item.kind {
        ItemKind::Bit(_) => 1,
        ItemKind::Unsigned(n) | ItemKind::Signed(n) => usize::from(n),
        ItemKind::Real => 8,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::TracedLine;

    fn of(subject: Subject) -> Result<Vec<u8>, Failure> {
        Layout::of(&Subscription { id: 7, period: 1, subject }).map(|l| l.widths)
    }

    #[test]
    fn each_subject_has_its_values() {
        let item = |kind, mode| Item { addr: 0, kind, mode };
        assert_eq!(
            of(Subject::Variables(vec![
                item(ItemKind::Bit(7), Mode::Edges),
                item(ItemKind::Signed(2), Mode::Extremes),
                item(ItemKind::Real, Mode::OnChange),
                item(ItemKind::Unsigned(4), Mode::Value),
            ])),
            Ok(vec![1, 16, 16, 16, 16, 16, 64, 32])
        );
        assert_eq!(of(Subject::Mechanisms(vec![3, 1])), Ok(vec![1, 16, 16, 32, 1, 16, 16, 32]));
        assert_eq!(of(Subject::Trace { pcs: vec![5], wide: true }), Ok(vec![1, 1, 1, 64]));
        let lines = [(5, TracedRegister::Real), (9, TracedRegister::Dr32), (12, TracedRegister::Dr64)];
        let lines = lines.map(|(pc, register)| TracedLine { pc, register }).to_vec();
        assert_eq!(of(Subject::Lines(lines)), Ok(vec![1, 1, 1, 64, 1, 1, 1, 32, 1, 1, 1, 64]));
    }

    #[test]
    fn what_there_is_not_is_refused() {
        for kind in [ItemKind::Bit(8), ItemKind::Unsigned(3), ItemKind::Signed(0), ItemKind::Unsigned(255)] {
            let items = vec![Item { addr: 0, kind, mode: Mode::Value }];
            assert_eq!(of(Subject::Variables(items)), Err(Failure::OutOfRange));
        }
        let wrong =
            |id, period| Layout::of(&Subscription { id, period, subject: Subject::Mechanisms(vec![]) });
        assert_eq!(wrong(8, 1), Err(Failure::OutOfRange));
        assert_eq!(wrong(0, 0), Err(Failure::OutOfRange));
    }
}
