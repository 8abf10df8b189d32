//! What the streams of the target have told.

pub(crate) mod plan;

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use technol_wire::Sample;
use technol_wire::message::{Item, ItemKind, Mode, SequenceState, Subject, Subscription, TracedRegister};

/// A sample that comes this soon after something was written may be older than that.
const WRITTEN: Duration = Duration::from_millis(60);

/// Something told by a stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Told<T> {
    pub(crate) value: T,
    /// Samples are missing: it may be different by now.
    pub(crate) stale: bool,
    /// The PLC cycle it is of, low 32 bits.
    pub(crate) cycle: u32,
}

/// What is told about an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Reading {
    pub(crate) value: u64,
    /// Least and greatest value since [`Live::told`].
    pub(crate) extremes: Option<(u64, u64)>,
    /// How often it has risen and fallen.
    pub(crate) edges: Option<(u16, u16)>,
}

/// The registers behind a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    /// In the last cycle; if not, the registers are those of the time when it did.
    pub(crate) ran: bool,
    pub(crate) rlo: bool,
    /// Which register `data` is.
    pub(crate) register: TracedRegister,
    pub(crate) data: u64,
}

struct Stream {
    subscription: Subscription,
    /// The last sample; its extremes are those since [`Live::told`].
    sample: Option<Sample>,
    arrived: Instant,
    stale: bool,
    /// Extremes begin anew with the next sample.
    told: bool,
}

/// The values of all streams.
#[derive(Default)]
pub(crate) struct Live {
    streams: BTreeMap<u8, Stream>,
    written: Option<Instant>,
}

/// What a sample has changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct News {
    pub(crate) variables: bool,
    pub(crate) mechanisms: bool,
    pub(crate) trace: bool,
}

impl Live {
    /// A stream has begun.
    pub(crate) fn open(&mut self, subscription: Subscription) {
        let id = subscription.id;
        let arrived = Instant::now();
        self.streams.insert(id, Stream { subscription, sample: None, arrived, stale: false, told: true });
    }

    pub(crate) fn close(&mut self, id: u8) {
        self.streams.remove(&id);
    }

    /// Something was written: what was sampled before does not count.
    pub(crate) fn written(&mut self) {
        self.written = Some(Instant::now());
    }

    /// A stream has a gap.
    pub(crate) fn stale(&mut self, id: u8) -> News {
        let Some(stream) = self.streams.get_mut(&id) else { return News::default() };
        stream.stale = true;
        news(&stream.subscription, true)
    }

    /// Takes a sample.
    pub(crate) fn take(&mut self, mut sample: Sample) -> News {
        let Some(stream) = self.streams.get_mut(&sample.id) else { return News::default() };
        let changed = stream.stale || stream.sample.as_ref().is_none_or(|old| old.values != sample.values);
        if let Some(old) = stream.sample.as_ref().filter(|_| !stream.told) {
            widen(&stream.subscription, old, &mut sample);
        }
        stream.told = false;
        stream.sample = Some(sample);
        stream.arrived = Instant::now();
        stream.stale = false;
        news(&stream.subscription, changed)
    }

    /// What is known so far has been told to the client: extremes begin anew.
    pub(crate) fn told(&mut self) {
        self.streams.values_mut().for_each(|s| s.told = true);
    }

    /// Something has been sampled.
    pub(crate) fn has_samples(&self) -> bool {
        self.streams.values().any(|s| s.sample.is_some())
    }

    /// Whether a sample is newer than all that was written.
    fn is_trusted(&self, stream: &Stream) -> bool {
        !stream.stale && self.written.is_none_or(|at| stream.arrived > at + WRITTEN)
    }

    /// An item as it was subscribed.
    pub(crate) fn item(&self, item: Item) -> Option<Told<Reading>> {
        for stream in self.streams.values() {
            let Subject::Variables(items) = &stream.subscription.subject else { continue };
            let mut slot = 0;
            for other in items {
                if *other == item {
                    let sample = stream.sample.as_ref()?;
                    let values = sample.values.get(slot..slot + slots(item.mode))?;
                    let value = reading(item.mode, values)?;
                    return Some(Told { value, stale: stream.stale, cycle: sample.cycle });
                }
                slot += slots(other.mode);
            }
        }
        None
    }

