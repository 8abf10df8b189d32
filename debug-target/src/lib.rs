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
mod devices;
mod embedded;
mod event_log;
mod files;
mod keep;
mod lines;
mod link;
mod listen;
mod machine_file;
mod pipe;
mod recorded_streams;
mod recording;
mod sampling;
mod serial;
mod serve;
mod simulation;
mod tcp;
mod token;

pub use crate::core::{Clock, TargetCore, TargetOptions};
pub use address::{Address, AddressError, DEFAULT_BAUD};
pub use connect::{ConnectError, Connector, connect};
pub use devices::{Device, Usb, devices};
pub use embedded::{TargetHandle, spawn_embedded};
pub use event_log::{Decode, EventLog};
pub use files::{FolderError, RemoteFolder};
pub use keep::{Keep, TableWriter, replace};
pub use link::{Limits, Link};
pub use listen::{ListenError, Notice, listen_tcp, serve_listener, serve_serial};
pub use machine_file::{MachineFileError, load_machine, parse_machine, parse_machine_for};
pub use pipe::{MemoryLink, pair};
pub use recording::{RecordedLink, Recording, RecordingError, text_of_recording};
pub use serial::{SerialLink, SerialPlace};
pub use serve::{ServeEnd, TargetEnd, serve};
pub use simulation::{Simulation, SimulationError};
pub use tcp::TcpLink;
pub use token::{Token, TokenError};
