//! The target's streams: what is sampled, what is due, and what may be sent.

use alloc::vec::Vec;

use super::encode::Encoder;
use super::fold::Watch;
use super::layout::Layout;
use crate::frame::{self, kind};
use crate::message::{Failure, MOST_STREAMS, Subject, Subscription, TracedLine, TracedRegister};

/// A stream that nobody has listened to for this long ends, in microseconds.
const UNHEARD: u64 = 5_000_000;
/// When nothing changes, a sample says so after this long, or the period, in microseconds; then after twice as long.
const FIRST_HEARTBEAT: u64 = 160_000;
/// Longest time between two samples, in microseconds.
const LAST_HEARTBEAT: u64 = 1_000_000;
/// The 20 ms that numbers count, in microseconds.
const CYCLE: u64 = 20_000;
/// Least time between two samples where numbers do not pass in real time, in microseconds.
const UNEVEN_PAUSE: u64 = 10_000;
/// Bytes that may be saved up for the share of the streams: an event has to wait for one frame at most.
const MOST_CREDIT: i64 = 64;

/// State of a mechanism, for a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MechanismSample {
    /// Activation bit.
    pub active: bool,
    /// Resume point; 0 = start.
    pub resume: u16,
    /// `mech_LINE`.
    pub line: u16,
    /// Low 32 bits of the PLC cycle in which its state was entered; 0 while it is not active.
    pub entered: u32,
}

/// When a traced line ran last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ran {
    /// Not since it is traced.
    #[default]
    Never,
    /// Before the last cycle.
    Before,
    /// In the last cycle.
    Now,
}

/// Registers behind a line, for a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TraceSample {
    /// When the line ran: the registers are those of that time, and nothing when it did not.
    pub ran: Ran,
    /// RLO.
    pub rlo: bool,
    /// DR.
    pub dr: i64,
    /// DR_REAL; 0 where the line does not work with it.
    pub dr_real: f64,
}

impl TraceSample {
    fn register(&self, register: TracedRegister) -> u64 {
        match register {
            TracedRegister::Dr32 | TracedRegister::Dr64 => self.dr as u64,
            TracedRegister::Real => self.dr_real.to_bits(),
        }
    }
}

/// Where samples are taken from.
pub trait SampleSource {
    /// PLC memory.
    fn memory(&self) -> &[u8];
    /// A mechanism or block module; one that there is not is at rest.
    fn mechanism(&self, sequence: u16) -> MechanismSample;
    /// The line that begins with this operation; one that is not traced did not run.
    fn traced(&self, pc: u32) -> TraceSample;
}

#[derive(Clone, Debug)]
enum Sampler {
    Variables(Watch),
    Mechanisms(Vec<u16>),
    Trace(Vec<TracedLine>),
}

#[derive(Clone, Debug)]
struct Stream {
    id: u8,
    period: u32,
    sampler: Sampler,
    encoder: Encoder,
    /// The sample to be sent next, and what it is about.
    values: Vec<u64>,
    stamp: Option<(u32, u32)>,
    /// It was taken because its time had come, not sent yet.
    due: bool,
    /// Number from which on a sample is due.
    next: u32,
    /// The host asked for a whole sample.
    wanted: bool,
    /// When a sample was sent last, and how long nothing may be sent after it.
    sent_at: u64,
    patience: u64,
    /// How long after a change nothing is sent, unless there is another one.
    first_patience: u64,
    /// When the host last said that it listens.
    heard: u64,
}

impl Stream {
    fn sample(&mut self, number: u32, cycle: u32, now: u64, source: &dyn SampleSource) {
        let mut due = number.wrapping_sub(self.next) as i32 >= 0;
        if due {
            self.next = number.wrapping_add(self.period);
        } else if let Sampler::Variables(watch) = &self.sampler {
            due = watch.on_change && watch.has_changed(source.memory(), self.encoder.last());
        }
        // A heartbeat tells about now, however long the period.
        if !due && now < self.sent_at + self.patience {
            return;
        }
        self.due = true;
        self.stamp = Some((number, cycle));
        match &mut self.sampler {
            Sampler::Variables(watch) => watch.sample(source.memory(), &mut self.values),
            Sampler::Mechanisms(sequences) => {
                for (sequence, values) in sequences.iter().zip(self.values.chunks_exact_mut(4)) {
                    let now = source.mechanism(*sequence);
                    let line =
                        [u64::from(now.active), now.resume.into(), now.line.into(), now.entered.into()];
                    values.copy_from_slice(&line);
                }
            }
            Sampler::Trace(lines) => {
                for (line, values) in lines.iter().zip(self.values.chunks_exact_mut(4)) {
                    let now = source.traced(line.pc);
                    let (ever, last) = (now.ran != Ran::Never, now.ran == Ran::Now);
                    let register = now.register(line.register);
                    let line = [u64::from(ever), u64::from(last), u64::from(now.rlo), register];
                    values.copy_from_slice(&line);
                }
            }
        }
        for (index, value) in self.values.iter_mut().enumerate() {
            *value = self.encoder.layout().clip(index, *value);
        }
    }

