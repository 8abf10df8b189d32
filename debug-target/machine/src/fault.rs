//! What breaks.

use alloc::string::String;

use crate::compile::Compiler;
use crate::config;
use crate::signal::{INPUT_PORTS, InputBit, OUTPUT_PORTS, OutputBit};

#[derive(Clone, Debug)]
pub(crate) struct Fault {
    pub(crate) name: String,
    effect: Effect,
    pub(crate) active: bool,
}

#[derive(Clone, Copy, Debug)]
enum Effect {
    Stuck(InputBit, bool),
    Broken(OutputBit),
}

impl Fault {
    pub(crate) fn compile(config: &config::Fault, compiler: &mut Compiler<'_>) -> Option<Fault> {
        let effect = match (&config.input, config.stuck, &config.output, config.broken) {
            (Some(input), Some(stuck), None, None) => Effect::Stuck(compiler.input("input", input)?, stuck),
            (None, None, Some(output), Some(true)) => Effect::Broken(compiler.output("output", output)?),
            _ => {
                compiler.error(
                    "",
                    "needs either `input` with `stuck = true` or `false`, or `output` with `broken = true`",
                );
                return None;
            }
        };
        Some(Fault { name: config.name.clone(), effect, active: config.active })
    }

    /// What the machine sees of the outputs.
    pub(crate) fn spoil_outputs(&self, outputs: &mut [u8; OUTPUT_PORTS]) {
        if let (true, Effect::Broken(bit)) = (self.active, self.effect) {
            bit.clear(outputs);
        }
    }

    /// What the PLC sees of the machine.
    pub(crate) fn spoil_inputs(&self, inputs: &mut [u8; INPUT_PORTS]) {
        if let (true, Effect::Stuck(bit, value)) = (self.active, self.effect) {
            bit.set(inputs, value);
        }
    }
}
