//! What breaks.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::element::Mounted;
use crate::signal::{INPUT_PORTS, InputBit, OUTPUT_PORTS, OutputBit};

/// Times that an element may be slower.
const SLOWEST: u32 = 1000;

#[derive(Clone, Debug)]
pub(crate) struct Fault {
    pub(crate) name: String,
    effect: Effect,
    pub(crate) active: bool,
}

#[derive(Clone, Copy, Debug)]
enum Effect {
    /// An input stays like this.
    Stuck(InputBit, bool),
    /// An output does not reach the machine.
    Broken(OutputBit),
    /// An output has a short circuit, and does not reach the machine either.
    Shorted(OutputBit),
    /// A contact or latch, by index, stays like this.
    Held(usize, bool),
    /// An element, by index, moves in every n-th millisecond only; 0: never.
    Pace(usize, u32),
}

impl Fault {
    pub(crate) fn compile(
        config: &config::Fault,
        elements: &[Mounted],
        compiler: &mut Compiler<'_>,
    ) -> Option<Fault> {
        let config::Fault { input, output, element, stuck, broken, shorted, jammed, slow, .. } = config;
        let on = |flag: &Option<bool>| *flag == Some(true);
        let kinds = [stuck.is_some(), on(broken), on(shorted), on(jammed), slow.is_some()];
        let effect = match (input, output, element, kinds) {
            (Some(name), None, None, [true, false, false, false, false]) => {
                Effect::Stuck(compiler.input("input", name)?, on(stuck))
            }
            (Some(name), None, None, [false, true, false, false, false]) => {
                Effect::Stuck(compiler.input("input", name)?, false)
            }
            (None, Some(name), None, [false, true, false, false, false]) => {
                Effect::Broken(compiler.output("output", name)?)
            }
            (None, Some(name), None, [false, false, true, false, false]) => {
                Effect::Shorted(compiler.output("output", name)?)
            }
            (None, None, Some(name), [held, false, false, jammed, slow])
                if usize::from(held) + usize::from(jammed) + usize::from(slow) == 1 =>
            {
                on_element(name, config, elements, compiler)?
            }
            _ => {
                compiler.error(
                    "",
                    "needs one of: `input` with `stuck = true` or `false` or with `broken = true`; `output` with \
                     `broken = true` or `shorted = true`; `element` with `stuck`, `jammed = true` or `slow`",
                );
                return None;
            }
        };
        Some(Fault { name: config.name.clone(), effect, active: config.active })
    }

    /// What the machine sees of the outputs.
    pub(crate) fn spoil_outputs(&self, outputs: &mut [u8; OUTPUT_PORTS]) {
        if let (true, Effect::Broken(bit) | Effect::Shorted(bit)) = (self.active, self.effect) {
            bit.clear(outputs);
        }
    }

    /// What the PLC sees of the machine.
    pub(crate) fn spoil_inputs(&self, inputs: &mut [u8; INPUT_PORTS]) {
        if let (true, Effect::Stuck(bit, value)) = (self.active, self.effect) {
            bit.set(inputs, value);
        }
    }

    /// Hinders its element and marks its output.
    pub(crate) fn act(&self, elements: &mut [Mounted], shorted: &mut [u8; OUTPUT_PORTS]) {
        if !self.active {
            return;
        }
        match self.effect {
            Effect::Shorted(bit) => bit.set(shorted),
            Effect::Held(index, value) => {
                if let Some(mounted) = elements.get_mut(index) {
                    mounted.held = Some(value);
                }
            }
            Effect::Pace(index, pace) => {
                if let Some(mounted) = elements.get_mut(index) {
                    // Of several, the one that hinders most.
                    let stands = mounted.pace == 0 || pace == 0;
                    mounted.pace = if stands { 0 } else { mounted.pace.max(pace) };
                }
            }
            Effect::Stuck(..) | Effect::Broken(_) => {}
        }
    }
}

fn on_element(
    name: &str,
    config: &config::Fault,
    elements: &[Mounted],
    compiler: &mut Compiler<'_>,
) -> Option<Effect> {
    let found: Vec<usize> = (0..elements.len()).filter(|n| elements[*n].name == name).collect();
    let index = match found.as_slice() {
        [index] => *index,
        [] => {
            let known = elements.iter().map(|mounted| mounted.name.as_str()).filter(|name| !name.is_empty());
            let known: Vec<String> = known.map(|name| format!("`{name}`")).collect();
            let known = if known.is_empty() { "none has a name".to_string() } else { known.join(", ") };
            compiler.error("element", format!("no element is called `{name}`; there is {known}"));
            return None;
        }
        _ => {
            compiler
                .error("element", format!("several elements are called `{name}`; give them different names"));
            return None;
        }
    };
    if let Some(value) = config.stuck {
        if !elements[index].can_be_held() {
            compiler.error("stuck", "only a contact or a latch can be stuck; use `jammed = true`");
            return None;
        }
        return Some(Effect::Held(index, value));
    }
    let Some(slow) = config.slow else { return Some(Effect::Pace(index, 0)) };
    if !(2..=SLOWEST).contains(&slow) {
        compiler.error("slow", format!("must be 2 to {SLOWEST}: how many times as long everything takes"));
    }
    Some(Effect::Pace(index, slow))
}
