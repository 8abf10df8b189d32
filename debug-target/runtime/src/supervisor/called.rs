//! Procedures that the control calls, those of events among them.

use super::Progress;
use crate::block::QUEUE_LEN;
use crate::context::Root;
use crate::debugger::Line;
use crate::execute::World;
use crate::runtime::Runtime;

/// Procedures the control may call in a cycle; the others wait for the next.
const CALLS_PER_CYCLE: usize = 256;

/// A call of an event procedure that waits for its cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlcEvent {
    /// `_ON_EVENT` with this code.
    Event(i64),
    /// `_ON_CMD` with code and key.
    Command { code: i32, pressed: bool },
}

impl Runtime {
    pub(super) fn queue_event(&mut self, code: i64) {
        self.queue_call(PlcEvent::Event(code));
    }

    /// Events nobody handles are dropped, and so is one beyond the bound.
    pub(super) fn queue_call(&mut self, event: PlcEvent) {
        if self.handler(event).is_some() && self.plc_events.len() < QUEUE_LEN {
            self.plc_events.push_back(event);
        }
    }

    fn handler(&self, event: PlcEvent) -> Option<u16> {
        match event {
            PlcEvent::Event(_) => self.code.on_event,
            PlcEvent::Command { .. } => self.code.on_cmd,
        }
    }

    /// Procedures that the control calls.
    pub(super) fn run_calls(&mut self, world: &mut World<'_>) -> Progress {
        for _ in 0..CALLS_PER_CYCLE {
            if !self.position.is_some_and(|p| p.entered) {
                let memory = self.machine.memory.bytes_mut();
                let Some(call) = world.control.next_call(memory) else { return Progress::Done };
                let procedure = self.program.procedures.get(usize::from(call.procedure));
                let Some(start) = procedure.map(|procedure| procedure.start) else { continue };
                self.enter(Line::Main, Root::Procedure, start, Some(call.dr));
            }
            if self.execute(Line::Main, true, world) == Progress::Stopped {
                return Progress::Stopped;
            }
        }
        Progress::Done
    }

    pub(super) fn run_events(&mut self, world: &mut World<'_>) -> Progress {
        loop {
            if !self.position.is_some_and(|p| p.entered) {
                let Some(event) = self.plc_events.pop_front() else { return Progress::Done };
                let Some(procedure) = self.handler(event) else { continue };
                let start = self.program.procedures[usize::from(procedure)].start;
                let dr = match event {
                    PlcEvent::Event(code) => code,
                    PlcEvent::Command { code, .. } => i64::from(code),
                };
                self.enter(Line::Main, Root::Procedure, start, Some(dr));
                if let PlcEvent::Command { pressed, .. } = event {
                    self.main.regs.rlo = pressed;
                }
            }
            if self.execute(Line::Main, true, world) == Progress::Stopped {
                return Progress::Stopped;
            }
        }
    }
}
