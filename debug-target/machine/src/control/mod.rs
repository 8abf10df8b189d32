//! The simulated control around a program: it carries out what the runtime leaves to a
//! [`Control`](technol_runtime::Control). One file for each family of instructions.

use technol_image::service::Service;
use technol_runtime::{Call, Control, ControlMessage, FaultKind, Rate};

mod messages;

use messages::Messages;

/// The control. Deterministic; a clone is a snapshot.
#[derive(Clone, Debug, Default)]
pub struct SimulatedControl {
    messages: Messages,
}

impl SimulatedControl {
    /// A control as at power-on.
    #[must_use]
    pub fn new() -> SimulatedControl {
        SimulatedControl::default()
    }
}

impl Control for SimulatedControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::Edef => self.messages.watch(call),
            other => Err(FaultKind::NoService(other)),
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

    fn start(&mut self, _cold: bool) {
        self.messages = Messages::default();
    }
}
