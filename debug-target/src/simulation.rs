//! A program and the machine behind it, without any link or clock.

use std::collections::VecDeque;

use technol_image::Program;
use technol_image::system::data::{PLC_MEM_BACKUP, PLC_MEM_BACKUP_LEN};
use technol_image::system::m_group;
use technol_machine::{
    BlockStart, ConfigError, ControlData, MachineConfig, Plant, PlantEvent, Shown, SimulatedControl,
};
use technol_runtime::{
    Block, BlockFlag, BlockMode, Command, InputImage, LoadError, PlcState, Rejection, Resume, Runtime,
    RuntimeEvent, TickOutcome,
};

/// Blocks handed to the PLC ahead of the one in progress.
const LOOK_AHEAD: usize = 8;
/// Blocks that may wait besides all that the machine has: programs started before the last one is through.
const MORE_WAITING: usize = 240;
/// The highest M function and the highest group.
const LAST_M: u8 = 99;
const LAST_GROUP: u8 = 14;
/// Cycles that MODULE_DONE may take when the power is switched off.
const LAST_CYCLES: u32 = 250;

/// Why there is no simulation.
#[derive(Debug, thiserror::Error)]
pub enum SimulationError {
    /// The program does not pass the checks of the runtime.
    #[error("the program cannot be loaded: {0}")]
    Program(LoadError),
    /// The description of the machine is wrong.
    #[error("the machine description is wrong: {}", list(.0))]
    Machine(Vec<ConfigError>),
}

fn list(errors: &[ConfigError]) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

/// A program that runs against a simulated machine, millisecond by millisecond. Deterministic: what happens
/// depends only on the calls made, so a clone is a saved state: it goes on as the original would.
#[derive(Clone, Debug)]
pub struct Simulation {
    runtime: Runtime,
    plant: Plant,
    control: SimulatedControl,
    inputs: InputImage,
    /// The millisecond the machine was moved for.
    moved: Option<u64>,
    /// The next tick starts the PLC; the machine does not move in it.
    starting: bool,
    /// Blocks of the part program that the PLC has not been given yet, at most `most_waiting`, for which there is room.
    waiting: VecDeque<Block>,
    most_waiting: usize,
    /// Central annulment is on its way: what the PLC forgets is meant to be forgotten.
    annulled: bool,
}

impl Simulation {
    /// Loads a program in front of a machine; without one, inputs only change by [`Simulation::inputs_mut`].
    pub fn new(program: Program, machine: Option<&MachineConfig>) -> Result<Simulation, SimulationError> {
        let plant = match machine {
            Some(config) => {
                Plant::compile(config, &|name| name.parse().ok()).map_err(SimulationError::Machine)?
            }
            None => Plant::default(),
        };
        let mut runtime = Runtime::new(program).map_err(SimulationError::Program)?;
        // The machine knows no port that the image lacks, so this does not fail.
        let _ = runtime.set_fast_ports(plant.fast_inputs(), plant.fast_outputs());
        // Nor does it know another period than those of the image.
        let _ = runtime.set_fastest_period(plant.fastest_period());
        let control = plant.control();
        // Nor another group than those.
        let _ = runtime.set_m_groups(&control.m_groups);
        runtime.set_conditional_stop(control.conditional_stop);
        let mut around = machine.map_or_else(SimulatedControl::new, SimulatedControl::of);
        around.prepare(&runtime.program().services);
        let most_waiting = plant.block_count() + MORE_WAITING;
        Ok(Simulation {
            runtime,
            plant,
            control: around,
            inputs: [0; technol_machine::INPUT_PORTS],
            moved: None,
            starting: false,
            waiting: VecDeque::with_capacity(most_waiting),
            most_waiting,
            annulled: false,
        })
    }

    /// The PLC.
    pub fn runtime(&self) -> &Runtime {
        &self.runtime
    }

    /// The PLC, for commands and the debugger. To start it use [`Simulation::start`], which tells the machine.
    pub fn runtime_mut(&mut self) -> &mut Runtime {
        &mut self.runtime
    }

    /// The machine.
    pub fn plant(&self) -> &Plant {
        &self.plant
    }

    /// The machine, for its faults and keys.
    pub fn plant_mut(&mut self) -> &mut Plant {
        &mut self.plant
    }

    /// The control around the PLC.
    pub fn control(&self) -> &SimulatedControl {
        &self.control
    }

    /// The control around the PLC, for what it has on its disk and what an operator does.
    pub fn control_mut(&mut self) -> &mut SimulatedControl {
        &mut self.control
    }

