//! A serial cable in virtual time, for tests of what talks over one.
//!
//! Bytes go in at one end and come out at the other when a line of that baud rate would have carried them, damaged
//! as asked for: flipped bits, lost, inserted and repeated bytes, bursts, cuts, frames that are lost, doubled or
//! late, and an adapter that hands bytes over only every few milliseconds. Same seed, same damage: no clock, no
//! randomness from outside.
//!
//! - [`Line`]: one direction. [`Cable`]: both.
//! - [`Fault`]: one fault at one place, to see what it costs.
//! - [`Random`]: repeatable randomness for the rest of a test.

mod fault;
mod line;
mod random;

pub use fault::{Fault, Faults};
pub use line::{Cable, Cuts, Line, LineOptions};
pub use random::Random;
