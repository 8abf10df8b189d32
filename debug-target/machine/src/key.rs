//! Keys of the operator panel.

use alloc::string::String;

use crate::compile::Compiler;
use crate::config;
use crate::signal::{INPUT_PORTS, InputBit};

#[derive(Clone, Debug)]
pub(crate) struct Key {
    pub(crate) name: String,
    input: InputBit,
    invert: bool,
    pub(crate) pressed: bool,
}

impl Key {
    pub(crate) fn compile(config: &config::Key, compiler: &mut Compiler<'_>) -> Option<Key> {
        let input = compiler.driven("input", &config.input)?;
        Some(Key { name: config.name.clone(), input, invert: config.invert, pressed: false })
    }

    pub(crate) fn step(&self, inputs: &mut [u8; INPUT_PORTS]) {
        self.input.set(inputs, self.pressed != self.invert);
    }
}
