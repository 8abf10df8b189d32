//! The simulated control around a TECHNOL program ([`SimulatedControl`]) and the machine behind it: contactors, moving elements, encoders, turrets, keys,
//! faults and the part-program blocks the control starts.
//!
//! `no_std` + `alloc` and deterministic: the machine is a function of the outputs it sees and of the calls made
//! on it. One [`Plant::step`] is one millisecond.
#![no_std]

extern crate alloc;

mod block;
mod compile;
pub mod config;
mod contact;
mod control;
mod drive;
mod encoder;
mod fault;
mod key;
mod limit;
mod plant;
mod signal;
mod turret;

pub use block::{BlockMode, BlockStart};
pub use compile::ConfigError;
pub use config::MachineConfig;
pub use control::{
    CAN_QUEUE, CanBus, CanDrive, CanPacket, CanUnit, EcatSlave, EcatState, EtherCat, Licences, SERIAL_QUEUE,
    SerialPort, SimulatedControl,
};
pub use drive::Outputs;
pub use plant::{Plant, PlantEvent, UnknownName};
pub use signal::{INPUT_PORTS, OUTPUT_PORTS, Signal, parse_port};
