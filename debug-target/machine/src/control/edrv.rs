//! The control's side of EtherCAT drives: requests of the program become control words (manual 13.18.2).

use technol_image::op::{Addr, BitRef};
use technol_image::system::devices as at;

use super::state_machine::{State, StateMachine};

/// Values of bEdrvState.
const DONE: u8 = 0;
const INIT: u8 = 1;
const ON: u8 = 2;
const ENABLED: u8 = 3;

/// Bits of the status word: the error, and the state.
const ERROR: u16 = 8;
const STATE: u16 = 0x6F;
/// Bits of the control word: QSTOP, VOLT and ON; ENABLE; reset of the error.
const SWITCH_ON: u16 = 7;
const ENABLE: u16 = 8;
const RESET: u16 = 0x80;

/// Requests: the bit, what it sets and clears in the control word, the state that ends it, and bEdrvState then.
const REQUESTS: [(BitRef, u16, u16, State, u8); 5] = [
    (at::EDRV_INIT, 0, u16::MAX, State::SwitchOnDisabled, INIT),
    (at::EDRV_ON, SWITCH_ON, 0, State::SwitchedOn, ON),
    (at::EDRV_ENABLE, ENABLE, 0, State::Enabled, ENABLED),
    (at::EDRV_DISABLE, 0, ENABLE, State::SwitchedOn, ON),
    (at::EDRV_DONE, 0, u16::MAX, State::SwitchOnDisabled, DONE),
];

/// A servo loop.
#[derive(Clone, Debug, Default)]
struct Loop {
    /// It was asked for something since power-on.
    used: bool,
    /// The bits that the program asked for.
    wanted: u16,
    /// The drive in flEdrvSimul.
    simulated: StateMachine,
}

/// All servo loops.
#[derive(Clone, Debug, Default)]
pub(super) struct Edrv {
    loops: [Loop; at::DRIVES as usize],
    /// Any of them was asked for something since power-on.
    used: bool,
}

impl Edrv {
    pub(super) fn start(&mut self, cold: bool) {
        if cold {
            *self = Edrv::default();
        }
    }

    /// A millisecond.
    pub(super) fn tick(&mut self, memory: &mut [u8]) {
        let asked = REQUESTS.iter().fold(all(memory, at::EDRV_ERASE), |asked, it| asked | all(memory, it.0));
        self.used |= asked != 0;
        if !self.used {
            return;
        }
        for n in 0..at::DRIVES {
            let servo = &mut self.loops[usize::from(n)];
            servo.used |= asked >> n & 1 != 0;
            if servo.used {
                servo.tick(n, memory);
            }
        }
    }
}

impl Loop {
    fn tick(&mut self, n: u8, memory: &mut [u8]) {
        if get(memory, at::EDRV_SIMULATED, n) {
            self.simulated.step(word(memory, at::EDRV_CONTROL, n));
            set_word(memory, at::EDRV_STATUS, n, self.simulated.status());
            copy(memory, at::EDRV_TARGET, at::EDRV_POSITION, n);
        }
        let status = word(memory, at::EDRV_STATUS, n);
        let error = status & ERROR != 0;
        let control = if error { self.in_error(n, memory) } else { self.work(n, status, memory) };
        set_word(memory, at::EDRV_CONTROL, n, control);
        copy(memory, at::SERVO_POSITION, at::EDRV_TARGET, n);
        set(memory, at::EDRV_ERROR, n, error);
        set(memory, at::EDRV_HOLD, n, status & STATE != State::Enabled as u16);
    }

    /// The control word of a drive in error: it is switched off, and only the program erases the error.
    fn in_error(&mut self, n: u8, memory: &mut [u8]) -> u16 {
        self.wanted = 0;
        // The drive looks for the edge of the bit.
        let erase = get(memory, at::EDRV_ERASE, n) && word(memory, at::EDRV_CONTROL, n) & RESET == 0;
        if erase { RESET } else { 0 }
    }

    /// The control word that the requests of the program make. Of several, the first in the table is served.
    fn work(&mut self, n: u8, status: u16, memory: &mut [u8]) -> u16 {
        set(memory, at::EDRV_ERASE, n, false);
        if let Some((request, sets, clears, goal, state)) =
            REQUESTS.into_iter().find(|(request, ..)| get(memory, *request, n))
        {
            self.wanted = self.wanted & !clears | sets;
            if status & STATE == goal as u16 {
                set(memory, request, n, false);
                set_byte(memory, at::EDRV_STATE, n, state);
            }
        }
        if self.wanted & SWITCH_ON != SWITCH_ON {
            return self.wanted;
        }
        let goal = if self.wanted & ENABLE != 0 { State::Enabled } else { State::SwitchedOn };
        StateMachine::word_towards(status, goal)
    }
}

/// The 16 bits of a family.
fn all(memory: &[u8], first: BitRef) -> u16 {
    word(memory, first.addr, 0)
}

fn get(memory: &[u8], first: BitRef, n: u8) -> bool {
    all(memory, first) >> n & 1 != 0
}

fn set(memory: &mut [u8], first: BitRef, n: u8, on: bool) {
    let bits = all(memory, first) & !(1 << n) | u16::from(on) << n;
    set_word(memory, first.addr, 0, bits);
}

fn word(memory: &[u8], first: Addr, n: u8) -> u16 {
    let at = first as usize + 2 * usize::from(n);
    memory.get(at..at + 2).and_then(|bytes| bytes.try_into().ok()).map_or(0, u16::from_le_bytes)
}

fn set_word(memory: &mut [u8], first: Addr, n: u8, value: u16) {
    let at = first as usize + 2 * usize::from(n);
    if let Some(bytes) = memory.get_mut(at..at + 2) {
        bytes.copy_from_slice(&value.to_le_bytes());
    }
}

fn set_byte(memory: &mut [u8], first: Addr, n: u8, value: u8) {
    if let Some(byte) = memory.get_mut(first as usize + usize::from(n)) {
        *byte = value;
    }
}

/// A double word from one array to another.
fn copy(memory: &mut [u8], from: Addr, to: Addr, n: u8) {
    let (from, to) = (from as usize + 4 * usize::from(n), to as usize + 4 * usize::from(n));
    if from.max(to) + 4 <= memory.len() {
        memory.copy_within(from..from + 4, to);
    }
}
