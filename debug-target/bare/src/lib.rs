//! The runtime as a C library for controllers without an operating system. `include/technol.h` is its interface,
//! `docs/porting.md` tells how to use it.
//!
//! Besides being useful, building this crate is the proof that image, wire, runtime and machine need no standard
//! library: with one that does, there would be two panic handlers, and the build fails.
#![no_std]

extern crate alloc;

mod c;
mod control;
mod heap;
mod plc;

/// The example in Rust is built with the library, so that it is part of the proof; it is not delivered.
#[allow(dead_code)]
#[allow(unreachable_pub)]
#[path = "../example/controller.rs"]
mod controller;

// Nothing of this is reached from C yet; naming it makes it part of the proof.
use technol_wire as _;
