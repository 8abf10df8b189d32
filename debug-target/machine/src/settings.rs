//! What the machine file says about the control itself: its keys and settings.

use alloc::format;
use alloc::vec::Vec;

use technol_image::system::m_group;

use crate::compile::Compiler;
use crate::config::MachineConfig;
use crate::control::clock;
use crate::drive::{Watch, World};

/// Settings of the control.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ControlSettings {
    /// M functions and their groups.
    pub m_groups: Vec<(u8, u8)>,
    /// M01 stops.
    pub conditional_stop: bool,
}

/// Signals that are keys of the control.
#[derive(Clone, Debug)]
pub(crate) struct ControlKey {
    watch: Watch,
    was_on: bool,
}

impl ControlKey {
    pub(crate) fn reset(&mut self) {
        self.was_on = true;
    }

    /// It goes down in this millisecond.
    pub(crate) fn goes_down(&mut self, world: World<'_>) -> bool {
        let on = self.watch.is_on(world);
        let was_on = core::mem::replace(&mut self.was_on, on);
        on && !was_on
    }
}

/// START, STOP and emergency stop.
#[derive(Clone, Debug, Default)]
pub(crate) struct ControlKeys {
    pub(crate) start: Option<ControlKey>,
    pub(crate) stop: Option<ControlKey>,
    pub(crate) emergency_stop: Option<ControlKey>,
}

impl ControlKeys {
    pub(crate) fn compile(config: &MachineConfig, compiler: &mut Compiler<'_>) -> ControlKeys {
        compiler.enter("control", None);
        let mut key = |name, signals: &Option<_>| {
            let signals = signals.as_ref()?;
            Some(ControlKey { watch: compiler.watch(name, signals), was_on: true })
        };
        let control = &config.control;
        ControlKeys {
            start: key("start", &control.start),
            stop: key("stop", &control.stop),
            emergency_stop: key("emergency-stop", &control.emergency_stop),
        }
    }

    pub(crate) fn reset(&mut self) {
        [&mut self.start, &mut self.stop, &mut self.emergency_stop]
            .into_iter()
            .flatten()
            .for_each(ControlKey::reset);
    }
}

pub(crate) fn settings(config: &MachineConfig, compiler: &mut Compiler<'_>) -> ControlSettings {
    compiler.enter("control", None);
    if let Some(Err(wrong)) = config.control.clock.as_deref().map(clock::check) {
        compiler.error("clock", wrong);
    }
    if !(-24 * 60..=24 * 60).contains(&config.control.utc_offset_min) {
        compiler.error("utc-offset-min", "must be -1440 to 1440");
    }
    for (index, function) in config.m_function.iter().enumerate() {
        compiler.enter("m-function", Some(index));
        if function.number > 99 {
            compiler.error("number", "M functions go from 0 to 99");
        }
        match m_group(function.number) {
            Some(own) if own != function.group => {
                compiler.error("group", format!("M{:02} belongs to group {own}", function.number));
            }
            _ if !(1..=14).contains(&function.group) => compiler.error("group", "must be 1 to 14"),
            _ => {}
        }
        if config.m_function[..index].iter().any(|other| other.number == function.number) {
            compiler.error("number", "has a group already");
        }
    }
    ControlSettings {
        m_groups: config.m_function.iter().map(|function| (function.number, function.group)).collect(),
        conditional_stop: config.control.conditional_stop,
    }
}
