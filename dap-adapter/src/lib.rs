//! Debug Adapter Protocol server for TECHNOL programs: DAP on one side, the debug protocol of the target on the
//! other. `docs/design/debug-adapter.md` tells how it is built.
//!
//! - [`serve`], [`serve_stdio`], [`serve_tcp`]: one session per client.
//! - [`Connector`], [`ByteLink`], [`TargetSpec`]: whoever starts the adapter gives it a way to targets.
//! - [`Builder`], [`FileBuilder`]: from a project folder to a program.
//! - [`client`]: a DAP client for tests, demonstrations and scripts.

mod arguments;
pub mod client;
mod connection;
mod errors;
mod expression;
mod file_builder;
mod forcing;
mod kept_image;
mod live;
mod mechanisms;
mod memory;
#[cfg(test)]
mod mock;
mod outbox;
mod ports;
mod project;
mod registers;
mod request;
#[cfg(test)]
mod sample;
mod server;
mod session;
mod source_map;
mod target_link;
mod traced;
mod transport;
mod tree;
mod values;

pub use arguments::Policy;
pub use connection::{ByteLink, Clock, Connector, TargetSpec};
pub use file_builder::{Disk, FileBuilder};
pub use kept_image::KeptImage;
pub use project::{BuildFailure, Builder, BuiltProject, Problem};
pub use server::{Surroundings, serve, serve_stdio, serve_stream, serve_tcp};
