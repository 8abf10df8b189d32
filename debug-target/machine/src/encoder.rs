//! Pulses and a count while an output is on.

use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Drive, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Encoder {
    output: Drive,
    input: Option<InputBit>,
    direction: Option<Drive>,
    position: Vec<u8>,
    period: u32,
    /// Milliseconds into the period.
    phase: u32,
    /// Wraps at the width of `position`.
    count: u64,
}

impl Encoder {
    pub(crate) fn compile(config: &config::Encoder, compiler: &mut Compiler<'_>) -> Encoder {
        let output = compiler.drive("output", &config.output);
        let input = config.input.as_ref().and_then(|name| compiler.driven("input", name));
        let direction = config.direction.as_ref().map(|names| compiler.drive("direction", names));
        let position =
            config.position.iter().flat_map(|name| compiler.driven_bytes("position", name)).collect();
        if config.position.len() > 8 {
            compiler.error("position", "has more than 8 ports");
        }
        if config.input.is_none() && config.position.is_empty() {
            compiler.error("", "needs `input` or `position`, else nothing can be seen of it");
        }
        compiler.at_least("period-ms", config.period_ms, 2);
        Encoder { output, input, direction, position, period: config.period_ms, phase: 0, count: 0 }
    }

    pub(crate) fn reset(&mut self) {
        self.phase = 0;
        self.count = 0;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        if moves && self.output.is_on(world.outputs) {
            if self.phase == 0 {
                let down = self.direction.as_ref().is_some_and(|bit| bit.is_on(world.outputs));
                self.count = if down { self.count.wrapping_sub(1) } else { self.count.wrapping_add(1) };
            }
            if let Some(bit) = self.input {
                bit.set(inputs, self.phase < self.period / 2);
            }
            self.phase = (self.phase + 1) % self.period;
        } else if let Some(bit) = self.input {
            // It stops where it is: the pulse keeps its level.
            bit.set(inputs, self.phase > 0 && self.phase <= self.period / 2);
        }
        for (port, byte) in self.position.iter().zip(self.count.to_le_bytes()) {
            inputs[usize::from(*port)] = byte;
        }
    }
}
