//! A simulation under the control of a debugger: time goes in, events come out. Requests are in
//! [`answer`](crate::answer).

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use technol_image::container::{content_hash, hash_bytes};
use technol_image::{ContentHash, Program};
use technol_machine::{ControlData, MachineConfig};
use technol_runtime::{Command, RateKind, Resume, RuntimeEvent, StopReason};
use technol_wire::message::{Chunk, Event, LostPolicy, PlcState, Status};
use technol_wire::{Arrived, Streams};

use crate::clock::{CYCLE, Pacer};
use crate::convert;
use crate::event_log::EventLog;
use crate::files::RemoteFolder;
use crate::keep::Keep;
use crate::lines::Lines;
use crate::sampling::Sampling;
use crate::simulation::{Simulation, SimulationError};

/// Wall time that virtual cycles may take before the link is looked at again.
const VIRTUAL_SLICE: Duration = Duration::from_millis(2);

/// What time the program runs in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Clock {
    /// A cycle takes 20 ms.
    #[default]
    Real,
    /// Cycles run as fast as they can while a host is there.
    Virtual,
    /// A cycle takes 20 ms of the time that [`TargetCore::advance`] is told, and its execution takes none of it: for
    /// tests in virtual time.
    Told,
}

/// How a target is set up.
#[derive(Clone, Debug, Default)]
pub struct TargetOptions {
    /// Time.
    pub clock: Clock,
    /// The machine behind every program that is loaded.
    pub machine: Option<MachineConfig>,
    /// What the control has on its disk before the first program.
    pub data: ControlData,
    /// Where changes of that are kept.
    pub keep: Keep,
    /// Where what happens is logged.
    pub log: Option<EventLog>,
    /// Loaded at once.
    pub program: Option<Program>,
    /// Started at once (cold), as at power-on.
    pub start: bool,
    /// The folder whose files a host may list, get, put, copy, move and delete.
    pub files: Option<RemoteFolder>,
}

/// An announced download.
#[derive(Debug)]
pub(crate) struct Download {
    pub(crate) hash: ContentHash,
    pub(crate) bytes: Vec<u8>,
    pub(crate) arrived: Arrived,
}

impl Download {
    /// It goes on where it was when the same is announced again, also in another session.
    pub(crate) fn announced(kept: Option<Download>, len: u32, hash: ContentHash) -> Download {
        kept.filter(|d| d.hash == hash && d.bytes.len() == len as usize).unwrap_or_else(|| Download {
            hash,
            bytes: vec![0; len as usize],
            arrived: Arrived::default(),
        })
    }

    pub(crate) fn is_intact(&self) -> bool {
        hash_bytes(&self.bytes) == self.hash
    }
}

/// A target without a link. It outlives links and host sessions.
pub struct TargetCore {
    clock: Clock,
    machine: Option<MachineConfig>,
    data: ControlData,
    keep: Keep,
    log: Option<EventLog>,
    /// Serial ports of the program.
    lines: Lines,
    pub(crate) simulation: Option<Simulation>,
    pub(crate) program: Option<ContentHash>,
    pub(crate) download: Option<Download>,
    pub(crate) files: Option<RemoteFolder>,
    /// What becomes of a held program when the host is lost.
    pub(crate) lost_policy: LostPolicy,
    boot: u32,
    /// Number of the host session that is attached.
    pub(crate) session: Option<u32>,
    /// The host was told that the program is held.
    held: bool,
    pub(crate) pacer: Pacer,
    sampling: Sampling,
    occurred: Vec<RuntimeEvent>,
    pub(crate) events: Vec<Event>,
}

