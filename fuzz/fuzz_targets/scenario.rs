//! Scenario files: read, and what is right is run. What must hold is in `cli/src/test/hostile.rs`.

#![no_main]

#[path = "../../tests/tests/hostile/text.rs"]
mod text;

use std::sync::LazyLock;

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};

static SEEDS: LazyLock<Vec<String>> = LazyLock::new(technol_cli::hostile::seeds);

fuzz_target!(|input: &[u8]| {
    technol_cli::hostile::check(&String::from_utf8_lossy(input));
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    // The fuzzer's own mutations of bytes, now and then.
    if seed.is_multiple_of(6) {
        return fuzzer_mutate(data, size, max_size);
    }
    text::mutate_in_place(data, size, max_size, &SEEDS, seed)
});
