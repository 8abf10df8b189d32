//! Messages longer than a frame: split into parts, put together again.
//!
//! The first payload byte of a part holds its index (bits 0 to 6) and whether it is the last one (bit 7).

use alloc::vec::Vec;

/// Most parts of one message.
pub(crate) const MAX_PARTS: usize = 128;
const LAST: u8 = 0x80;

/// Splits an encoded message into payloads of at most `max_payload` bytes; `None` when it is too long.
pub(crate) fn split(message: &[u8], max_payload: usize) -> Option<Vec<Vec<u8>>> {
    let room = max_payload.saturating_sub(1).max(1);
    let count = message.len().div_ceil(room).max(1);
    if count > MAX_PARTS {
        return None;
    }
    let part = |index: usize| {
        let piece = &message[(index * room).min(message.len())..((index + 1) * room).min(message.len())];
        let mut payload = Vec::with_capacity(piece.len() + 1);
        payload.push(index as u8 | if index + 1 == count { LAST } else { 0 });
        payload.extend_from_slice(piece);
        payload
    };
    Some((0..count).map(part).collect())
}

/// Puts the parts of one message together, in whatever order and however often they arrive.
#[derive(Clone, Debug, Default)]
pub(crate) struct Assembly {
    seq: u8,
    parts: Vec<Option<Vec<u8>>>,
    count: Option<usize>,
}

impl Assembly {
    /// Takes a part of message `seq`; the message when it is complete. A part of another message starts over.
    pub(crate) fn add(&mut self, seq: u8, payload: &[u8]) -> Option<Vec<u8>> {
        let (&head, piece) = payload.split_first()?;
        if seq != self.seq {
            self.clear();
            self.seq = seq;
        }
        let index = usize::from(head & !LAST);
        if self.parts.len() <= index {
            self.parts.resize(index + 1, None);
        }
        self.parts[index] = Some(piece.to_vec());
        if head & LAST != 0 {
            self.count = Some(index + 1);
        }
        let count = self.count?;
        let parts = self.parts.get(..count)?;
        if parts.iter().any(Option::is_none) {
            return None;
        }
        let message = parts.iter().flatten().flatten().copied().collect();
        self.clear();
        Some(message)
    }

    pub(crate) fn clear(&mut self) {
        self.parts.clear();
        self.count = None;
    }
}

/// Puts the parts of events together; they arrive in order.
#[derive(Clone, Debug, Default)]
pub(crate) struct InOrder {
    message: Vec<u8>,
}

impl InOrder {
    pub(crate) fn add(&mut self, payload: &[u8]) -> Option<Vec<u8>> {
        let (&head, piece) = payload.split_first()?;
        if head & !LAST == 0 {
            self.message.clear();
        }
        self.message.extend_from_slice(piece);
        (head & LAST != 0).then(|| core::mem::take(&mut self.message))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(len: usize) -> Vec<u8> {
        (0..len).map(|n| (n * 7) as u8).collect()
    }

    #[test]
    fn any_length_comes_back_in_any_order() {
        for len in [0, 1, 8, 9, 10, 18, 19, 127 * 9, 128 * 9] {
            let mut parts = split(&message(len), 10).unwrap();
            assert!(parts.iter().all(|p| p.len() <= 10));
            parts.reverse();
            let mut assembly = Assembly::default();
            let first = parts[0].clone();
            if parts.len() > 1 {
                assert_eq!(assembly.add(5, &first), None, "a repeated part completes nothing");
            }
            let mut done = parts.iter().filter_map(|p| assembly.add(5, p));
            assert_eq!(done.next(), Some(message(len)));
            assert_eq!(done.next(), None);
        }
    }

    #[test]
    fn a_message_of_more_than_128_parts_is_refused() {
        assert!(split(&message(128 * 9 + 1), 10).is_none());
    }

    #[test]
    fn a_part_of_another_message_starts_over() {
        let parts = split(&message(20), 10).unwrap();
        let mut assembly = Assembly::default();
        assert_eq!(assembly.add(1, &parts[0]), None);
        assert_eq!(assembly.add(2, &parts[1]), None);
        assert_eq!(assembly.add(2, &parts[2]), None);
        assert_eq!(assembly.add(2, &parts[0]), Some(message(20)));
    }
}
