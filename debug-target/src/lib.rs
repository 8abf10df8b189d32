//! The host shell of the TECHNOL target: links (in-process, TCP, serial), clocks, `machine.toml`, and the loop
//! that lets a host debug a running program.
//!
//! - [`Simulation`]: a program and the machine behind it, without any link; what `technol run` needs.
//! - [`TargetCore`]: a simulation that answers the requests of the debug protocol.
//! - [`serve`]: a core at the end of a link. [`spawn_embedded`], [`listen_tcp`] and [`serve_serial`] do all of it.
//! - [`connect`]: the other end, for a debugger.

mod address;
mod answer;
mod clock;
mod connect;
mod convert;
mod core;
mod embedded;
mod event_log;
mod keep;
mod lines;
mod link;
mod listen;
mod machine_file;
mod part_program;
mod pipe;
mod serial;
mod serve;
mod simulation;
mod tcp;

pub use crate::core::{Clock, TargetCore, TargetOptions};
pub use address::{Address, AddressError, DEFAULT_BAUD};
pub use connect::{ConnectError, connect};
pub use embedded::{TargetHandle, spawn_embedded};
pub use event_log::{Decode, EventLog};
pub use keep::{Keep, TableWriter, replace};
pub use link::{Limits, Link};
pub use listen::{ListenError, Notice, listen_tcp, serve_listener, serve_serial};
pub use machine_file::{MachineFileError, load_machine, parse_machine};
pub use pipe::{MemoryLink, pair};
pub use serial::SerialLink;
pub use serve::{ServeEnd, serve};
pub use simulation::{Simulation, SimulationError};
pub use tcp::TcpLink;
