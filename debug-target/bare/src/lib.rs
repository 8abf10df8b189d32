//! The runtime as a C library for controllers without an operating system. `include/technol.h` is its interface,
//! `docs/porting.md` tells how to use it.
//!
//! Besides being useful, building this crate is the proof that image, wire, runtime and machine need no standard
//! library: with one that does, there would be two panic handlers, and the build fails.
#![no_std]

extern crate alloc;

mod c;
mod heap;
mod plc;

// Nothing of these is reached from C yet; naming them makes them part of the proof.
use technol_machine as _;
use technol_wire as _;
