//! What has happened in a test, to be told when it fails.

use std::collections::VecDeque;

use technol_analysis::expression::{Target, Value};
use technol_image::DebugInfo;
use technol_runtime::{Fault, Runtime, RuntimeEvent, SequenceState};

use super::condition::{read, shown};
use super::state::Mechanisms;

/// Entries kept of one source: what changes in each cycle must not push everything else out.
const OF_ONE_SOURCE: usize = 4;
/// Entries told at most.
const TOLD: usize = 24;

/// Something that happened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) ms: u64,
    pub(super) cycle: u64,
    pub(super) text: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    Value(usize),
    Mechanism(u16),
    Message(u32),
    /// Steps, states of the PLC, blocks, faults.
    Course,
}

/// The record of a test.
pub(super) struct History<'a> {
    debug: &'a DebugInfo,
    mechanisms: &'a Mechanisms,
    names: &'a [(String, Target)],
    values: Vec<Option<Value>>,
    states: Vec<(bool, Option<u16>)>,
    entries: VecDeque<(Source, Entry)>,
}

impl<'a> History<'a> {
    pub(super) fn new(
        debug: &'a DebugInfo,
        mechanisms: &'a Mechanisms,
        names: &'a [(String, Target)],
    ) -> History<'a> {
        History { debug, mechanisms, names, values: Vec::new(), states: Vec::new(), entries: VecDeque::new() }
    }

    /// Notes what is different from the last look; the first one only remembers.
    pub(super) fn look(&mut self, ms: u64, runtime: &Runtime) {
        let first = self.values.len() < self.names.len() || self.states.is_empty();
        let values: Vec<Option<Value>> =
            self.names.iter().map(|(_, target)| read(*target, runtime)).collect();
        let states: Vec<SequenceState> = runtime.sequences().collect();
        let mut news = Vec::new();
        if !first {
            for (n, (new, old)) in
                values.iter().zip(&self.values).enumerate().filter(|(_, (new, old))| new != old)
            {
                let text = |value: &Option<Value>| value.clone().map_or_else(|| "nothing".to_owned(), shown);
                news.push((Source::Value(n), format!("{} {} → {}", self.names[n].0, text(old), text(new))));
            }
            for (new, _) in states.iter().zip(&self.states).filter(|(new, old)| key(new) != **old) {
                let name = self.mechanisms.list.iter().find(|m| m.sequence == new.sequence);
                let name = name.map_or("a mechanism", |m| m.name.as_str());
                news.push((
                    Source::Mechanism(new.sequence),
                    format!("{name} {}", self.mechanisms.describe(new)),
                ));
            }
        }
        self.values = values;
        self.states = states.iter().map(key).collect();
        for (source, text) in news {
            self.push(source, Entry { ms, cycle: runtime.cycle(), text });
        }
    }

    /// Notes a step.
    pub(super) fn step(&mut self, ms: u64, cycle: u64, text: String) {
        self.push(Source::Course, Entry { ms, cycle, text });
    }

    /// Notes what the PLC reports.
    pub(super) fn event(&mut self, ms: u64, cycle: u64, event: &RuntimeEvent) {
        let (source, text) = match event {
            RuntimeEvent::Message { number, set, pc, .. } => {
                let what = if *set { "message" } else { "message removed:" };
                (Source::Message(*number), format!("{what} {number} at {}", self.position(*pc)))
            }
            RuntimeEvent::StateChanged(state) => (Source::Course, format!("PLC {state:?}")),
            RuntimeEvent::Fault(fault) => (Source::Course, format!("PLC fault: {}", self.fault(fault))),
            RuntimeEvent::BlockStarted { .. } => (Source::Course, "block begun".to_owned()),
            RuntimeEvent::BlockFinished { .. } => (Source::Course, "block finished".to_owned()),
            RuntimeEvent::BlockAborted { .. } => (Source::Course, "block broken off".to_owned()),
            RuntimeEvent::BlockRejected(why) => (Source::Course, format!("block rejected: {why}")),
            RuntimeEvent::Overrun { rate, executed, limit, .. } => {
                (Source::Course, format!("overrun of {rate:?}: {executed} of {limit} instructions"))
            }
        };
        self.push(source, Entry { ms, cycle, text });
    }

    /// A fault of the program with its place.
    pub(super) fn fault(&self, fault: &Fault) -> String {
        let mechanism = self.mechanisms.list.iter().find(|m| Some(m.sequence) == fault.sequence);
        let within = mechanism.map_or(fault.module.keyword(), |m| m.name.as_str());
        format!("{} at {} in {within}, cycle {}", fault.kind, self.position(fault.pc), fault.cycle)
    }

    /// The last entries, oldest first.
    pub(super) fn told(self) -> Vec<Entry> {
        let skip = self.entries.len().saturating_sub(TOLD);
        self.entries.into_iter().skip(skip).map(|(_, entry)| entry).collect()
    }

    fn position(&self, pc: u32) -> String {
        match self.debug.position(pc) {
            Some((file, line)) => format!("{file}:{line}"),
            None => "an unknown place".to_owned(),
        }
    }

    fn push(&mut self, source: Source, entry: Entry) {
        let most = if source == Source::Course { TOLD } else { OF_ONE_SOURCE };
        let mut own = self.entries.iter().enumerate().filter(|(_, (s, _))| *s == source).map(|(n, _)| n);
        let oldest = own.next();
        if let Some(oldest) = oldest.filter(|_| 1 + own.count() >= most) {
            self.entries.remove(oldest);
        }
        self.entries.push_back((source, entry));
    }
}

/// What makes a state of a mechanism another one.
fn key(state: &SequenceState) -> (bool, Option<u16>) {
    (state.active, state.waiting.filter(|_| state.active))
}
