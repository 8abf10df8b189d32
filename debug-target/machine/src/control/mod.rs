//! The simulated control around a program: it carries out what the runtime leaves to a
//! [`Control`](technol_runtime::Control). One file for each family of instructions.

use technol_image::service::Service;
use technol_runtime::{Call, Control, ControlMessage, FaultKind, Rate};

mod axes;
mod messages;

use messages::Messages;

use crate::config::MachineConfig;
use crate::motion::{Cells, Motion};

/// The control. Deterministic; a clone is a snapshot.
#[derive(Clone, Debug, Default)]
pub struct SimulatedControl {
    messages: Messages,
    motion: Motion,
}

impl SimulatedControl {
    /// A control as at power-on.
    #[must_use]
    pub fn new() -> SimulatedControl {
        SimulatedControl::default()
    }

    /// A control as at power-on with the axes and spindles of a machine.
    #[must_use]
    pub fn of(machine: &MachineConfig) -> SimulatedControl {
        SimulatedControl { motion: Motion::new(machine), ..SimulatedControl::default() }
    }

    /// Axes and spindles.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Axes and spindles, for what the operator does with them.
    pub fn motion_mut(&mut self) -> &mut Motion {
        &mut self.motion
    }
}

impl Control for SimulatedControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::Edef => self.messages.watch(call),
            other => {
                let known = axes::service(&mut self.motion, call)?;
                if known { Ok(()) } else { Err(FaultKind::NoService(other)) }
            }
        }
    }

    fn inputs(&mut self, rate: Rate, _millis: u64, memory: &mut [u8]) {
        if rate == Rate::Fast {
            self.motion.tick_ms(&mut Cells::new(memory));
        }
    }

    fn outputs(&mut self, rate: Rate, _millis: u64, memory: &mut [u8]) {
        if rate == Rate::Slow {
            self.messages.look(memory);
        }
    }

    fn next_message(&mut self) -> Option<ControlMessage> {
        self.messages.next()
    }

    fn start(&mut self, cold: bool) {
        self.motion.start(cold);
        self.messages = Messages::default();
    }
}
