//! Keys of the operator panel.

use alloc::collections::VecDeque;
use alloc::string::String;

use crate::compile::Compiler;
use crate::config;
use crate::motion::PanelKey;
use crate::plant::PlantEvent;
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Key {
    pub(crate) name: String,
    input: Option<InputBit>,
    invert: bool,
    command: Option<i32>,
    panel: Option<PanelKey>,
    pub(crate) pressed: bool,
    /// As the control saw it last.
    seen: bool,
}

impl Key {
    pub(crate) fn compile(config: &config::Key, compiler: &mut Compiler<'_>) -> Key {
        let input = config.input.as_ref().and_then(|name| compiler.driven("input", name));
        if config.input.is_none() && config.command.is_none() && config.panel.is_none() {
            compiler.error("", "needs `input`, `command` or `panel`, else it does nothing");
        }
        if let Some(panel) = config.panel {
            panel.check(compiler);
        }
        let (invert, command, panel) = (config.invert, config.command, config.panel);
        Key { name: config.name.clone(), input, invert, command, panel, pressed: false, seen: false }
    }

    pub(crate) fn step(&self, inputs: &mut InputImage) {
        if let Some(input) = self.input {
            input.set(inputs, self.pressed != self.invert);
        }
    }

    /// Tells the control when it was pressed or released since the last look.
    pub(crate) fn tell(&mut self, events: &mut VecDeque<PlantEvent>) {
        let pressed = self.pressed;
        if core::mem::replace(&mut self.seen, pressed) == pressed {
            return;
        }
        events.extend(self.command.map(|code| PlantEvent::Command { code, pressed }));
        events.extend(self.panel.map(|key| PlantEvent::Panel { key, pressed }));
    }
}
