//! The host's streams: which it listens to, and how far their values can be relied on.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use super::Sample;
use super::decode::{SampleDecoder, Taken};
use super::layout::Layout;
use crate::message::Subscription;

/// A stream of which nothing was heard for this long may have missed a change, in microseconds: two and a half
/// heartbeats.
const QUIET: u64 = 2_500_000;
/// After this long the low bits of a number say nothing any more, in microseconds.
const FORGET: u64 = 5_000_000;
/// A target that has told nothing for this long has ended the stream, in microseconds.
const ENDED: u64 = 6_000_000;
/// How often the target is told that somebody listens, in microseconds.
const LISTEN: u64 = 1_000_000;
/// How often a whole sample is asked for, and full numbers are confirmed, in microseconds.
const ASK: u64 = 100_000;

/// How far the values of a stream can be relied on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freshness {
    /// No sample has come yet.
    Waiting,
    /// The last sample is what the target has, or had a moment ago.
    Current,
    /// Samples are missing, or none has come for too long: the values may have changed since.
    Stale,
}

#[derive(Clone, Debug)]
struct Heard {
    subscription: Subscription,
    decoder: SampleDecoder,
    freshness: Freshness,
    /// When a frame of it came last; at first when it began.
    at: u64,
    /// When one came that could be read.
    read: u64,
    /// Number of a sample told in full that the target should know has come.
    confirm: Option<u32>,
    asked: Option<u64>,
}

/// The streams of a host session.
#[derive(Clone, Debug, Default)]
pub(crate) struct Listener {
    streams: BTreeMap<u8, Heard>,
    /// When the target was last told.
    told: Option<u64>,
    due: bool,
}

impl Listener {
    /// A subscription was answered.
    pub(crate) fn open(&mut self, subscription: Subscription, now: u64) {
        let Ok(layout) = Layout::of(&subscription) else { return };
        let decoder = SampleDecoder::new(subscription.id, layout);
        let (id, freshness) = (subscription.id, Freshness::Waiting);
        self.streams.insert(
            id,
            Heard { subscription, decoder, freshness, at: now, read: now, confirm: None, asked: None },
        );
    }

    pub(crate) fn close(&mut self, id: u8) {
        self.streams.remove(&id);
    }

    pub(crate) fn clear(&mut self) {
        self.streams.clear();
    }

    pub(crate) fn freshness(&self, id: u8) -> Option<Freshness> {
        self.streams.get(&id).map(|s| s.freshness)
    }

    /// Takes a frame; answers a sample, or that a stream has become stale.
    pub(crate) fn take(&mut self, seq: u8, payload: &[u8], now: u64) -> Option<Result<Sample, u8>> {
        let id = payload.first()? >> 5;
        let stream = self.streams.get_mut(&id)?;
        let taken = stream.decoder.take(seq, payload);
        match taken {
            Taken::Sample { sample, full } => {
                stream.at = now;
                stream.read = now;
                stream.freshness = Freshness::Current;
                if full {
                    stream.confirm = Some(sample.number);
                }
                Some(Ok(sample))
            }
            Taken::Old => None,
            Taken::Gap => {
                stream.at = now;
                let was = core::mem::replace(&mut stream.freshness, Freshness::Stale);
                (was != Freshness::Stale).then_some(Err(id))
            }
        }
    }

    /// Lets time pass; answers a stream that has become stale, if there is one.
    pub(crate) fn look(&mut self, now: u64) -> Option<u8> {
        let mut late = None;
        self.due |= !self.streams.is_empty() && self.told.is_none_or(|at| now >= at + LISTEN);
        for (id, stream) in &mut self.streams {
            if now >= stream.read + FORGET {
                stream.decoder.forget();
            }
            if now >= stream.at + QUIET && stream.freshness == Freshness::Current && late.is_none() {
                stream.freshness = Freshness::Stale;
                late = Some(*id);
            }
            let may_ask = stream.asked.is_none_or(|at| now >= at + ASK);
            self.due |= may_ask && (stream.freshness == Freshness::Stale || stream.confirm.is_some());
        }
        late
    }

    /// A subscription that the target does not serve any more; it has to be asked for again.
    pub(crate) fn ended(&mut self, now: u64) -> Option<Subscription> {
        let id = *self.streams.iter().find(|(_, s)| now >= s.at + ENDED)?.0;
        self.streams.remove(&id).map(|s| s.subscription)
    }

    /// The payload of the frame that says who listens, when it is due.
    pub(crate) fn say(&mut self, now: u64) -> Option<Vec<u8>> {
        if !core::mem::take(&mut self.due) || self.streams.is_empty() {
            return None;
        }
        self.told = Some(now);
        let mut payload = Vec::with_capacity(self.streams.len() * 5);
        for (id, stream) in &mut self.streams {
            let confirm = stream.confirm.take();
            let wants = stream.freshness == Freshness::Stale;
            if wants || confirm.is_some() {
                stream.asked = Some(now);
            }
            payload.push(id | u8::from(wants) << 7 | u8::from(confirm.is_some()) << 6);
            payload.extend_from_slice(&confirm.unwrap_or(0).to_le_bytes());
        }
        Some(payload)
    }
}
