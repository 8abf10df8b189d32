//! The host's side of a download: offset-addressed pieces, a window, selective repeat.

use alloc::vec::Vec;

use crate::message::ChunkAck;

/// Room for offset and length in the encoding of a chunk.
const CHUNK_OVERHEAD: usize = 8;
const FIRST_TIMEOUT_US: u64 = 1_000_000;
const LEAST_TIMEOUT_US: u64 = 200_000;
const MOST_TIMEOUT_US: u64 = 5_000_000;
/// A timeout that came too early doubles the next one, up to this.
const MOST_BACKOFF_US: u64 = 2_500_000;

#[derive(Clone, Debug)]
struct InFlight {
    start: usize,
    end: usize,
    /// Position in the order of sending.
    order: u64,
    at: u64,
    resend: bool,
    repeated: bool,
    timeouts: u32,
}

/// A download in progress.
#[derive(Clone, Debug)]
pub(crate) struct Download {
    bytes: Vec<u8>,
    /// `seq` of the frames: that of the request that announced the download.
    pub(crate) tag: u8,
    piece: usize,
    window: usize,
    next: usize,
    in_flight: Vec<InFlight>,
    sent: u64,
    acknowledged: usize,
    smoothed_us: Option<u64>,
}

impl Download {
    pub(crate) fn new(bytes: Vec<u8>, tag: u8, max_payload: usize, window: usize) -> Self {
        Download {
            bytes,
            tag,
            piece: max_payload.saturating_sub(CHUNK_OVERHEAD).max(1),
            window: window.max(1),
            next: 0,
            in_flight: Vec::new(),
            sent: 0,
            acknowledged: 0,
            smoothed_us: None,
        }
    }

    pub(crate) fn total(&self) -> usize {
        self.bytes.len()
    }

    /// Bytes that have arrived for certain.
    pub(crate) fn acknowledged(&self) -> usize {
        self.acknowledged
    }

    pub(crate) fn is_done(&self) -> bool {
        self.next == self.bytes.len() && self.in_flight.is_empty()
    }

    /// The next piece to send: first what has to be repeated.
    pub(crate) fn next(&mut self, now: u64) -> Option<(u32, &[u8])> {
        let order = self.sent;
        let (start, end) = if let Some(lost) = self.in_flight.iter_mut().find(|p| p.resend) {
            lost.resend = false;
            lost.repeated = true;
            lost.order = order;
            lost.at = now;
            (lost.start, lost.end)
        } else {
            if self.in_flight.len() >= self.window || self.next >= self.bytes.len() {
                return None;
            }
            let start = self.next;
            let end = (start + self.piece).min(self.bytes.len());
            self.next = end;
            self.in_flight.push(InFlight {
                start,
                end,
                order,
                at: now,
                resend: false,
                repeated: false,
                timeouts: 0,
            });
            (start, end)
        };
        self.sent += 1;
        Some((start as u32, &self.bytes[start..end]))
    }

    /// Takes an acknowledgement. What was sent before a piece that has arrived, and has not arrived itself, is
    /// taken for lost.
    pub(crate) fn take_ack(&mut self, ack: &ChunkAck, now: u64) {
        let has = |p: &InFlight| {
            p.end <= ack.complete as usize
                || ack.islands.iter().any(|(at, len)| {
                    *at as usize <= p.start && p.end as u64 <= u64::from(*at) + u64::from(*len)
                })
        };
        let mut newest = None;
        let mut sample = None;
        let mut arrived = 0;
        for piece in self.in_flight.iter().filter(|p| has(p)) {
            arrived += piece.end - piece.start;
            // A piece that was repeated says nothing about which of its copies arrived, or when; nor does one that
            // the target had already.
            if !piece.repeated && ack.complete as usize <= self.next {
                newest = newest.max(Some(piece.order));
                sample = Some(now.saturating_sub(piece.at));
            }
        }
        // What the target has kept of an earlier attempt is not sent again.
        let kept = (ack.complete as usize).min(self.bytes.len());
        if kept > self.next {
            arrived += kept - self.next;
            self.next = kept;
        }
        if arrived == 0 {
            return;
        }
        self.acknowledged += arrived;
        self.in_flight.retain(|p| !has(p));
        if let Some(sample) = sample {
            self.smoothed_us = Some(self.smoothed_us.map_or(sample, |old| (old * 7 + sample) / 8));
        }
        for piece in &mut self.in_flight {
            piece.resend |= Some(piece.order) < newest;
        }
    }