    /// The value of a cell, if it can be relied on.
    pub(crate) fn cell(&self, addr: u32, bytes: u8) -> Option<u64> {
        for stream in self.streams.values().filter(|s| self.is_trusted(s)) {
            let Subject::Variables(items) = &stream.subscription.subject else { continue };
            let mut slot = 0;
            for item in items {
                let wide = match item.kind {
                    ItemKind::Bit(_) => 0,
                    ItemKind::Unsigned(n) | ItemKind::Signed(n) => n,
                    ItemKind::Real => 8,
                };
                if item.addr == addr && wide == bytes {
                    return stream.sample.as_ref()?.values.get(slot).copied();
                }
                slot += slots(item.mode);
            }
        }
        None
    }

    /// A mechanism. While the program runs, it has been longer in its state than the sample says.
    pub(crate) fn mechanism(&self, sequence: u16, running: bool) -> Option<Told<SequenceState>> {
        for stream in self.streams.values() {
            let Subject::Mechanisms(sequences) = &stream.subscription.subject else { continue };
            let Some(at) = sequences.iter().position(|n| *n == sequence) else { continue };
            let sample = stream.sample.as_ref()?;
            let [active, resume, line, entered] = sample.values.get(at * 4..at * 4 + 4)? else { return None };
            let passed =
                if running { stream.arrived.elapsed().as_millis() as u32 / plan::CYCLE_MS } else { 0 };
            let since = sample.cycle.wrapping_sub(*entered as u32).saturating_add(passed);
            let value = SequenceState {
                sequence,
                active: *active == 1,
                resume: *resume as u16,
                line: *line as u16,
                since: if *active == 1 { since } else { 0 },
            };
            return Some(Told { value, stale: !self.is_trusted(stream), cycle: sample.cycle });
        }
        None
    }

    /// The registers behind the line that begins with this operation; none if it did not run since it is traced.
    pub(crate) fn line(&self, pc: u32) -> Option<Told<Option<Line>>> {
        for stream in self.streams.values() {
            let Some((at, register)) = traced(&stream.subscription.subject, pc) else { continue };
            let sample = stream.sample.as_ref()?;
            let [known, ran, rlo, data] = *sample.values.get(at * 4..at * 4 + 4)? else { return None };
            let line = Line { ran: ran == 1, rlo: rlo == 1, register, data };
            let value = (known == 1).then_some(line);
            return Some(Told { value, stale: stream.stale, cycle: sample.cycle });
        }
        None
    }
}

/// The place of a line in the samples of a stream, and which register they tell.
fn traced(subject: &Subject, pc: u32) -> Option<(usize, TracedRegister)> {
    match subject {
        Subject::Trace { pcs, wide } => {
            let register = if *wide { TracedRegister::Dr64 } else { TracedRegister::Dr32 };
            pcs.iter().position(|n| *n == pc).map(|at| (at, register))
        }
        Subject::Lines(lines) => {
            let at = lines.iter().position(|line| line.pc == pc)?;
            Some((at, lines[at].register))
        }
        Subject::Variables(_) | Subject::Mechanisms(_) => None,
    }
}

fn news(subscription: &Subscription, changed: bool) -> News {
    match subscription.subject {
        Subject::Variables(_) => News { variables: changed, ..News::default() },
        // Time passes for those that wait.
        Subject::Mechanisms(_) => News { mechanisms: true, ..News::default() },
        Subject::Trace { .. } | Subject::Lines(_) => News { trace: changed, ..News::default() },
    }
}

/// Values of an item in a sample.
fn slots(mode: Mode) -> usize {
    match mode {
        Mode::Value | Mode::OnChange => 1,
        Mode::Extremes | Mode::Edges => 3,
    }
}

fn reading(mode: Mode, values: &[u64]) -> Option<Reading> {
    let value = *values.first()?;
    let pair = || Some((*values.get(1)?, *values.get(2)?));
    Some(match mode {
        Mode::Value | Mode::OnChange => Reading { value, extremes: None, edges: None },
        Mode::Extremes => Reading { value, extremes: pair(), edges: None },
        Mode::Edges => Reading { value, extremes: None, edges: pair().map(|(r, f)| (r as u16, f as u16)) },
    })
}

