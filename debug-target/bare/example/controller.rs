//! A controller in Rust: a program, the hardware it drives, and for what the hardware does not have the simulated control.
//!
//! This file is all of it. The C library builds it without a standard library (and leaves it out of what it delivers); the tests
//! run it.

extern crate alloc;

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use technol_image::Service;
use technol_machine::SimulatedControl;
use technol_runtime::{
    AxesOfBlock, BlockMotion, BlockSpindle, BlockWay, Call, Command, Control, ControlCall, ControlMessage,
    FaultKind, Hold, InputImage, OutputImage, Rate, Runtime, RuntimeEvent,
};

/// Bytes of a CAN packet in memory.
const PACKET: usize = 12;

/// What this controller has.
pub trait Hardware {
    /// The input ports as they are now.
    fn read(&mut self, inputs: &mut InputImage);
    /// Drives the output ports.
    fn write(&mut self, outputs: &OutputImage);
    /// Sends a packet to a CAN bus; false when there is no room for it.
    fn send(&mut self, channel: i64, packet: &[u8]) -> bool;
    /// The program asks the operator for attention, or something happened to the PLC.
    fn tell(&mut self, event: &RuntimeEvent);
}

/// A program on its hardware.
pub struct Controller<H> {
    runtime: Runtime,
    around: Around<H>,
    inputs: InputImage,
    /// Empty between two ticks, with room for what happens in one.
    events: Vec<RuntimeEvent>,
}

impl<H: Hardware> Controller<H> {
    /// Loads an image file.
    ///
    /// # Errors
    /// Why it is refused, in words.
    pub fn load(image: &[u8], hardware: H) -> Result<Controller<H>, String> {
        let image = technol_image::decode(image).map_err(|error| error.to_string())?;
        let runtime = Runtime::new(image.program).map_err(|error| error.to_string())?;
        let mut rest = SimulatedControl::new();
        // Room for what the instructions of this program will need, so that a tick asks for none.
        rest.prepare(&runtime.program().services);
        let around = Around { hardware, rest };
        Ok(Controller { runtime, around, inputs: [0; 128], events: Vec::with_capacity(64) })
    }

    /// Starts the PLC with the next [`Controller::millisecond`].
    pub fn start(&mut self, cold: bool) {
        self.runtime.command(Command::StartPlc { cold });
    }

    /// To be called each millisecond.
    pub fn millisecond(&mut self) {
        self.around.hardware.read(&mut self.inputs);
        self.runtime.tick_with(&self.inputs, &mut self.around, &mut self.events);
        self.around.hardware.write(self.runtime.outputs());
        for event in self.events.drain(..) {
            self.around.hardware.tell(&event);
        }
    }

    /// The PLC, for what else a host wants of it.
    pub fn runtime(&self) -> &Runtime {
        &self.runtime
    }

    /// The hardware.
    pub fn hardware(&self) -> &H {
        &self.around.hardware
    }
}

/// The control around the program. What is not the hardware's goes to the simulated control.
struct Around<H> {
    hardware: H,
    rest: SimulatedControl,
}

impl<H: Hardware> Around<H> {
    /// CAN_SEND channel, packet: identifier, a byte that is not used, length, data. DR is 0 when the packet was taken.
    fn can_send(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let channel = call.integer(0)?.unwrap_or_default();
        let packet = call.content(1)?;
        let sent = self.hardware.send(channel, &packet[..packet.len().min(PACKET)]);
        call.set_dr(i64::from(!sent));
        Ok(())
    }
}

impl<H: Hardware> Control for Around<H> {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::CanSend => self.can_send(call),
            _ => self.rest.service(call),
        }
    }

    // The rest is handed on as it is.

    fn inputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        self.rest.inputs(rate, millis, memory);
    }

    fn outputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        self.rest.outputs(rate, millis, memory);
    }

    fn fast_links(&mut self, millis: u64, memory: &mut [u8]) {
        self.rest.fast_links(millis, memory);
    }

    fn next_message(&mut self) -> Option<ControlMessage> {
        self.rest.next_message()
    }

    fn next_call(&mut self, memory: &mut [u8]) -> Option<ControlCall> {
        self.rest.next_call(memory)
    }

    fn start(&mut self, cold: bool) {
        self.rest.start(cold);
    }

    fn block_spindle(&mut self, spindle: &BlockSpindle, memory: &mut [u8]) {
        self.rest.block_spindle(spindle, memory);
    }

    fn take_axes(&mut self, motion: &BlockMotion<'_>, memory: &mut [u8]) -> AxesOfBlock {
        self.rest.take_axes(motion, memory)
    }

    fn release_axes(&mut self) {
        self.rest.release_axes();
    }

    fn block_way(&self) -> BlockWay {
        self.rest.block_way()
    }

    fn in_position(&self) -> bool {
        self.rest.in_position()
    }

    fn hold(&mut self, hold: Hold) {
        self.rest.hold(hold);
    }

    fn is_held(&self) -> bool {
        self.rest.is_held()
    }

    fn end_block(&mut self, memory: &mut [u8]) {
        self.rest.end_block(memory);
    }

    fn power_on(&mut self, memory: &mut [u8]) {
        self.rest.power_on(memory);
    }
}