    /// Marks what has to be repeated; answers when to look again, or `Err` when nothing arrives any more.
    pub(crate) fn poll(&mut self, now: u64, retries: u32) -> Result<Option<u64>, NoProgress> {
        let timeout = self
            .smoothed_us
            .map_or(FIRST_TIMEOUT_US, |rtt| (rtt * 3).clamp(LEAST_TIMEOUT_US, MOST_TIMEOUT_US));
        let mut timed_out = false;
        for piece in self.in_flight.iter_mut().filter(|p| !p.resend) {
            if now >= piece.at + timeout {
                piece.resend = true;
                piece.timeouts += 1;
                timed_out = true;
            }
        }
        if self.in_flight.iter().any(|p| p.timeouts > retries) {
            return Err(NoProgress);
        }
        if timed_out {
            // Perhaps nothing was lost and the line is just slow. Repeated pieces give no new sample, so without
            // this an estimate that is too short would stay so.
            let longer =
                self.smoothed_us.map_or(FIRST_TIMEOUT_US / 3, |rtt| rtt.max(LEAST_TIMEOUT_US / 3)) * 2;
            let most = self.smoothed_us.unwrap_or_default().max(MOST_BACKOFF_US / 3);
            self.smoothed_us = Some(longer.min(most));
            return Ok(Some(now));
        }
        Ok(self.in_flight.iter().filter(|p| !p.resend).map(|p| p.at + timeout).min())
    }
}

/// The target no longer acknowledges anything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoProgress;

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn offsets(download: &mut Download, now: u64) -> Vec<u32> {
        let mut out = Vec::new();
        while let Some((offset, _)) = download.next(now) {
            out.push(offset);
        }
        out
    }

    #[test]
    fn only_the_lost_piece_is_repeated() {
        let mut download = Download::new(vec![1; 95], 0, 10 + CHUNK_OVERHEAD, 4);
        assert_eq!(offsets(&mut download, 0), [0, 10, 20, 30]);
        download.take_ack(&ChunkAck { complete: 10, islands: vec![(20, 10)] }, 5);
        assert_eq!(offsets(&mut download, 5), [10, 40, 50], "the hole first, then on");
        download.take_ack(&ChunkAck { complete: 60, islands: vec![] }, 9);
        assert_eq!(offsets(&mut download, 9), [60, 70, 80, 90]);
        assert!(!download.is_done());
        download.take_ack(&ChunkAck { complete: 95, islands: vec![] }, 12);
        assert!(download.is_done());
        assert_eq!(download.acknowledged(), 95);
    }

    #[test]
    fn silence_repeats_and_then_gives_up() {
        let mut download = Download::new(vec![1; 5], 0, 100, 4);
        assert_eq!(offsets(&mut download, 0), [0]);
        assert_eq!(download.poll(0, 2), Ok(Some(1_000_000)));
        for now in [1_000_000, 3_000_000] {
            assert_eq!(download.poll(now, 2), Ok(Some(now)));
            assert_eq!(offsets(&mut download, now), [0]);
            assert_eq!(
                download.poll(now, 2).map(|next| next > Some(now + 1_900_000)),
                Ok(true),
                "longer each time"
            );
        }
        assert_eq!(download.poll(5_600_000, 2), Err(NoProgress));
    }

    #[test]
    fn a_line_that_is_slower_than_thought_is_given_more_time() {
        let mut download = Download::new(vec![1; 50], 0, 10 + CHUNK_OVERHEAD, 1);
        offsets(&mut download, 0);
        download.take_ack(&ChunkAck { complete: 10, islands: vec![] }, 5_000);
        // From now on an answer takes half a second.
        let (mut now, mut repeated) = (5_000, 0);
        for complete in [20, 30, 40, 50] {
            offsets(&mut download, now);
            let answer = now + 500_000;
            while let Ok(Some(next)) = download.poll(now, 12)
                && next < answer
            {
                now = next.max(now + 1);
                repeated += offsets(&mut download, now).len();
            }
            now = answer;
            download.take_ack(&ChunkAck { complete, islands: vec![] }, now);
        }
        assert!(download.is_done());
        assert!(repeated <= 2, "{repeated} pieces were sent twice");
    }

    #[test]
    fn what_the_target_has_kept_is_not_sent_again() {
        let mut download = Download::new(vec![1; 95], 0, 10 + CHUNK_OVERHEAD, 4);
        assert_eq!(offsets(&mut download, 0), [0, 10, 20, 30]);
        download.take_ack(&ChunkAck { complete: 73, islands: vec![] }, 5);
        assert_eq!(download.acknowledged(), 73);
        assert_eq!(offsets(&mut download, 5), [73, 83, 93]);
        download.take_ack(&ChunkAck { complete: 95, islands: vec![] }, 9);
        assert!(download.is_done());
        assert_eq!(download.acknowledged(), 95);
    }

    #[test]
    fn wild_acknowledgements_do_no_harm() {
        let mut download = Download::new(vec![1; 5], 0, 100, 4);
        assert_eq!(offsets(&mut download, 0), [0]);
        download.take_ack(&ChunkAck { complete: 2, islands: vec![(u32::MAX, u32::MAX), (3, 1)] }, 1);
        assert!(!download.is_done());
    }
}
