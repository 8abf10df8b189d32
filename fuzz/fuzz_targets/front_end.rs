//! The front end under any text: bytes, and mutations of the fixtures' tokens and lines.
//!
//! What must hold, and how texts are changed, is in `analysis/tests/fuzzing`, which the tests use too.

#![no_main]

#[path = "../../analysis/tests/fuzzing/mod.rs"]
mod fuzzing;

use std::sync::LazyLock;

use fuzzing::mutation::Mutator;
use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};

static MUTATOR: LazyLock<Mutator> = LazyLock::new(|| Mutator::new(fuzzing::seeds::all()));

fuzz_target!(|input: &[u8]| fuzzing::properties::check(input));

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    // The fuzzer's own mutations of bytes, now and then.
    if seed.is_multiple_of(6) {
        return fuzzer_mutate(data, size, max_size);
    }
    let changed = MUTATOR.mutate(&data[..size], max_size, u64::from(seed));
    data[..changed.len()].copy_from_slice(&changed);
    changed.len()
});
