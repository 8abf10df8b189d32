//! The simulated control around a TECHNOL program ([`SimulatedControl`]) and the machine behind it: contactors, moving
//! elements, encoders, turrets, latches, counters, analog values, slides, axes, keys, faults and the part-program blocks
//! the control starts.
//!
//! `no_std` + `alloc` and deterministic: the machine is a function of the outputs it sees and of the calls made
//! on it. One [`Plant::step`] is one millisecond.
#![no_std]

extern crate alloc;

mod analog;
mod block;
mod compile;
pub mod config;
mod contact;
mod control;
mod counter;
mod drive;
mod element;
mod encoder;
mod fault;
mod key;
mod latch;
mod limit;
pub mod motion;
mod plant;
mod ramp;
mod settings;
mod signal;
mod slide;
mod turret;
mod wiring;

pub use block::{BlockExtra, BlockFlag, BlockMode, BlockStart};
pub use compile::ConfigError;
pub use config::MachineConfig;
pub use control::{
    Analog, CAN_QUEUE, CanBus, CanDrive, CanPacket, CanUnit, ChannelWiring, Column, Connection, ControlData,
    Conversion, EcatSlave, EcatState, ElementError, ElementValue, EtherCat, Licences, Mapping, MessageBoard,
    MessageKind, MessageText, Physical, SERIAL_QUEUE, SerialPort, Shared, Shown, SimulatedControl,
    SpindleGears, Table, Value, ValueKind,
};
pub use drive::{Outputs, Signals};
pub use motion::{Cells, Motion};
pub use plant::{Plant, PlantEvent, UnknownName};
pub use settings::ControlSettings;
pub use signal::{INPUT_PORTS, OUTPUT_PORTS, Signal};
pub use wiring::{Wire, Wiring, wiring};
