//! Bits of the program for the whole master (manual 26.2.3 and 26.3).

use technol_image::op::BitRef;
use technol_image::system::devices;

use super::{EcatState, EtherCat};

/// Requests and the states they ask for.
const REQUESTS: [(BitRef, EcatState); 5] = [
    (devices::ECAT_BOOTSTRAP_REQ, EcatState::Bootstrap),
    (devices::ECAT_INIT_REQ, EcatState::Init),
    (devices::ECAT_PREOP_REQ, EcatState::PreOperational),
    (devices::ECAT_SAFEOP_REQ, EcatState::SafeOperational),
    (devices::ECAT_OP_REQ, EcatState::Operational),
];

fn get(memory: &[u8], bit: BitRef) -> bool {
    memory.get(bit.addr as usize).is_some_and(|byte| byte >> bit.bit & 1 != 0)
}

fn set(memory: &mut [u8], bit: BitRef, on: bool) {
    if let Some(byte) = memory.get_mut(bit.addr as usize) {
        *byte = *byte & !(1 << bit.bit) | u8::from(on) << bit.bit;
    }
}

impl EtherCat {
    /// The cyclic exchange is started by the program, and the master waits in INIT for that.
    pub(in crate::control) fn set_start_by_program(&mut self, yes: bool) {
        self.start_by_program = yes;
        self.power_on();
    }

    /// A cycle of 20 ms begins: what the program asks for, and what it is told.
    pub(in crate::control) fn requests(&mut self, memory: &mut [u8]) {
        if self.start_by_program && !self.started && get(memory, devices::ECAT_START) {
            self.started = true;
            self.lead(None, EcatState::Operational);
        }
        for (n, (request, state)) in REQUESTS.into_iter().enumerate() {
            if !get(memory, request) {
                self.asked[n] = false;
                continue;
            }
            if !core::mem::replace(&mut self.asked[n], true) {
                self.lead(None, state);
            }
            if self.are_in(None, state) {
                set(memory, request, false);
                self.asked[n] = false;
            }
        }
        set(memory, devices::ECAT_OPERATIONAL, self.are_in(None, EcatState::Operational));
    }
}