    /// When this stream has something to send; `None`: not before the next sample.
    fn ready_at(&self) -> Option<u64> {
        let (number, _) = self.stamp?;
        let Some(last) = self.encoder.last_number() else { return Some(0) };
        if self.wanted {
            return Some(self.sent_at);
        }
        if number == last {
            return None;
        }
        let changed = self.due && self.values != self.encoder.last();
        Some(self.sent_at + if changed { 0 } else { self.patience })
    }
}

/// All streams of a target. Nothing is allocated while samples are taken and sent.
#[derive(Clone, Debug, Default)]
pub struct Streams {
    places: [Option<Stream>; MOST_STREAMS as usize],
    /// Bytes a second that samples may take, if that is bounded.
    rate: Option<u32>,
    /// Bytes that may be sent now.
    credit: i64,
    credited: u64,
    /// Numbers do not pass in real time.
    uneven: bool,
    /// Number of the last sample.
    number: u32,
    now: u64,
    payload: Vec<u8>,
    /// The stream whose turn it is.
    turn: u8,
    /// Counts changes of what is subscribed.
    generation: u32,
}

impl Streams {
    /// How many bytes a second samples may take; `None`: as many as there are.
    pub fn set_rate(&mut self, bytes_per_second: Option<u32>) {
        self.rate = bytes_per_second;
        self.credit = MOST_CREDIT;
    }

    /// Tells that the numbers of samples may pass faster than one in 5 ms, as in virtual time: samples then tell their
    /// numbers in full, and are at least 10 ms apart. Takes effect with the next subscription.
    pub fn set_uneven(&mut self, uneven: bool) {
        self.uneven = uneven;
    }

    /// Begins a stream. `max_payload` is that of the link.
    ///
    /// # Errors
    /// [`Failure::OutOfRange`]: a number, width or address that there is not. [`Failure::TooLarge`]: its samples would
    /// not fit into a frame; split it.
    pub fn subscribe(
        &mut self,
        subscription: &Subscription,
        max_payload: u16,
        source: &dyn SampleSource,
    ) -> Result<(), Failure> {
        let layout = Layout::of(subscription)?;
        if layout.longest() > usize::from(max_payload) {
            return Err(Failure::TooLarge);
        }
        let sampler = match &subscription.subject {
            Subject::Variables(items) => Sampler::Variables(Watch::new(items, source.memory())?),
            Subject::Mechanisms(sequences) => Sampler::Mechanisms(sequences.clone()),
            Subject::Trace { pcs, .. } => {
                // The width of the layout cuts what is not asked for.
                let line = |pc: &u32| TracedLine { pc: *pc, register: TracedRegister::Dr64 };
                Sampler::Trace(pcs.iter().map(line).collect())
            }
            Subject::Lines(lines) => Sampler::Trace(lines.clone()),
        };
        let period = u64::from(subscription.period) * CYCLE;
        let first_patience = period.clamp(FIRST_HEARTBEAT, LAST_HEARTBEAT);
        self.payload.reserve(layout.longest());
        self.generation = self.generation.wrapping_add(1);
        self.places[usize::from(subscription.id)] = Some(Stream {
            id: subscription.id,
            period: subscription.period.into(),
            sampler,
            values: layout.zeros(),
            encoder: Encoder::new(subscription.id, layout, self.number, self.uneven),
            stamp: None,
            due: false,
            next: self.number,
            wanted: false,
            sent_at: self.now,
            patience: first_patience,
            first_patience,
            heard: self.now,
        });
        Ok(())
    }

    /// Ends a stream.
    pub fn unsubscribe(&mut self, id: u8) {
        if self.places.get_mut(usize::from(id)).and_then(Option::take).is_some() {
            self.generation = self.generation.wrapping_add(1);
        }
    }

    /// Ends all streams: the session or the program is over.
    pub fn clear(&mut self) {
        self.places = Default::default();
        self.generation = self.generation.wrapping_add(1);
    }

