//! What the streams of a host see of a simulation.

use technol_runtime::{SequenceState, TraceEntry};
use technol_wire::message::{Failure, Subject, Subscription};
use technol_wire::{MechanismSample, Ran, SampleSource, Streams, TraceSample};

use crate::simulation::Simulation;

/// What samples are taken with; kept, so that a cycle needs no memory of its own.
#[derive(Debug, Default)]
pub(crate) struct Sampling {
    /// Number of the last sample: counts 20 ms, also while the program is held.
    number: u32,
    /// State of the streams for which lines are traced; `None`: for nobody.
    followed: Option<u32>,
    sequences: Vec<SequenceState>,
    traced: Vec<TraceEntry>,
}

impl Sampling {
    /// The lines that the streams trace are traced from now on.
    pub(crate) fn follow(&mut self, streams: Option<&Streams>, simulation: &mut Simulation) {
        let state = streams.map(Streams::generation);
        if state != self.followed {
            self.followed = state;
            let lines = streams.into_iter().flat_map(Streams::traced);
            let lines: Vec<_> = lines.map(|pc| pc..pc.saturating_add(1)).collect();
            simulation.runtime_mut().set_trace(&lines);
        }
    }

    /// A new program is traced for nobody.
    pub(crate) fn restart(&mut self) {
        self.followed = None;
    }

    /// The streams' samples of the cycle that has just ended.
    pub(crate) fn sample(&mut self, streams: Option<&mut Streams>, simulation: &Simulation) {
        self.number = self.number.wrapping_add(1);
        let Some(streams) = streams.filter(|s| !s.is_empty()) else { return };
        let plc = simulation.runtime();
        self.sequences.clear();
        self.sequences.extend(plc.sequences());
        self.traced.clear();
        self.traced.extend(plc.trace());
        let seen = Seen { cycle: plc.cycle() as u32, memory: plc.memory(), with: self };
        streams.sample(self.number, seen.cycle, &seen);
    }
}

struct Seen<'a> {
    cycle: u32,
    memory: &'a [u8],
    with: &'a Sampling,
}

impl SampleSource for Seen<'_> {
    fn memory(&self) -> &[u8] {
        self.memory
    }

    fn mechanism(&self, sequence: u16) -> MechanismSample {
        let Some(now) = self.with.sequences.get(usize::from(sequence)) else {
            return MechanismSample::default();
        };
        let entered = self.cycle.wrapping_sub(now.cycles_in_state as u32);
        MechanismSample {
            active: now.active,
            resume: now.resume,
            line: now.line,
            entered: if now.active { entered } else { 0 },
        }
    }

    fn traced(&self, pc: u32) -> TraceSample {
        // Entries are in the order of the program.
        let at = self.with.traced.binary_search_by_key(&pc, |entry| entry.pc);
        let last = at.ok().and_then(|at| self.with.traced.get(at)?.last);
        last.map_or_else(TraceSample::default, |last| TraceSample {
            ran: if last.ran { Ran::Now } else { Ran::Before },
            rlo: last.rlo,
            dr: last.dr,
            dr_real: last.dr_real.unwrap_or_default(),
        })
    }
}

/// Lines begin with a statement.
fn all_statements(pcs: impl IntoIterator<Item = u32>, simulation: &Simulation) -> Result<(), Failure> {
    let statements = &simulation.runtime().program().statements;
    match pcs.into_iter().find(|pc| !statements.contains(pc)) {
        Some(unknown) => Err(Failure::NotFound(format!("statement at operation {unknown}"))),
        None => Ok(()),
    }
}

/// Begins a stream for a host.
pub(crate) fn subscribe(
    streams: &mut Streams,
    subscription: &Subscription,
    max_payload: u16,
    simulation: &Simulation,
) -> Result<(), Failure> {
    let plc = simulation.runtime();
    match &subscription.subject {
        Subject::Variables(_) => {}
        Subject::Mechanisms(sequences) => {
            let known = plc.program().sequences.len();
            if let Some(unknown) = sequences.iter().find(|n| usize::from(**n) >= known) {
                return Err(Failure::NotFound(format!("sequence {unknown}")));
            }
        }
        Subject::Trace { pcs, .. } => all_statements(pcs.iter().copied(), simulation)?,
        Subject::Lines(lines) => all_statements(lines.iter().map(|line| line.pc), simulation)?,
    }
    let seen = Seen { cycle: 0, memory: plc.memory(), with: &Sampling::default() };
    streams.subscribe(subscription, max_payload, &seen)
}