/// Extremes of a sample take in those of the one before.
fn widen(subscription: &Subscription, old: &Sample, new: &mut Sample) {
    let Subject::Variables(items) = &subscription.subject else { return };
    let mut slot = 0;
    for item in items {
        if item.mode == Mode::Extremes
            && let Some([_, old_least, old_greatest]) = old.values.get(slot..slot + 3)
            && let Some([_, least, greatest]) = new.values.get_mut(slot..slot + 3)
        {
            if compare(item.kind, *old_least, *least) == Ordering::Less {
                *least = *old_least;
            }
            if compare(item.kind, *old_greatest, *greatest) == Ordering::Greater {
                *greatest = *old_greatest;
            }
        }
        slot += slots(item.mode);
    }
}

fn compare(kind: ItemKind, a: u64, b: u64) -> Ordering {
    match kind {
        ItemKind::Bit(_) | ItemKind::Unsigned(_) => a.cmp(&b),
        ItemKind::Signed(bytes) => {
            let unused = 64_u32.saturating_sub(u32::from(bytes) * 8);
            (((a << unused) as i64) >> unused).cmp(&(((b << unused) as i64) >> unused))
        }
        ItemKind::Real => f64::from_bits(a).total_cmp(&f64::from_bits(b)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(id: u8, number: u32, values: &[u64]) -> Sample {
        Sample { id, number, cycle: number - 50, values: values.to_vec(), window: 1, contiguous: true }
    }

    #[test]
    fn extremes_reach_back_to_what_the_client_was_told() {
        let item = Item { addr: 4, kind: ItemKind::Signed(1), mode: Mode::Extremes };
        let mut live = Live::default();
        live.open(Subscription { id: 2, period: 1, subject: Subject::Variables(vec![item]) });
        assert_eq!(live.item(item), None);
        live.take(sample(2, 100, &[5, 0xF0, 7]));
        live.take(sample(2, 101, &[6, 5, 20]));
        let extremes = |live: &Live| live.item(item).unwrap().value.extremes;
        assert_eq!(extremes(&live), Some((0xF0, 20)));
        live.told();
        live.take(sample(2, 102, &[6, 6, 6]));
        assert_eq!(extremes(&live), Some((6, 6)));
        assert_eq!(live.cell(4, 1), Some(6));
        assert_eq!((live.cell(4, 2), live.cell(5, 1)), (None, None));
        assert_eq!(live.stale(2), News { variables: true, ..News::default() });
        assert_eq!((live.cell(4, 1), live.item(item).unwrap().stale), (None, true));
    }

    #[test]
    fn what_was_sampled_before_a_write_does_not_count() {
        let item = Item { addr: 4, kind: ItemKind::Unsigned(2), mode: Mode::Value };
        let mut live = Live::default();
        live.open(Subscription { id: 0, period: 1, subject: Subject::Variables(vec![item]) });
        live.take(sample(0, 100, &[5]));
        assert_eq!(live.cell(4, 2), Some(5));
        live.written();
        assert_eq!(live.cell(4, 2), None);
        live.take(sample(0, 101, &[5]));
        assert_eq!(live.cell(4, 2), None, "it may have been on its way");
        std::thread::sleep(WRITTEN + Duration::from_millis(5));
        live.take(sample(0, 102, &[6]));
        assert_eq!(live.cell(4, 2), Some(6));
    }

    #[test]
    fn a_mechanism_tells_how_long_it_waits() {
        let mut live = Live::default();
        live.open(Subscription { id: 1, period: 5, subject: Subject::Mechanisms(vec![7, 3]) });
        live.take(sample(1, 150, &[0, 0, 0, 0, 1, 2, 40, 88]));
        let state = live.mechanism(3, false).unwrap().value;
        assert_eq!((state.active, state.resume, state.line, state.since), (true, 2, 40, 12));
        assert!(!live.mechanism(7, true).unwrap().value.active);
        assert_eq!(live.mechanism(4, true), None);
    }
}