    /// A number that two simulations of the same program and machine share when they go on the same way from here.
    pub fn state_hash(&self) -> u64 {
        let Simulation {
            runtime,
            plant,
            control,
            inputs,
            moved,
            starting,
            waiting,
            most_waiting: _,
            annulled,
        } = self;
        let rest = format!("{moved:?} {starting} {waiting:?} {annulled:?}");
        let mix = |hash: u64, part: u64| (hash.rotate_left(5) ^ part).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        // Only equality matters, and the three parts are mixed already.
        let parts = [plant.state_hash(), control.state_hash()].into_iter();
        let bytes = inputs.iter().chain(rest.as_bytes()).copied().map(u64::from);
        parts.chain(bytes).fold(runtime.state_hash(), mix)
    }

    /// Replaces what the control has on its disk; PLC_MEM_BACKUP is loaded from there at once.
    pub fn set_data(&mut self, data: ControlData) {
        let bytes = data.backup.get(..PLC_MEM_BACKUP_LEN as usize).unwrap_or(&data.backup);
        // The system region holds the area, so this does not fail.
        let _ = self.runtime.write_memory(PLC_MEM_BACKUP, bytes);
        self.set_m_groups(&data.m_groups);
        self.control.set_data(data);
    }

    /// Groups of M functions by the configuration; the machine file wins. Both were checked where they were read: what cannot
    /// be is left out.
    fn set_m_groups(&mut self, configured: &[(u8, u8)]) {
        let own = &self.plant.control().m_groups;
        let counts = |(m, group): &&(u8, u8)| {
            *m <= LAST_M
                && (1..=LAST_GROUP).contains(group)
                && m_group(*m).is_none_or(|fixed| fixed == *group)
                && !own.iter().any(|(function, _)| function == m)
        };
        let groups: Vec<(u8, u8)> = configured.iter().filter(counts).chain(own).copied().collect();
        // So this does not fail.
        let _ = self.runtime.set_m_groups(&groups);
    }

    /// A regular end: what is kept while the power is off is saved.
    pub fn power_off(&mut self) {
        self.control.save_backup(self.runtime.memory());
    }

    /// The power is switched off in good order: MODULE_DONE, waiting at most five seconds of PLC time for its end, then what is
    /// kept is saved. A program that the debugger holds goes on to there without break-points.
    pub fn shut_down(&mut self, events: &mut Vec<RuntimeEvent>) {
        self.runtime.set_breakpoints(&[]);
        self.runtime.command(Command::StopPlc { power_off: true });
        for _ in 0..LAST_CYCLES {
            if !self.runtime.state().is_cycling() {
                break;
            }
            if self.runtime.stopped().is_some() {
                self.runtime.resume(Resume::Continue);
            }
            self.cycle(events);
        }
        self.power_off();
    }

    /// Input ports as the PLC will see them.
    pub fn inputs(&self) -> &InputImage {
        &self.inputs
    }

    /// Input ports; bits that the machine drives are driven again in the next millisecond.
    pub fn inputs_mut(&mut self) -> &mut InputImage {
        &mut self.inputs
    }

    /// Starts the PLC with the next [`Simulation::tick`], which executes MODULE_INIT and takes no PLC time.
    /// `cold`: memory, and the machine, are as at power-on.
    pub fn start(&mut self, cold: bool) {
        self.plant.start(cold);
        self.runtime.command(Command::StartPlc { cold });
        self.starting = true;
        self.waiting.clear();
    }

    /// One millisecond of machine and PLC. While the debugger holds the program the machine stands still, so
    /// that a run with stops is the same as a run without.
    pub fn tick(&mut self, events: &mut Vec<RuntimeEvent>) -> TickOutcome {
        let running = self.runtime.state().is_cycling() && self.runtime.stopped().is_none();
        if running && !self.starting && self.moved != Some(self.runtime.millis()) {
            self.moved = Some(self.runtime.millis());
            self.plant.place_axes(self.control.motion());
            self.plant.connect(&self.control, self.runtime.memory());
            self.plant.step(self.runtime.outputs(), &mut self.inputs);
            while let Some(event) = self.plant.next_event() {
                if let Err(rejection) = self.take(event) {
                    events.push(RuntimeEvent::BlockRejected(rejection));
                }
            }
            self.plant.tell(&mut self.control);
            let shorted = self.plant.shorted().unwrap_or(&[0; technol_machine::OUTPUT_PORTS]);
            let reported = self.control.reported(shorted, self.runtime.memory());
            self.runtime.set_shorted(&reported);
            self.hand_over_blocks();
        }
        let (first, waiting) = (events.len(), self.runtime.waiting_blocks());
        let was_running = self.runtime.state().is_cycling();
        let outcome = self.runtime.tick_with(&self.inputs, &mut self.control, events);
        if std::mem::take(&mut self.starting) {
            self.moved = None;
        }
        if was_running && self.runtime.state() == PlcState::Stopped {
            self.power_off();
        }
        self.follow_blocks(&events[first..], waiting);
        self.show(&events[first..]);
        outcome
    }

