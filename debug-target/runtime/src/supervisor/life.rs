//! The life of the PLC (manual 5.2): what commands do to it, when a start and a stop are complete, and what a fault ends.

use alloc::vec::Vec;

use technol_image::program::RegionKind;
use technol_image::system;

use super::PlcEvent;
use crate::context::Context;
use crate::debugger::{Line, StopReason, module_and_file};
use crate::event::{Command, PlcState, RuntimeEvent};
use crate::execute::World;
use crate::fault::{Fault, FaultKind};
use crate::plan::PlanKind;
use crate::runtime::Runtime;

impl Runtime {
    /// A start does not wait for a held tick to be finished.
    pub(super) fn drop_held_tick_for_a_start(&mut self) {
        if self.debugger.stop.is_none() {
            return;
        }
        let start = self.commands.iter().rposition(|c| matches!(c, Command::StartPlc { .. }));
        if let Some(at) = start {
            // One by one: what `drain` does with the rest looks like recursion to whoever measures the stack.
            for _ in 0..at {
                self.commands.pop_front();
            }
            self.debugger.stop = None;
            self.debugger.focus = Line::Main;
            self.position = None;
        }
    }

    /// Does what the command asks for. Returns the plan that this takes, if any.
    pub(super) fn act(&mut self, command: Command, world: &mut World<'_>) -> Option<PlanKind> {
        match command {
            Command::StartPlc { cold } => {
                self.start(cold, world);
                world.control.start(cold);
                if cold {
                    world.control.power_on(self.machine.memory.bytes_mut());
                }
                return Some(PlanKind::Init);
            }
            Command::StopPlc { power_off } => {
                if self.state == PlcState::Stopping {
                    self.enter_stopped(world.events);
                } else if self.state.is_cycling() {
                    self.abort_block(world);
                    self.machine.done_seen = 0;
                    self.entry_dr = i64::from(!power_off);
                    self.set_state(PlcState::Stopping, world.events);
                    return Some(PlanKind::Done);
                }
            }
            Command::ClearPlc => return Some(PlanKind::Clear),
            Command::Halt => return (self.state != PlcState::Halted).then_some(PlanKind::Halt),
            Command::StartBlock(block) => self.accept_block(block, world.events),
            Command::ContinueBlock => {
                if self.block.request_restart(world.control.is_held(), &mut self.machine.memory) {
                    self.queue_event(system::event::START_REQ);
                }
            }
            Command::StopBlock { emergency } => {
                let request = if emergency { system::STOP_EMERGENCY_REQ } else { system::STOP_REQ };
                self.machine.memory.set_flag(request, self.state.is_cycling());
            }
            Command::AbortBlock => {
                self.machine.memory.set_flag(system::AUTPI, false);
                self.machine.memory.set_flag(system::CAPI, true);
                self.abort_block(world);
            }
            Command::Event(code) => self.queue_event(code),
            Command::PlcCommand { code, pressed } => self.queue_call(PlcEvent::Command { code, pressed }),
        }
        None
    }

    fn start(&mut self, cold: bool, world: &mut World<'_>) {
        if cold {
            self.initialise_memory();
        }
        if let Some(hidden) = self.program.region(RegionKind::Hidden) {
            self.machine.memory.fill(hidden.start as usize, hidden.len as usize, 0);
        }
        self.abort_block(world);
        self.machine.memory.set_flag(system::INPOS, true);
        self.machine.millis = 0;
        self.machine.init_seen = 0;
        self.machine.done_seen = 0;
        self.machine.state_since.fill(0);
        if let Some(trace) = &mut self.trace {
            trace.forget();
        }
        self.plc_events.clear();
        [&mut self.main, &mut self.fast, &mut self.cont].into_iter().for_each(Context::reset);
        self.outputs.fill(0);
        self.spent = 0;
        self.fault = None;
        self.debugger.step = None;
        self.debugger.focus = Line::Main;
        self.entry_dr = i64::from(!cold);
        self.set_state(PlcState::Starting, world.events);
    }

    /// Starting and stopping end when all files have reported.
    pub(super) fn settle(&mut self, events: &mut Vec<RuntimeEvent>) {
        let bits = |files: &[u8]| files.iter().fold(0_u64, |bits, file| bits | 1 << file);
        let missing_init = bits(&self.program.init_finished) & !self.machine.init_seen;
        let missing_done = bits(&self.program.done_finished) & !self.machine.done_seen;
        match self.state {
            PlcState::Starting if missing_init == 0 => self.set_state(PlcState::Running, events),
            PlcState::Stopping if missing_done == 0 => self.enter_stopped(events),
            _ => {}
        }
    }

    /// Content of memory when a program is loaded and at a cold start.
    pub(crate) fn initialise_memory(&mut self) {
        let memory = self.machine.memory.bytes_mut();
        memory.fill(0);
        for data in &self.program.initial {
            let start = data.addr as usize;
            memory[start..start + data.bytes.len()].copy_from_slice(&data.bytes);
        }
    }

    fn enter_stopped(&mut self, events: &mut Vec<RuntimeEvent>) {
        self.outputs.fill(0);
        self.set_state(PlcState::Stopped, events);
    }

    pub(super) fn set_state(&mut self, state: PlcState, events: &mut Vec<RuntimeEvent>) {
        if self.state != state {
            self.state = state;
            events.push(RuntimeEvent::StateChanged(state));
        }
    }

    pub(super) fn enter_faulted(&mut self, kind: FaultKind, line: Line, events: &mut Vec<RuntimeEvent>) {
        let ctx = self.line(line);
        let (module, file) = module_and_file(&self.program, ctx);
        let sequence = self.code.sequence_of(ctx.outermost());
        let fault = Fault { kind, pc: ctx.pc, sequence, module, file, cycle: self.cycle() };
        self.fault = Some(fault);
        self.outputs.fill(0);
        self.position = None;
        self.debugger.hold(StopReason::Fault, line);
        events.push(RuntimeEvent::Fault(fault));
        self.set_state(PlcState::Faulted, events);
    }
}
