//! What the fuzzer and the replay of its corpus share: no file of it needs the fuzzer.

#[path = "../completed/mod.rs"]
pub(crate) mod completed;
pub(crate) mod input;
pub(crate) mod mutation;
pub(crate) mod properties;
pub(crate) mod seeds;