    /// Messages reach the operator.
    fn show(&mut self, events: &[RuntimeEvent]) {
        for event in events {
            if let RuntimeEvent::Message { cycle, number, sub_id, set, parameters, .. } = *event {
                self.control.report(Shown { number, sub_id, parameters, cycle }, set);
            }
        }
    }

    /// Milliseconds up to the end of the 20 ms cycle in progress, or until the program is held or no longer
    /// runs. Directly after a start this is MODULE_INIT and the whole of cycle 0.
    pub fn cycle(&mut self, events: &mut Vec<RuntimeEvent>) -> TickOutcome {
        self.cycle_observed(events, |_| ())
    }

    /// The same; somebody looks at the memory after each millisecond.
    pub fn cycle_observed(
        &mut self,
        events: &mut Vec<RuntimeEvent>,
        mut observe: impl FnMut(&[u8]),
    ) -> TickOutcome {
        loop {
            let before = self.runtime.millis();
            let starting = self.starting;
            let outcome = self.tick(events);
            observe(self.runtime.memory());
            if outcome == TickOutcome::Stopped {
                return TickOutcome::Stopped;
            }
            let now = self.runtime.millis();
            let complete = now != before && now.is_multiple_of(20);
            if !starting && (complete || !self.runtime.state().is_cycling()) {
                return TickOutcome::Done;
            }
        }
    }

    /// Starts a block as the control would, beside those of the machine's part program: it begins when its turn
    /// comes, one of central annulment at once. A block that is out of range ends as a rejection among the events.
    ///
    /// # Errors
    /// Too many blocks wait already.
    pub fn start_block(&mut self, block: &BlockStart) -> Result<(), Rejection> {
        self.take(PlantEvent::StartBlock(block.block()))
    }

    fn take(&mut self, event: PlantEvent) -> Result<(), Rejection> {
        let command = match event {
            PlantEvent::StartBlock(block) => {
                if block.mode == BlockMode::CentralAnnulment {
                    // It does not wait for its turn: it ends what is going on.
                    self.waiting.clear();
                    self.annulled = true;
                    self.runtime.command(Command::AbortBlock);
                }
                if self.waiting.len() >= self.most_waiting {
                    return Err(Rejection::QueueFull);
                }
                self.waiting.push_back(block);
                return Ok(());
            }
            PlantEvent::Command { code, pressed } => Command::PlcCommand { code, pressed },
            PlantEvent::Panel { key, pressed } => {
                // Its axis was checked with the machine.
                let _ = self.control.motion_mut().panel_key(key, pressed);
                return Ok(());
            }
            PlantEvent::Start => Command::ContinueBlock,
            PlantEvent::Stop { emergency } => Command::StopBlock { emergency },
        };
        self.runtime.command(command);
        Ok(())
    }

    fn hand_over_blocks(&mut self) {
        while self.runtime.waiting_blocks() < LOOK_AHEAD {
            let Some(block) = self.waiting.pop_front() else { return };
            if block.ends_program() {
                let next = self.waiting.iter().position(|block| block.has(BlockFlag::First));
                self.waiting.drain(..next.unwrap_or(self.waiting.len()));
            }
            self.runtime.command(Command::StartBlock(block));
        }
    }

    /// A stop makes the PLC forget the blocks it was given; the rest of the part program goes with them. `before`
    /// that tick so many waited.
    fn follow_blocks(&mut self, events: &[RuntimeEvent], before: usize) {
        let taken = |e: &&RuntimeEvent| {
            matches!(e, RuntimeEvent::BlockStarted { .. } | RuntimeEvent::BlockRejected(_))
        };
        let left = self.runtime.waiting_blocks() + events.iter().filter(taken).count();
        let forgotten = left < before && !std::mem::take(&mut self.annulled);
        if forgotten || !(self.starting || self.runtime.state().is_cycling()) {
            self.waiting.clear();
        }
    }
}