impl TargetCore {
    /// Sets a target up.
    ///
    /// # Errors
    /// A program or a machine that is wrong.
    pub fn new(options: TargetOptions) -> Result<TargetCore, SimulationError> {
        let TargetOptions { clock, machine, data, keep, log, program, start, files } = options;
        let since_epoch = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        // In virtual time no device could follow.
        let lines = Lines::open(machine.as_ref().filter(|_| clock == Clock::Real));
        let mut core = TargetCore {
            clock,
            lines,
            machine,
            data,
            keep,
            log,
            simulation: None,
            program: None,
            download: None,
            files,
            lost_policy: LostPolicy::default(),
            // Differs from start to start, which is all it has to do.
            boot: since_epoch.as_millis() as u32 ^ std::process::id().rotate_left(16),
            session: None,
            held: false,
            pacer: Pacer::new(),
            sampling: Sampling::default(),
            occurred: Vec::new(),
            events: Vec::new(),
        };
        if let Some(program) = program {
            let hash = content_hash(&program);
            core.load(program, hash)?;
            if let Some(simulation) = core.simulation.as_mut().filter(|_| start) {
                simulation.start(true);
            }
        } else if core.machine.is_some() {
            // An unusable machine is told now, not with the first program.
            Simulation::new(empty_program(), core.machine.as_ref())?;
        }
        Ok(core)
    }

    /// Replaces the program; the old one stays when the new one is refused.
    pub(crate) fn load(&mut self, program: Program, hash: ContentHash) -> Result<(), SimulationError> {
        let mut simulation = Simulation::new(program, self.machine.as_ref())?;
        self.power_off();
        self.keep.restart();
        simulation.set_data(self.data.clone());
        self.simulation = Some(simulation);
        self.program = Some(hash);
        self.sampling.restart();
        self.held = false;
        Ok(())
    }

    /// What the program in memory leaves behind is saved, as at a regular end.
    fn power_off(&mut self) {
        if let Some(simulation) = &mut self.simulation {
            simulation.power_off();
            self.data = simulation.control().data().clone();
            self.keep_files();
        }
    }

    /// Writes the files of what was saved.
    fn keep_files(&mut self) {
        if let Some(simulation) = &self.simulation
            && let Err(error) = self.keep.follow(simulation.control())
        {
            self.events.push(Event::Log(error));
        }
    }

    /// State at this moment.
    #[must_use]
    pub fn status(&self) -> Status {
        let Some(simulation) = &self.simulation else {
            return Status { plc: PlcState::Empty, held: false, cycle: 0, program: None };
        };
        let plc = simulation.runtime();
        Status {
            plc: convert::state(plc.state()),
            held: plc.stopped().is_some(),
            cycle: plc.cycle(),
            program: self.program,
        }
    }

    /// Number of this start of the target.
    #[must_use]
    pub fn boot(&self) -> u32 {
        self.boot
    }

    /// The simulation, once a program is loaded.
    #[must_use]
    pub fn simulation(&self) -> Option<&Simulation> {
        self.simulation.as_ref()
    }

    /// Events since the last call.
    pub fn take_events(&mut self) -> Vec<Event> {
        let mut events = std::mem::take(&mut self.events);
        // A step that has ended already: its stop says all, and comes a millisecond earlier over a serial line.
        let is_stop = |event: &Event| matches!(event, Event::Stopped(_));
        if let Some(stop) = events.iter().rposition(is_stop) {
            let mut at = 0..;
            events.retain(|event| at.next() > Some(stop) || *event != Event::Resumed);
        }
        events
    }

    /// A piece of the announced download.
    pub fn chunk(&mut self, chunk: &Chunk) {
        let Some(download) = &mut self.download else { return };
        let start = chunk.offset as usize;
        if let Some(place) = download.bytes.get_mut(start..start + chunk.bytes.len()) {
            place.copy_from_slice(&chunk.bytes);
            download.arrived.add(chunk.offset, chunk.offset + chunk.bytes.len() as u32);
        }
    }

    /// What has arrived of the announced download, in this session and in earlier ones.
    #[must_use]
    pub fn arrived(&self) -> Arrived {
        self.download.as_ref().map(|d| d.arrived.clone()).unwrap_or_default()
    }

