//! Reading PLC memory in as few round trips as the target allows.

use std::collections::BTreeMap;

use technol_image::op::Addr;

/// A gap this small, in bytes, is read along: naming a further piece costs as much.
const GAP: u32 = 6;

/// What has to be read.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReadPlan {
    wanted: Vec<(Addr, u32)>,
}

impl ReadPlan {
    pub(crate) fn want(&mut self, addr: Addr, len: u32) {
        if len > 0 {
            self.wanted.push((addr, len));
        }
    }

    /// The pieces of each request, none longer than `max_read` bytes in all.
    pub(crate) fn requests(mut self, max_read: u16) -> Vec<Vec<(Addr, u16)>> {
        self.wanted.sort_unstable();
        let mut merged: Vec<(Addr, u32)> = Vec::new();
        for (addr, len) in self.wanted {
            let end = addr.saturating_add(len);
            match merged.last_mut() {
                Some((start, size)) if addr <= start.saturating_add(*size).saturating_add(GAP) => {
                    *size = (*size).max(end - *start);
                }
                _ => merged.push((addr, end - addr)),
            }
        }
        let most = u32::from(max_read.max(1));
        let mut requests = Vec::new();
        let mut request = Vec::new();
        let mut room = most;
        for (mut addr, mut len) in merged {
            while len > 0 {
                if room == 0 {
                    requests.push(std::mem::take(&mut request));
                    room = most;
                }
                let piece = len.min(room);
                request.push((addr, piece as u16));
                addr += piece;
                len -= piece;
                room -= piece;
            }
        }
        if !request.is_empty() {
            requests.push(request);
        }
        requests
    }
}

/// Memory as it was read.
#[derive(Clone, Debug, Default)]
pub(crate) struct MemoryView {
    /// Ascending, not touching each other.
    spans: Vec<(Addr, Vec<u8>)>,
    /// Known from elsewhere, by address and length.
    known: BTreeMap<(Addr, u32), Vec<u8>>,
}

impl MemoryView {
    /// Adds the answer to one request; false when it is shorter than asked for.
    pub(crate) fn add(&mut self, pieces: &[(Addr, u16)], bytes: &[u8]) -> bool {
        let mut rest = bytes;
        for (addr, len) in pieces {
            let Some((piece, tail)) = rest.split_at_checked(usize::from(*len)) else { return false };
            rest = tail;
            match self.spans.last_mut() {
                Some((start, span)) if *start as usize + span.len() == *addr as usize => span.extend(piece),
                _ => self.spans.push((*addr, piece.to_vec())),
            }
        }
        true
    }

    /// Adds a number that is known without reading.
    pub(crate) fn know(&mut self, addr: Addr, len: u32, number: u64) {
        let bytes = number.to_le_bytes();
        self.known.insert((addr, len), bytes[..bytes.len().min(len as usize)].to_vec());
    }

    /// The bytes at `addr`; empty when they were not read.
    pub(crate) fn bytes(&self, addr: Addr, len: u32) -> &[u8] {
        if let Some(bytes) = self.known.get(&(addr, len)) {
            return bytes;
        }
        let at = self.spans.partition_point(|(start, _)| *start <= addr);
        let span = at.checked_sub(1).and_then(|n| self.spans.get(n));
        span.and_then(|(start, bytes)| {
            let from = (addr - start) as usize;
            bytes.get(from..from.checked_add(len as usize)?)
        })
        .unwrap_or(&[])
    }

    /// A little-endian number.
    pub(crate) fn number(&self, addr: Addr, len: u32) -> u64 {
        self.bytes(addr, len).iter().rev().fold(0, |n, b| n << 8 | u64::from(*b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn neighbours_are_read_together() {
        let mut plan = ReadPlan::default();
        for (addr, len) in [(100, 2), (0, 4), (104, 1), (4, 2), (102, 1), (300, 8)] {
            plan.want(addr, len);
        }
        assert_eq!(plan.clone().requests(1000), [vec![(0, 6), (100, 5), (300, 8)]]);
        assert_eq!(plan.requests(10), [vec![(0, 6), (100, 4)], vec![(104, 1), (300, 8)]]);
    }

    proptest! {
        #[test]
        fn all_that_is_wanted_is_read(
            wanted in prop::collection::vec((0_u32..2000, 1_u32..300), 0..30),
            max_read in 1_u16..500,
        ) {
            let memory: Vec<u8> = (0..3000_u32).map(|n| (n * 7 + n / 256) as u8).collect();
            let mut plan = ReadPlan::default();
            for (addr, len) in &wanted {
                plan.want(*addr, *len);
            }
            let mut view = MemoryView::default();
            for pieces in plan.requests(max_read) {
                prop_assert!(pieces.iter().map(|p| u32::from(p.1)).sum::<u32>() <= u32::from(max_read));
                let bytes: Vec<u8> = pieces
                    .iter()
                    .flat_map(|(a, n)| memory[*a as usize..*a as usize + usize::from(*n)].iter().copied())
                    .collect();
                prop_assert!(view.add(&pieces, &bytes));
            }
            for (addr, len) in wanted {
                prop_assert_eq!(view.bytes(addr, len), &memory[addr as usize..(addr + len) as usize]);
            }
        }
    }
}
