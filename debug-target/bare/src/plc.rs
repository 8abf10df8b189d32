//! What lies behind the handle of C.

use alloc::collections::VecDeque;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use technol_image::container;
use technol_runtime::{InputImage, OutputImage, Runtime, RuntimeEvent, TickOutcome};

use crate::control::HostControl;

/// Events that wait to be fetched; of more, the oldest go.
const MOST_EVENTS: usize = 64;

/// A loaded program.
pub(crate) struct Plc {
    pub(crate) runtime: Runtime,
    /// What the host carries out.
    pub(crate) control: HostControl,
    /// Empty between two ticks.
    occurred: Vec<RuntimeEvent>,
    waiting: VecDeque<RuntimeEvent>,
    lost: u32,
}

impl Plc {
    /// Loads the bytes of an image file, or those of a program alone (as they are downloaded).
    pub(crate) fn load(bytes: &[u8]) -> Result<Plc, String> {
        let program = if bytes.starts_with(&container::MAGIC) {
            container::decode(bytes).map(|image| image.program)
        } else {
            container::decode_program(bytes)
        };
        let program = program.map_err(|error| error.to_string())?;
        let runtime = Runtime::new(program).map_err(|error| error.to_string())?;
        Ok(Plc {
            runtime,
            control: HostControl::NONE,
            occurred: Vec::with_capacity(MOST_EVENTS),
            waiting: VecDeque::with_capacity(MOST_EVENTS),
            lost: 0,
        })
    }

    /// One millisecond.
    pub(crate) fn tick(&mut self, inputs: &InputImage) -> (TickOutcome, &OutputImage) {
        let outcome = self.runtime.tick_with(inputs, &mut self.control, &mut self.occurred);
        for event in self.occurred.drain(..) {
            if self.waiting.len() == MOST_EVENTS {
                self.waiting.pop_front();
                self.lost = self.lost.saturating_add(1);
            }
            self.waiting.push_back(event);
        }
        (outcome, self.runtime.outputs())
    }

    /// The event that has waited longest.
    pub(crate) fn next_event(&mut self) -> Option<RuntimeEvent> {
        self.waiting.pop_front()
    }

    /// Events that were lost since the last call because nobody fetched them.
    pub(crate) fn lost_events(&mut self) -> u32 {
        core::mem::take(&mut self.lost)
    }
}
