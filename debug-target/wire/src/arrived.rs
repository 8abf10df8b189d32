//! Which bytes of a download have arrived.

use alloc::vec::Vec;

/// Separate pieces that are remembered; a piece that would make one more is not taken and comes again.
const MAX_ISLANDS: usize = 16;

/// Which bytes of a download have arrived: disjoint ranges, ascending, never touching each other.
#[derive(Clone, Debug, Default)]
pub struct Arrived {
    ranges: Vec<(u32, u32)>,
}

impl Arrived {
    /// Adds `start..end`; true when it brought something new and was taken.
    pub fn add(&mut self, start: u32, end: u32) -> bool {
        if start >= end || self.ranges.iter().any(|r| r.0 <= start && end <= r.1) {
            return false;
        }
        // Ranges that overlap or touch the new one melt into it.
        let first = self.ranges.partition_point(|r| r.1 < start);
        let last = self.ranges.partition_point(|r| r.0 <= end);
        if first == last && self.ranges.len() > MAX_ISLANDS {
            return false;
        }
        let melted = self.ranges[first..last].iter().fold((start, end), |a, r| (a.0.min(r.0), a.1.max(r.1)));
        self.ranges.splice(first..last, [melted]);
        true
    }

    /// Nothing has arrived.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// All bytes before this offset have arrived.
    #[must_use]
    pub fn complete(&self) -> u32 {
        self.ranges.first().filter(|r| r.0 == 0).map_or(0, |r| r.1)
    }

    /// The pieces behind the first hole, as (offset, length).
    #[must_use]
    pub fn islands(&self) -> Vec<(u32, u32)> {
        self.ranges.iter().filter(|r| r.0 != 0).map(|r| (r.0, r.1 - r.0)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_melt_together_in_any_order() {
        let mut arrived = Arrived::default();
        assert!(arrived.add(20, 30));
        assert_eq!((arrived.complete(), arrived.islands()), (0, [(20, 10)].to_vec()));
        assert!(arrived.add(0, 10));
        assert!(arrived.add(40, 50));
        assert_eq!((arrived.complete(), arrived.islands()), (10, [(20, 10), (40, 10)].to_vec()));
        assert!(!arrived.add(22, 28), "known already");
        assert!(arrived.add(8, 22), "overlapping both sides");
        assert_eq!((arrived.complete(), arrived.islands()), (30, [(40, 10)].to_vec()));
        assert!(arrived.add(30, 40), "touching both sides");
        assert_eq!((arrived.complete(), arrived.islands()), (50, Vec::new()));
    }

    #[test]
    fn memory_is_bounded_whatever_arrives() {
        let mut arrived = Arrived::default();
        let taken = (0..1000_u32).filter(|n| arrived.add(10 + n * 10, 15 + n * 10)).count();
        assert_eq!(taken, MAX_ISLANDS + 1);
        assert!(arrived.add(0, 12), "what closes a hole is always taken");
    }
}
