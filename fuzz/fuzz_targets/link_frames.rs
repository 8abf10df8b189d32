//! Frames: any bytes on a line. What must hold is in `tests/tests/hostile/link.rs`, which the tests use too.

#![no_main]

#[allow(dead_code)] // the other targets use the rest
#[path = "../../tests/tests/hostile/link.rs"]
mod link;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|input: &[u8]| link::frames(input));
