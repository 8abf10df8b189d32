//! The simulated control around a program: it carries out what the runtime leaves to a
//! [`Control`](technol_runtime::Control). One file for each family of instructions.

use technol_image::service::Service;
use technol_runtime::{Call, Control, ControlCall, ControlMessage, FaultKind, Rate};

mod can;
pub(crate) mod config;
mod ethercat;
mod licence;
mod messages;
mod objects;
mod serial;

use can::{Drives, Units};
use messages::Messages;
use serial::Serial;

pub use can::{CAN_QUEUE, CanBus, CanDrive, CanPacket, CanUnit};
pub use ethercat::{EcatSlave, EcatState, EtherCat};
pub use licence::Licences;
pub use serial::{SERIAL_QUEUE, SerialPort};

/// The control. Deterministic; a clone is a snapshot.
#[derive(Clone, Debug, Default)]
pub struct SimulatedControl {
    messages: Messages,
    serial: Serial,
    licences: Licences,
    can: CanBus,
    units: Units,
    drives: Drives,
    ethercat: EtherCat,
}

impl SimulatedControl {
    /// A control as at power-on.
    #[must_use]
    pub fn new() -> SimulatedControl {
        SimulatedControl::default()
    }

    /// A logical channel of serial ports; it is configured from the first time on.
    pub fn serial_mut(&mut self, channel: u8) -> &mut SerialPort {
        self.serial.port(channel)
    }

    /// The hardware key and its licences.
    pub fn licences_mut(&mut self) -> &mut Licences {
        &mut self.licences
    }

    /// The CAN channels that the program shares.
    pub fn can_mut(&mut self) -> &mut CanBus {
        &mut self.can
    }

    /// A unit of the control on the CAN bus: channel (1, 2), group (1 to 3), number in the group (1 to 32). It is present from
    /// the first time on.
    pub fn can_unit_mut(&mut self, can: u8, group: u8, board: u8) -> &mut CanUnit {
        self.units.unit(can, group, board)
    }

    /// The CAN drive of an axis (1 to 16); it is there from the first time on.
    pub fn can_drive_mut(&mut self, axis: u8) -> &mut CanDrive {
        self.drives.drive(axis)
    }

    /// The EtherCAT master.
    pub fn ethercat_mut(&mut self) -> &mut EtherCat {
        &mut self.ethercat
    }
}

impl Control for SimulatedControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::Edef => self.messages.watch(call),
            Service::ComSend | Service::ComSendStr | Service::ComRecv | Service::ComControl => {
                self.serial.execute(call)
            }
            Service::LdrLic => {
                self.licences.load(call);
                Ok(())
            }
            Service::CanSend
            | Service::CanRecv
            | Service::CanRecvReq
            | Service::CanRecvEnd
            | Service::CanRecvDel => self.can.execute(call),
            Service::CanSysioRead | Service::CanSysioWrite => self.units.execute(call),
            Service::CanAxSend => self.drives.send(call),
            Service::EcatCommand
            | Service::EcatCoeRead
            | Service::EcatCoeWrite
            | Service::EcatSoeRead
            | Service::EcatSoeWrite => self.ethercat.execute(call),
            other => Err(FaultKind::NoService(other)),
        }
    }

    fn inputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        // The buses run in PLC time, which stands while the debugger holds the program.
        if rate != Rate::Fast {
            return;
        }
        self.serial.tick();
        self.can.tick();
        self.drives.tick();
        if millis.is_multiple_of(20) {
            self.units.cycle();
            self.drives.inputs(memory);
            self.ethercat.cycle();
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

    fn next_call(&mut self, memory: &mut [u8]) -> Option<ControlCall> {
        self.can.next_call(memory)
    }

    fn start(&mut self, cold: bool) {
        self.messages = Messages::default();
        self.serial.start();
        self.can.start();
        self.drives.start(cold);
        self.ethercat.start(cold);
    }
}
