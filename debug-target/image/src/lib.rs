//! The program image: what the compiler hands to the runtime target, and the debug information that maps it
//! back to source.
//!
//! `no_std` + `alloc`. An image file is written by [`container::encode`] and read by [`container::decode`];
//! both parts are versioned, checksummed and identified by a content hash. The target needs only
//! [`program::Program`]; [`debug_info::DebugInfo`] stays on the programmer's PC.
#![no_std]

extern crate alloc;

pub mod assembler;
pub mod container;
pub mod debug_info;
mod mnemonic;
pub mod op;
pub mod program;
pub mod service;
pub mod signal;
pub mod system;

pub use container::{DecodeError, Image, decode, encode};
pub use debug_info::DebugInfo;
pub use op::{BitRef, Cond, Op, Place, Source, Width};
pub use program::{ContentHash, Program};
pub use service::{Arg, Service, ServiceCall};
pub use signal::Signal;
