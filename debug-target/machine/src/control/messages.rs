//! Messages that the control reports by itself: EDEF binds them to the edges of a bit (manual 14.3).

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use technol_image::op::{Addr, Width};
use technol_image::service::Arg;
use technol_runtime::{Call, ControlMessage, FaultKind};

/// Messages of the control itself that wait to be told; more are lost.
const OWN: usize = 64;

/// Messages of the control itself about its CAN buses (manual 13.14.5).
pub(super) mod message {
    /// The bus is interrupted; the channel.
    pub(in crate::control) const INTERRUPTED: u32 = 4204;
    /// A drive does not answer; its axis.
    pub(in crate::control) const NO_ANSWER: u32 = 4208;
    /// A drive refuses a command; its axis.
    pub(in crate::control) const BAD_ANSWER: u32 = 4209;
    /// A drive reports an error; its axis, its error register, the code.
    pub(in crate::control) const EMERGENCY: u32 = 4217;

    /// The text of such a message, where no file has one; empty for others.
    pub(in crate::control) fn text(number: u32) -> &'static str {
        match number {
            INTERRUPTED => "CAN channel %d is interrupted",
            NO_ANSWER => "CAN drive %d does not answer",
            BAD_ANSWER => "CAN drive %d refuses a command",
            EMERGENCY => "CAN drive %d reports an error, register %d, code %X",
            _ => "",
        }
    }
}

/// Bindings of a program; one more is not looked at. No machine has so many messages.
const MAX_BINDINGS: usize = 10_000;

/// An edge of a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    None,
    Rising,
    Falling,
}

/// What EDEF announced.
#[derive(Clone, Debug)]
struct Binding {
    call: u16,
    addr: Addr,
    bit: u8,
    number: u32,
    sub_id: Option<i64>,
    begins: Edge,
    ends: Edge,
    parameters: [Option<Value>; 3],
    /// State of the bit at the last look; `None` before the first.
    before: Option<bool>,
}

/// A parameter: a constant, or a cell that is read when the message comes.
#[derive(Clone, Copy, Debug)]
enum Value {
    Constant(i64),
    Cell(Addr, Width),
}

/// The bindings, and the messages that wait to be told.
#[derive(Clone, Debug, Default)]
pub(super) struct Messages {
    bindings: Vec<Binding>,
    waiting: VecDeque<ControlMessage>,
}

/// A message that no line of the program reports.
const NO_CALL: u16 = u16::MAX;

impl Messages {
    /// EDEF.
    pub(super) fn watch(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let Arg::Bit { bit, .. } = *call.arg(1) else { return Ok(()) };
        // The cell says in which byte the bit lies, the bit where it lies there.
        let cell = if call.is_given(0) { call.area(0)? } else { call.area(1)? };
        let Some((addr, _)) = cell else { return Ok(()) };
        let mode = call.integer(4)?.unwrap_or(0);
        let mut parameters = [None; 3];
        for (n, parameter) in parameters.iter_mut().enumerate() {
            *parameter = match *call.arg(5 + n) {
                Arg::Cell { width, .. } => call.area(5 + n)?.map(|(addr, _)| Value::Cell(addr, width)),
                _ => call.integer(5 + n)?.map(Value::Constant),
            };
        }
        let binding = Binding {
            call: call.index(),
            addr,
            bit: bit.bit,
            number: call.integer(2)?.map_or(0, |number| u32::from(number as u16)),
            sub_id: call.integer(3)?,
            begins: edge(mode),
            ends: edge(mode >> 2),
            parameters,
            before: None,
        };
        // Executed again, the same line binds anew.
        self.bindings.retain(|known| known.call != binding.call);
        if self.bindings.len() < MAX_BINDINGS {
            self.bindings.push(binding);
        }
        // Both edges of a bit may begin and end its message in one look.
        let room = 2 * self.bindings.len() + OWN;
        self.waiting.reserve(room.saturating_sub(self.waiting.len()));
        Ok(())
    }

    /// The control reports something by itself.
    pub(super) fn of_control(&mut self, number: u32, parameters: [Option<i64>; 3]) {
        if self.waiting.len() < OWN {
            let (call, sub_id, set) = (NO_CALL, None, true);
            self.waiting.push_back(ControlMessage { call, number, sub_id, set, parameters });
        }
    }

    /// A start of the PLC: nothing is bound.
    pub(super) fn start(&mut self) {
        self.bindings.clear();
        self.waiting.clear();
    }

    /// Looks at the bits, once a cycle after MODULE_MAIN.
    pub(super) fn look(&mut self, memory: &[u8]) {
        for binding in &mut self.bindings {
            let Some(byte) = memory.get(binding.addr as usize) else { continue };
            let now = byte >> binding.bit & 1 != 0;
            // A bit that is 1 when the program starts has not risen.
            let Some(before) = binding.before.replace(now) else { continue };
            let edge = match (before, now) {
                (false, true) => Edge::Rising,
                (true, false) => Edge::Falling,
                _ => continue,
            };
            for (wanted, set) in [(binding.begins, true), (binding.ends, false)] {
                if wanted == edge {
                    self.waiting.push_back(binding.message(set, memory));
                }
            }
        }
    }

    /// The next message that waits.
    pub(super) fn next(&mut self) -> Option<ControlMessage> {
        self.waiting.pop_front()
    }
}

impl Binding {
    fn message(&self, set: bool, memory: &[u8]) -> ControlMessage {
        let parameters = self.parameters.map(|value| {
            value.map(|value| match value {
                Value::Constant(value) => value,
                Value::Cell(addr, width) => read(memory, addr, width),
            })
        });
        let Binding { call, number, sub_id, .. } = *self;
        ControlMessage { call, number, sub_id, set, parameters }
    }
}

/// 00b nothing, 01b rising, 10b falling; 11b is refused by the compiler.
fn edge(pair: i64) -> Edge {
    match pair & 3 {
        1 => Edge::Rising,
        2 => Edge::Falling,
        _ => Edge::None,
    }
}

/// A cell, sign-extended; 0 outside memory.
fn read(memory: &[u8], addr: Addr, width: Width) -> i64 {
    let len = width.bytes() as usize;
    let Some(bytes) = memory.get(addr as usize..addr as usize + len) else { return 0 };
    let mut all = [0; 8];
    all[..len].copy_from_slice(bytes);
    let unused = 64 - width.bits();
    i64::from_le_bytes(all) << unused >> unused
}
