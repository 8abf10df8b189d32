//! A program and the machine behind it, without any link or clock.

use std::collections::VecDeque;

use technol_image::{Program, system};
use technol_machine::{
    BlockMode, BlockStart, ConfigError, MachineConfig, Plant, PlantEvent, SimulatedControl,
};
use technol_runtime::{Block, Command, InputImage, LoadError, Runtime, RuntimeEvent, TickOutcome};

/// Blocks handed to the PLC ahead of the one in progress.
const LOOK_AHEAD: usize = 8;

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
/// depends only on the calls made.
pub struct Simulation {
    runtime: Runtime,
    plant: Plant,
    control: SimulatedControl,
    inputs: InputImage,
    /// The millisecond the machine was moved for.
    moved: Option<u64>,
    /// The next tick starts the PLC; the machine does not move in it.
    starting: bool,
    /// Blocks of the part program that the PLC has not been given yet.
    waiting: VecDeque<Block>,
    /// Blocks that it has been given and not begun.
    handed: usize,
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
        let mut control = SimulatedControl::new();
        if let Some(config) = machine {
            control.connect(config);
        }
        let mut runtime = Runtime::new(program).map_err(SimulationError::Program)?;
        // The machine knows no port that the image lacks, so this does not fail.
        let _ = runtime.set_fast_ports(plant.fast_inputs(), plant.fast_outputs());
        // Nor does it know another period than those of the image.
        let _ = runtime.set_fastest_period(plant.fastest_period());
        Ok(Simulation {
            runtime,
            plant,
            control,
            inputs: [0; technol_machine::INPUT_PORTS],
            moved: None,
            starting: false,
            waiting: VecDeque::new(),
            handed: 0,
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

    /// The control around the program, for its buses.
    pub fn control_mut(&mut self) -> &mut SimulatedControl {
        &mut self.control
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
        self.forget_blocks();
    }

    /// One millisecond of machine and PLC. While the debugger holds the program the machine stands still, so
    /// that a run with stops is the same as a run without.
    pub fn tick(&mut self, events: &mut Vec<RuntimeEvent>) -> TickOutcome {
        let running = self.runtime.state().is_cycling() && self.runtime.stopped().is_none();
        if running && !self.starting && self.moved != Some(self.runtime.millis()) {
            self.moved = Some(self.runtime.millis());
            for PlantEvent::StartBlock(block) in self.plant.step(self.runtime.outputs(), &mut self.inputs) {
                self.take_block(block);
            }
            self.hand_over_blocks();
        }
        let first = events.len();
        let outcome = self.runtime.tick_with(&self.inputs, &mut self.control, events);
        if std::mem::take(&mut self.starting) {
            self.moved = None;
        }
        self.follow_blocks(&events[first..]);
        outcome
    }

    /// Milliseconds up to the end of the 20 ms cycle in progress, or until the program is held or no longer
    /// runs. Directly after a start this is MODULE_INIT and the whole of cycle 0.
    pub fn cycle(&mut self, events: &mut Vec<RuntimeEvent>) -> TickOutcome {
        loop {
            let before = self.runtime.millis();
            let starting = self.starting;
            if self.tick(events) == TickOutcome::Stopped {
                return TickOutcome::Stopped;
            }
            let now = self.runtime.millis();
            let complete = now != before && now.is_multiple_of(20);
            if !starting && (complete || !self.runtime.state().is_cycling()) {
                return TickOutcome::Done;
            }
        }
    }

    fn take_block(&mut self, block: BlockStart) {
        let mode = match block.mode {
            BlockMode::Auto => technol_runtime::BlockMode::Auto,
            BlockMode::CentralAnnulment => technol_runtime::BlockMode::CentralAnnulment,
            BlockMode::Reference => technol_runtime::BlockMode::Reference,
            BlockMode::Other => technol_runtime::BlockMode::Other,
        };
        if block.mode == BlockMode::CentralAnnulment {
            // It does not wait for its turn: it ends what is going on.
            self.forget_blocks();
            self.runtime.command(Command::AbortBlock);
        }
        let BlockStart { m, s, t, h, motion_ms, rapid, .. } = block;
        self.waiting.push_back(Block { m, t, s, h, motion_ms, rapid, mode });
    }

    fn hand_over_blocks(&mut self) {
        while self.handed < LOOK_AHEAD {
            let Some(block) = self.waiting.pop_front() else { return };
            self.runtime.command(Command::StartBlock(block));
            self.handed += 1;
        }
    }

    fn follow_blocks(&mut self, events: &[RuntimeEvent]) {
        let done = |e: &&RuntimeEvent| {
            matches!(e, RuntimeEvent::BlockStarted { .. } | RuntimeEvent::BlockRejected(_))
        };
        self.handed = self.handed.saturating_sub(events.iter().filter(done).count());
        // A stop makes the PLC forget the blocks it was given; the rest of the part program goes with them.
        let stop = system::PO_STOP;
        let byte = self.runtime.memory().get(stop.addr as usize).copied().unwrap_or(0);
        if byte >> stop.bit & 1 != 0 || !(self.starting || self.runtime.state().is_cycling()) {
            self.forget_blocks();
        }
    }

    fn forget_blocks(&mut self) {
        self.waiting.clear();
        self.handed = 0;
    }
}
