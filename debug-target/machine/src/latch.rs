//! A relay that holds itself.

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Watch, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Latch {
    set: Watch,
    reset: Watch,
    input: InputBit,
    invert: bool,
    initially: bool,
    on: bool,
}

impl Latch {
    pub(crate) fn compile(config: &config::Latch, compiler: &mut Compiler<'_>) -> Option<Latch> {
        let set = compiler.watch("set", &config.set);
        let reset = compiler.watch("reset", &config.reset);
        let input = compiler.driven("input", &config.input)?;
        let (invert, initially) = (config.invert, config.initially);
        Some(Latch { set, reset, input, invert, initially, on: initially })
    }

    pub(crate) fn reset(&mut self) {
        self.on = self.initially;
    }

    /// Holds it on or off, whatever sets and resets it.
    pub(crate) fn hold(&mut self, on: bool) {
        self.on = on;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        if moves {
            self.on = (self.on || self.set.is_on(world)) && !self.reset.is_on(world);
        }
        self.show(inputs);
    }

    pub(crate) fn show(&self, inputs: &mut InputImage) {
        self.input.set(inputs, self.on != self.invert);
    }
}
