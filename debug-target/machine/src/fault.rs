//! What breaks.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::element::Mounted;
use crate::signal::{InputBit, InputImage, OutputBit, OutputImage};

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
    /// Something on a bus.
    Bus(BusFault),
}

/// What is wrong on a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BusFault {
    /// Nobody reaches the slave of this place.
    SlaveLost(u16),
    /// The cable is cut in front of the slave of this place: those behind are lost too.
    EtherCatCut(u16),
    /// The drive of this place is in error, with this code.
    SlaveError(u16, u16),
    /// Nobody reaches the CAN drive of this axis.
    CanDriveLost(u8),
    /// The CAN drive of this axis is in error, with this code.
    CanDriveError(u8, u16),
    /// The cable of this CAN channel is cut.
    CanCut(u8),
}

impl Fault {
    pub(crate) fn compile(
        config: &config::Fault,
        machine: &config::MachineConfig,
        elements: &[Mounted],
        compiler: &mut Compiler<'_>,
    ) -> Option<Fault> {
        if is_on_bus(config) {
            let effect = on_bus(config, machine, compiler)?;
            return Some(Fault { name: config.name.clone(), effect, active: config.active });
        }
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
                     `broken = true` or `shorted = true`; `element` with `stuck`, `jammed = true` or `slow`; `slave` \
                     with `lost = true`, `cut = true` or `error`; `can-drive` with `lost = true` or `error`; `can` with \
                     `cut = true`",
                );
                return None;
            }
        };
        Some(Fault { name: config.name.clone(), effect, active: config.active })
    }

    /// What it does on a bus, while it is there.
    pub(crate) fn on_bus(&self) -> Option<BusFault> {
        match self.effect {
            Effect::Bus(fault) if self.active => Some(fault),
            _ => None,
        }
    }

    /// What the machine sees of the outputs.
    pub(crate) fn spoil_outputs(&self, outputs: &mut OutputImage) {
        if let (true, Effect::Broken(bit) | Effect::Shorted(bit)) = (self.active, self.effect) {
            bit.clear(outputs);
        }
    }

    /// What the PLC sees of the machine.
    pub(crate) fn spoil_inputs(&self, inputs: &mut InputImage) {
        if let (true, Effect::Stuck(bit, value)) = (self.active, self.effect) {
            bit.set(inputs, value);
        }
    }

    /// Hinders its element and marks its output.
    pub(crate) fn act(&self, elements: &mut [Mounted], shorted: &mut OutputImage) {
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
            Effect::Stuck(..) | Effect::Broken(_) | Effect::Bus(_) => {}
        }
    }
}

/// It says what is wrong with one thing on a bus, and nothing else.
fn is_on_bus(config: &config::Fault) -> bool {
    let on = |flag: Option<bool>| flag == Some(true);
    let flags = [config.broken, config.shorted, config.jammed];
    let other = config.input.is_some() || config.output.is_some() || config.element.is_some();
    let other = other || flags.iter().any(Option::is_some) || config.stuck.is_some() || config.slow.is_some();
    let what = (on(config.lost), on(config.cut), config.error.is_some());
    let fits = match (&config.slave, config.can_drive, config.can) {
        (Some(_), None, None) => {
            matches!(what, (true, false, false) | (false, true, false) | (false, false, true))
        }
        (None, Some(_), None) => matches!(what, (true, false, false) | (false, false, true)),
        (None, None, Some(_)) => what == (false, true, false),
        _ => false,
    };
    fits && !other
}

/// A fault on a bus.
fn on_bus(
    config: &config::Fault,
    machine: &config::MachineConfig,
    compiler: &mut Compiler<'_>,
) -> Option<Effect> {
    let is_cut = config.cut == Some(true);
    let fault = if let Some(name) = &config.slave {
        let Some(place) = machine.ethercat.iter().position(|slave| slave.name == *name) else {
            compiler.error("slave", format!("no slave of `[[ethercat]]` is called `{name}`"));
            return None;
        };
        if config.error.is_some() && !machine.ethercat[place].drive {
            compiler.error("error", "belongs to a drive; the slave has no `drive = true`");
            return None;
        }
        // There are at most 256 slaves.
        let place = place as u16;
        match config.error {
            Some(code) => BusFault::SlaveError(place, code),
            None if is_cut => BusFault::EtherCatCut(place),
            None => BusFault::SlaveLost(place),
        }
    } else if let Some(axis) = config.can_drive {
        if !machine.can_drive.iter().any(|drive| drive.axis == axis) {
            compiler.error("can-drive", format!("no `[[can-drive]]` is that of axis {axis}"));
            return None;
        }
        config.error.map_or(BusFault::CanDriveLost(axis), |code| BusFault::CanDriveError(axis, code))
    } else {
        let can = config.can?;
        if !(1..=2).contains(&can) {
            compiler.error("can", format!("{can} is not between 1 and 2"));
            return None;
        }
        BusFault::CanCut(can)
    };
    Some(Effect::Bus(fault))
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