    /// The host is gone. Unless it has told otherwise, break-points are removed and a held program runs on, since
    /// nobody is left to let it go. What has arrived of a download is kept.
    pub fn host_lost(&mut self) {
        if self.session.take().is_none() {
            return; // told already: the silence first, then the end of the link
        }
        match (self.is_held(), self.lost_policy) {
            (true, LostPolicy::StayStopped) => {}
            (true, LostPolicy::StopPlc) => {
                self.let_go();
                self.stop_plc();
            }
            _ => self.let_go(),
        }
        self.events.clear();
    }

    /// The debugger holds the program at a place it can go on from.
    fn is_held(&self) -> bool {
        let stop = self.simulation.as_ref().and_then(|s| s.runtime().stopped());
        stop.is_some_and(|stop| stop.reason != StopReason::Fault)
    }

    /// Removes break-points and lets a held program run on.
    pub(crate) fn let_go(&mut self) {
        if let Some(simulation) = &mut self.simulation {
            let plc = simulation.runtime_mut();
            plc.set_breakpoints(&[]);
            // After a fault there is nothing to go on with, and its registers may still be wanted.
            if plc.stopped().is_some_and(|stop| stop.reason != StopReason::Fault) {
                plc.resume(Resume::Continue);
                self.pacer.at_once();
            }
        }
        self.note_hold();
    }

    /// Stops the PLC through MODULE_DONE, also when the debugger holds it.
    pub(crate) fn stop_plc(&mut self) {
        if let Some(simulation) = &mut self.simulation {
            let plc = simulation.runtime_mut();
            plc.command(Command::StopPlc { power_off: false });
            if plc.stopped().is_some_and(|stop| stop.reason != StopReason::Fault) {
                plc.resume(Resume::Continue);
            }
            self.pacer.at_once();
        }
        self.note_hold();
    }

    /// Lets time pass up to `now`. Answers when there is something to do again: `None` when only a request can
    /// change anything. `crowded`: more events wait than the link can carry; virtual time then stands still.
    pub fn advance(&mut self, now: Instant, crowded: bool) -> Option<Instant> {
        self.advance_watched(now, crowded, None)
    }

    /// The same, for a host whose streams are sampled.
    pub fn advance_watched(
        &mut self,
        now: Instant,
        crowded: bool,
        mut streams: Option<&mut Streams>,
    ) -> Option<Instant> {
        if let Some(streams) = &mut streams {
            streams.set_uneven(self.clock == Clock::Virtual);
        }
        let running = self
            .simulation
            .as_ref()
            .is_some_and(|s| s.runtime().state().is_cycling() && s.runtime().stopped().is_none());
        if self.clock == Clock::Virtual && running {
            return self.advance_virtual(now, crowded, streams);
        }
        self.simulation.as_ref()?;
        if self.pacer.is_due(now) {
            let began = Instant::now();
            self.run_cycle(streams);
            let took = if self.clock == Clock::Told { Duration::ZERO } else { began.elapsed() };
            let behind = self.pacer.done(now, now + took);
            if behind && running && self.clock == Clock::Real {
                let cycle = self.status().cycle.saturating_sub(1);
                self.events.push(Event::Overrun { cycle, fast: false });
            }
        }
        Some(self.pacer.next(now))
    }

    fn advance_virtual(
        &mut self,
        now: Instant,
        crowded: bool,
        mut streams: Option<&mut Streams>,
    ) -> Option<Instant> {
        self.session?;
        while !crowded && self.events.is_empty() && now.elapsed() < VIRTUAL_SLICE {
            self.run_cycle(streams.as_deref_mut());
            if self.held || !self.status().plc.is_cycling() {
                break;
            }
        }
        Some(if crowded { now + Duration::from_millis(1) } else { now })
    }

    /// One cycle, or what is left of it; while the program is held, 20 ms of MODULE_CONT.
    fn run_cycle(&mut self, mut streams: Option<&mut Streams>) {
        let Some(simulation) = &mut self.simulation else { return };
        self.lines.exchange(simulation.control_mut());
        self.sampling.follow(streams.as_deref(), simulation);
        if simulation.runtime().stopped().is_some() {
            for _ in 0..CYCLE.as_millis() {
                simulation.tick(&mut self.occurred);
            }
        } else {
            match streams.as_deref_mut().filter(|s| s.folds()) {
                Some(streams) => {
                    simulation.cycle_observed(&mut self.occurred, |memory| streams.observe(memory))
                }
                None => simulation.cycle(&mut self.occurred),
            };
        }
        self.sampling.sample(streams, simulation);
        self.keep_files();
        self.log();
        self.report();
    }

