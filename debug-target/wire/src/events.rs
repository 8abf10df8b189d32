//! The target's events on their way to the host: numbered, in order, repeated until acknowledged.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

/// Frames sent and not yet acknowledged.
const WINDOW: usize = 4;
/// Frames that wait; beyond this, events that only inform are dropped and counted.
pub(crate) const QUEUE: usize = 256;

/// Events, cut into frames.
#[derive(Clone, Debug, Default)]
pub(crate) struct EventQueue {
    frames: VecDeque<Vec<u8>>,
    /// Number of the first frame in the queue.
    first: u8,
    /// Frames at the front that need no sending at present.
    sent: usize,
    /// Frames at the front that were sent at least once, and so may be acknowledged.
    known: usize,
    /// When the oldest of them was last sent, or progress was last seen.
    since: u64,
}

impl EventQueue {
    pub(crate) fn is_full(&self) -> bool {
        self.frames.len() >= QUEUE
    }

    pub(crate) fn len(&self) -> usize {
        self.frames.len()
    }

    pub(crate) fn push(&mut self, parts: Vec<Vec<u8>>) {
        self.frames.extend(parts);
    }

    /// The next frame to send, with its number.
    pub(crate) fn next(&mut self, now: u64) -> Option<(u8, &[u8])> {
        if self.sent >= WINDOW {
            return None;
        }
        let frame = self.frames.get(self.sent)?;
        if self.sent == 0 {
            self.since = now;
        }
        let seq = self.first.wrapping_add(self.sent as u8);
        self.sent += 1;
        self.known = self.known.max(self.sent);
        Some((seq, frame))
    }

    /// All frames up to number `seq` have arrived.
    pub(crate) fn acknowledged(&mut self, seq: u8, now: u64) {
        let count = usize::from(seq.wrapping_sub(self.first)) + 1;
        if count <= self.known {
            self.frames.drain(..count);
            self.first = seq.wrapping_add(1);
            self.known -= count;
            self.sent = self.sent.saturating_sub(count);
            self.since = now;
        }
    }

    /// Sends everything again that was not acknowledged in time; answers when to look again.
    pub(crate) fn poll(&mut self, now: u64, resend_us: u64) -> Option<u64> {
        if self.sent > 0 && now >= self.since + resend_us {
            self.sent = 0;
            return Some(now);
        }
        (self.sent > 0).then_some(self.since + resend_us)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn drain(queue: &mut EventQueue, now: u64) -> Vec<u8> {
        let mut seqs = Vec::new();
        while let Some((seq, _)) = queue.next(now) {
            seqs.push(seq);
        }
        seqs
    }

    #[test]
    fn frames_are_repeated_until_acknowledged_and_keep_their_numbers() {
        let mut queue = EventQueue { first: 254, ..EventQueue::default() };
        for n in 0..6 {
            queue.push(vec![vec![n]]);
        }
        assert_eq!(drain(&mut queue, 0), [254, 255, 0, 1], "a window of four");
        queue.acknowledged(255, 10);
        assert_eq!(drain(&mut queue, 10), [2, 3]);
        queue.acknowledged(255, 20);
        queue.acknowledged(9, 20);
        assert_eq!(drain(&mut queue, 20), [], "old and wild acknowledgements change nothing");
        assert_eq!(queue.poll(100, 100), Some(110));
        assert_eq!(queue.poll(110, 100), Some(110));
        assert_eq!(drain(&mut queue, 110), [0, 1, 2, 3]);
        assert_eq!(queue.poll(210, 100), Some(210));
        queue.acknowledged(2, 215);
        assert_eq!(drain(&mut queue, 215), [3], "an acknowledgement that comes late still counts");
        queue.acknowledged(3, 220);
        assert_eq!(queue.poll(1000, 100), None);
    }
}
