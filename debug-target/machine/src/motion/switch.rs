//! A switch at positions of an axis: what connects the axes of the control with the inputs of the program.

use alloc::format;

use super::Motion;
use super::config;
use super::number::Thousandths;
use crate::compile::Compiler;
use crate::signal::{InputBit, InputImage};

/// One switch; µm in the machine's own coordinate.
#[derive(Clone, Debug)]
pub(crate) struct AxisSwitch {
    input: InputBit,
    axis: u8,
    servo: Option<u8>,
    from: f64,
    to: f64,
    invert: bool,
    on: bool,
}

impl AxisSwitch {
    pub(crate) fn compile(
        axis: &config::Axis,
        switch: &config::Switch,
        compiler: &mut Compiler<'_>,
    ) -> Option<AxisSwitch> {
        let input = compiler.driven("switch", &switch.input);
        let name = &switch.input;
        if switch.from.is_none() && switch.to.is_none() {
            compiler.error("switch", format!("`{name}` needs `from`, `to` or both"));
        }
        if let (Some(from), Some(to)) = (switch.from, switch.to)
            && from > to
        {
            compiler
                .error("switch", format!("`{name}`: `from` ({from}) must not be greater than `to` ({to})"));
        }
        let own = axis.servos.is_empty() && switch.servo == Some(axis.number);
        if let Some(servo) = switch.servo.filter(|servo| !own && !axis.servos.contains(servo)) {
            compiler.error("switch", format!("`{name}`: servo loop {servo} does not belong to this axis"));
        }
        let mut switch = AxisSwitch {
            input: input?,
            axis: axis.number,
            servo: switch.servo,
            from: switch.from.map_or(f64::NEG_INFINITY, Thousandths::thousandths),
            to: switch.to.map_or(f64::INFINITY, Thousandths::thousandths),
            invert: switch.invert,
            on: false,
        };
        switch.look(axis.start.thousandths());
        Some(switch)
    }

    /// Its axis is here.
    pub(crate) fn place(&mut self, motion: &Motion) {
        if let Some(place) = motion.place(self.axis, self.servo) {
            self.look(place);
        }
    }

    fn look(&mut self, place: f64) {
        self.on = (self.from..=self.to).contains(&place) != self.invert;
    }

    pub(crate) fn step(&self, inputs: &mut InputImage) {
        self.input.set(inputs, self.on);
    }
}
