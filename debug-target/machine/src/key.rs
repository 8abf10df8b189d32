//! Keys of the operator panel.

use alloc::string::String;

use crate::compile::Compiler;
use crate::config;
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Key {
    pub(crate) name: String,
    input: Option<InputBit>,
    invert: bool,
    command: Option<i32>,
    pub(crate) pressed: bool,
    /// As the control saw it last.
    seen: bool,
}

impl Key {
    pub(crate) fn compile(config: &config::Key, compiler: &mut Compiler<'_>) -> Key {
        let input = config.input.as_ref().and_then(|name| compiler.driven("input", name));
        if config.input.is_none() && config.command.is_none() {
            compiler.error("", "needs `input` or `command`, else it does nothing");
        }
        let (invert, command) = (config.invert, config.command);
        Key { name: config.name.clone(), input, invert, command, pressed: false, seen: false }
    }

    pub(crate) fn step(&self, inputs: &mut InputImage) {
        if let Some(input) = self.input {
            input.set(inputs, self.pressed != self.invert);
        }
    }

    /// Its command, and whether the key went down, when that changed.
    pub(crate) fn command(&mut self) -> Option<(i32, bool)> {
        let changed = core::mem::replace(&mut self.seen, self.pressed) != self.pressed;
        self.command.filter(|_| changed).map(|code| (code, self.pressed))
    }
}
