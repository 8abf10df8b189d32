//! Images: any bytes, and real programs with changed tables, loaded and run.
//!
//! What must hold, and what an input means, is in `tests/tests/hostile/image.rs`, which the tests use too.

#![no_main]

#[path = "../../tests/tests/hostile/image.rs"]
mod image;

use libfuzzer_sys::{Corpus, fuzz_target};

fuzz_target!(|input: &[u8]| -> Corpus {
    image::check(input);
    Corpus::Keep
});
