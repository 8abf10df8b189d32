//! An element that moves between two ends.

use crate::compile::Compiler;
use crate::config::{self, End};
use crate::drive::{Drive, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Limit {
    forward: Drive,
    backward: Option<Drive>,
    at_start: Option<InputBit>,
    at_end: Option<InputBit>,
    /// Position per millisecond forward and backward, chosen so that both times come out exactly.
    step_forward: u64,
    step_backward: u64,
    travel: u64,
    initially: u64,
    position: u64,
}

impl Limit {
    pub(crate) fn compile(config: &config::Limit, compiler: &mut Compiler<'_>) -> Limit {
        let forward = compiler.drive("output-forward", &config.output_forward);
        // What is given but wrong is reported, and then the whole machine is refused.
        let backward = config.output_backward.as_ref().map(|names| compiler.drive("output-backward", names));
        let at_start =
            config.input_at_start.as_ref().and_then(|name| compiler.driven("input-at-start", name));
        let at_end = config.input_at_end.as_ref().and_then(|name| compiler.driven("input-at-end", name));
        if config.input_at_start.is_none() && config.input_at_end.is_none() {
            compiler.error("", "needs `input-at-start` or `input-at-end`, else nothing can be seen of it");
        }
        let return_ms = config.return_ms.unwrap_or(config.travel_ms);
        compiler.at_least("travel-ms", config.travel_ms, 1);
        if let Some(return_ms) = config.return_ms {
            compiler.at_least("return-ms", return_ms, 1);
        }
        let (there, back) = (u64::from(config.travel_ms), u64::from(return_ms));
        let travel = there * back;
        let initially = if config.initially == End::Start { 0 } else { travel };
        Limit {
            forward,
            backward,
            at_start,
            at_end,
            step_forward: back,
            step_backward: there,
            travel,
            initially,
            position: initially,
        }
    }

    pub(crate) fn reset(&mut self) {
        self.position = self.initially;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        let forward = self.forward.is_on(world.outputs);
        let backward = self.backward.as_ref().map_or(!forward, |bit| bit.is_on(world.outputs));
        // Driven both ways at once it stands still.
        if moves && forward && !backward {
            self.position = (self.position + self.step_forward).min(self.travel);
        } else if moves && backward && !forward {
            self.position = self.position.saturating_sub(self.step_backward);
        }
        if let Some(bit) = self.at_start {
            bit.set(inputs, self.position == 0);
        }
        if let Some(bit) = self.at_end {
            bit.set(inputs, self.position == self.travel);
        }
    }
}