    /// Logs what occurred.
    fn log(&mut self) {
        if let (Some(log), Some(simulation)) = (&mut self.log, &self.simulation)
            && let Err(error) = log.write(simulation, &self.occurred)
        {
            self.events.push(Event::Log(error));
        }
    }

    /// Ends the target as a control is switched off: the program ends through MODULE_DONE, and everything that is kept is saved.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn shut_down(mut self) -> Result<(), String> {
        let Some(mut simulation) = self.simulation.take() else { return Ok(()) };
        simulation.shut_down(&mut self.occurred);
        let kept = self.keep.follow(simulation.control());
        let logged = self.log.as_mut().map_or(Ok(()), |log| log.write(&simulation, &self.occurred));
        kept.and(logged)
    }

    /// Turns what occurred in the runtime into events for the host.
    fn report(&mut self) {
        let mut occurred = std::mem::take(&mut self.occurred);
        for event in occurred.drain(..) {
            match event {
                RuntimeEvent::Message { cycle, number, sub_id, set, parameters, pc } => {
                    let number = u16::try_from(number).unwrap_or(u16::MAX);
                    let parameters = parameters.into_iter().flatten().collect();
                    self.events.push(Event::Message { cycle, number, sub_id, set, parameters, pc });
                }
                RuntimeEvent::Overrun { cycle, rate, .. } => {
                    self.events.push(Event::Overrun { cycle, fast: rate == RateKind::Fast });
                }
                RuntimeEvent::StateChanged(state) => {
                    self.events.push(Event::State(Status { plc: convert::state(state), ..self.status() }));
                }
                RuntimeEvent::Fault(fault) => {
                    self.note_hold();
                    self.events.push(Event::Fault(convert::fault(&fault)));
                }
                RuntimeEvent::BlockRejected(why) => {
                    self.events.push(Event::Log(format!("a part-program block was not started: {why}")));
                }
                RuntimeEvent::BlockStarted { .. }
                | RuntimeEvent::BlockFinished { .. }
                | RuntimeEvent::BlockAborted { .. } => {}
            }
        }
        self.occurred = occurred;
        self.note_hold();
        self.release_if_alone();
    }

    /// Tells the host when the program has become held, or goes on.
    pub(crate) fn note_hold(&mut self) {
        let stop = self.simulation.as_ref().and_then(|s| s.runtime().stopped());
        let was_held = std::mem::replace(&mut self.held, stop.is_some());
        if stop.is_some() && !was_held {
            self.repeat_stop();
        } else if was_held && stop.is_none() {
            self.events.push(Event::Resumed);
        }
    }

    /// Tells the host where the program is held, if it is.
    pub(crate) fn repeat_stop(&mut self) {
        if let Some(plc) = self.simulation.as_ref().map(Simulation::runtime)
            && let Some(stop) = plc.stopped()
        {
            self.events.push(Event::Stopped(convert::stopped(plc, &stop)));
        }
    }

    /// A stop that was asked for by a host that is gone by now.
    fn release_if_alone(&mut self) {
        if self.session.is_none() {
            // A step that was under way when the host was lost ends where the host will look for it.
            if self.held && self.lost_policy == LostPolicy::RunOn {
                self.let_go();
            } else if self.held && self.lost_policy == LostPolicy::StopPlc {
                self.let_go();
                self.stop_plc();
            }
            self.events.clear();
        }
    }
}

impl Drop for TargetCore {
    fn drop(&mut self) {
        self.power_off();
    }
}

/// A program without anything, to try a machine on.
fn empty_program() -> Program {
    use technol_image::program::{Region, RegionKind};
    let system = Region { kind: RegionKind::System, start: 0, len: technol_image::system::LEN };
    Program::without_code(String::new(), vec![system])
}