    /// Nothing is subscribed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.places.iter().all(Option::is_none)
    }

    /// Another number than before when streams have begun or ended since.
    #[must_use]
    pub fn generation(&self) -> u32 {
        self.generation
    }

    /// The operations that traced lines begin with.
    pub fn traced(&self) -> impl Iterator<Item = u32> + '_ {
        let lines = self.places.iter().flatten().filter_map(|stream| match &stream.sampler {
            Sampler::Trace(lines) => Some(lines),
            _ => None,
        });
        lines.flatten().map(|line| line.pc)
    }

    /// There are items that are looked at between samples: [`Streams::observe`] is of use.
    #[must_use]
    pub fn folds(&self) -> bool {
        self.places.iter().flatten().any(|s| matches!(&s.sampler, Sampler::Variables(watch) if watch.folds))
    }

    /// Looks at the memory between samples: every millisecond, say.
    pub fn observe(&mut self, memory: &[u8]) {
        for stream in self.places.iter_mut().flatten() {
            if let Sampler::Variables(watch) = &mut stream.sampler {
                watch.observe(memory);
            }
        }
    }

    /// Takes the samples of a number that are due. `number` grows from call to call; `cycle` is that of the PLC.
    pub fn sample(&mut self, number: u32, cycle: u32, source: &dyn SampleSource) {
        self.number = number;
        for stream in self.places.iter_mut().flatten() {
            stream.sample(number, cycle, self.now, source);
        }
    }

    /// The host says which streams it listens to (payload of a [`kind::LISTENING`] frame).
    pub(crate) fn listened(&mut self, payload: &[u8]) {
        for entry in payload.chunks_exact(5) {
            let Some(stream) = self.places.get_mut(usize::from(entry[0] & 7)).and_then(Option::as_mut) else {
                continue;
            };
            stream.heard = self.now;
            stream.wanted |= entry[0] & 0x80 != 0;
            if entry[0] & 0x40 != 0 {
                stream.encoder.confirmed(u32::from_le_bytes([entry[1], entry[2], entry[3], entry[4]]));
            }
        }
    }

    /// Lets time pass. Answers when to call again at the latest.
    pub(crate) fn poll(&mut self, now: u64) -> Option<u64> {
        self.now = now;
        if let Some(rate) = self.rate {
            let rate = u64::from(rate.max(1));
            let earned = now.saturating_sub(self.credited).saturating_mul(rate) / 1_000_000;
            // Whole bytes only; the time that makes less than a byte counts on.
            self.credited += earned * 1_000_000 / rate;
            self.credit = self.credit.saturating_add(earned as i64).min(MOST_CREDIT);
        }
        for place in &mut self.places {
            if place.as_ref().is_some_and(|s| now >= s.heard + UNHEARD) {
                *place = None;
                self.generation = self.generation.wrapping_add(1);
            }
        }
        let ready = self.places.iter().flatten().filter_map(|s| self.ready_at(s)).min()?;
        Some(ready.max(now + self.debt()))
    }

    /// Time until something may be sent, in microseconds.
    fn debt(&self) -> u64 {
        match self.rate {
            Some(rate) if self.credit <= 0 => {
                (1 - self.credit) as u64 * 1_000_000 / u64::from(rate.max(1)) + 1
            }
            _ => 0,
        }
    }

    fn ready_at(&self, stream: &Stream) -> Option<u64> {
        let pause = if self.uneven { stream.sent_at + UNEVEN_PAUSE } else { 0 };
        Some(stream.ready_at()?.max(pause))
    }

    /// Appends the frame of a stream that has something to tell, if it may.
    pub(crate) fn send(&mut self, now: u64, out: &mut Vec<u8>) -> bool {
        if self.rate.is_some() && self.credit <= 0 {
            return false;
        }
        // By turns, so that a busy stream does not silence the others.
        let order = (0..MOST_STREAMS).map(|n| (self.turn + n) % MOST_STREAMS);
        let ready = |id: &u8| {
            let stream = self.places[usize::from(*id)].as_ref();
            stream.and_then(|s| self.ready_at(s)).is_some_and(|at| at <= now)
        };
        let Some(id) = order.into_iter().find(ready) else { return false };
        self.turn = (id + 1) % MOST_STREAMS;
        let Some(stream) = &mut self.places[usize::from(id)] else { return false };
        let Some((number, cycle)) = stream.stamp else { return false };
        let changed = stream.values != stream.encoder.last();
        stream.encoder.encode(number, cycle, &stream.values, stream.wanted, &mut self.payload);
        if let Sampler::Variables(watch) = &mut stream.sampler {
            watch.sent();
        }
        stream.wanted = false;
        stream.due = false;
        stream.sent_at = now;
        stream.patience =
            if changed { stream.first_patience } else { (stream.patience * 2).min(LAST_HEARTBEAT) };
        let before = out.len();
        frame::encode(kind::STREAM, number as u8, &self.payload, out);
        self.credit -= (out.len() - before) as i64;
        debug_assert_eq!(stream.id, id);
        true
    }
}
