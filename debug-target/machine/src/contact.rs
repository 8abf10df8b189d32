//! A contact that follows an output with a delay.

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Drive, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Contact {
    output: Drive,
    input: InputBit,
    on_delay: u32,
    off_delay: u32,
    invert: bool,
    closed: bool,
    /// Milliseconds for which the output has differed from the contact.
    differs: u32,
}

impl Contact {
    pub(crate) fn compile(config: &config::Contact, compiler: &mut Compiler<'_>) -> Option<Contact> {
        let output = compiler.drive("output", &config.output);
        let input = compiler.driven("input", &config.input);
        Some(Contact {
            output,
            input: input?,
            on_delay: config.on_delay_ms,
            off_delay: config.off_delay_ms,
            invert: config.invert,
            closed: false,
            differs: 0,
        })
    }

    pub(crate) fn reset(&mut self) {
        self.closed = false;
        self.differs = 0;
    }

    /// Holds it closed or open, whatever drives it.
    pub(crate) fn hold(&mut self, closed: bool) {
        self.closed = closed;
        self.differs = 0;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        let driven = self.output.is_on(world.outputs);
        if driven == self.closed {
            self.differs = 0;
        } else if moves {
            if self.differs >= if driven { self.on_delay } else { self.off_delay } {
                self.hold(driven);
            } else {
                self.differs += 1;
            }
        }
        self.show(inputs);
    }

    pub(crate) fn show(&self, inputs: &mut InputImage) {
        self.input.set(inputs, self.closed != self.invert);
    }
}
