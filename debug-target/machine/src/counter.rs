//! Pulses counted up to a number.

use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Watch, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Counter {
    pulses: Watch,
    /// Without it the pulse after the last one begins anew.
    reset: Option<Watch>,
    last: u32,
    input: Option<InputBit>,
    value: Vec<u8>,
    count: u32,
    /// Level of the pulses; they count as on at first, so that only a change counts.
    was_on: bool,
}

impl Counter {
    pub(crate) fn compile(config: &config::Counter, compiler: &mut Compiler<'_>) -> Counter {
        let pulses = compiler.watch("pulses", &config.pulses);
        let reset = config.reset.as_ref().map(|names| compiler.watch("reset", names));
        let input = config.input.as_ref().and_then(|name| compiler.driven("input", name));
        let value = compiler.driven_ports("value", &config.value, 4, u64::from(config.count));
        compiler.at_least("count", config.count, 1);
        if config.input.is_none() && config.value.is_empty() {
            compiler.error("", "needs `input` or `value`, else nothing can be seen of it");
        }
        Counter { pulses, reset, last: config.count, input, value, count: 0, was_on: true }
    }

    pub(crate) fn reset(&mut self) {
        self.count = 0;
        self.was_on = true;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        let on = self.pulses.is_on(world);
        let was_on = core::mem::replace(&mut self.was_on, on);
        let pulse = on && !was_on;
        if self.reset.as_ref().is_some_and(|reset| reset.is_on(world)) {
            self.count = 0;
        } else if pulse && moves {
            match &self.reset {
                None if self.count == self.last => self.count = 1,
                _ => self.count = (self.count + 1).min(self.last),
            }
        }
        if let Some(bit) = self.input {
            bit.set(inputs, self.count == self.last);
        }
        for (port, byte) in self.value.iter().zip(self.count.to_le_bytes()) {
            inputs[usize::from(*port)] = byte;
        }
    }
}
