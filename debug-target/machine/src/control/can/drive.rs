//! CAN drives of axes and the packets the program exchanges with them (CAN_AX_SEND, manual 13.14).

use alloc::collections::BTreeMap;

use technol_image::op::Addr;
use technol_image::system::devices;
use technol_runtime::{Call, FaultKind};

use super::super::messages::{Messages, message};
use super::super::objects::{Dictionary, abort};
use super::super::state_machine::{State, StateMachine};
use super::{CanPacket, NODE, number};

/// Milliseconds until a drive has answered.
const ANSWER_MILLIS: u32 = 10;
/// CAN_AX_BUSY until then.
const BUSY: u8 = 0xFF;
/// Objects of requests to a drive and of its answers.
const REQUEST: u16 = 0x600;
const ANSWER: u16 = 0x580;
/// First byte of a refusal.
const ABORT: u8 = 0x80;
/// Bit of the error register in an emergency message: any error.
const ANY_ERROR: i64 = 1;
/// Bits of the command word: CAN_AX_EN and CAN_AX_BRK.
const ENABLE: u8 = 1;
const BRAKE: u8 = 2;

/// A drive with its objects.
#[derive(Clone, Debug, Default)]
pub struct CanDrive {
    node: u8,
    silent: bool,
    /// The cable to it is cut, or it has no power.
    lost: bool,
    /// Why it is in error.
    cause: Option<u16>,
    objects: Dictionary,
    machine: StateMachine,
}

impl CanDrive {
    /// Its NODE-ID, 1 to 127; at first the number of the axis.
    pub fn set_node(&mut self, node: u8) {
        self.node = node;
    }

    /// It does not answer (true).
    pub fn set_silent(&mut self, silent: bool) {
        self.silent = silent;
    }

    /// Adds an object as it is at power-on.
    pub fn set_object(&mut self, index: u16, subindex: u8, value: &[u8], read_only: bool) {
        self.objects.set((index, subindex), value, read_only);
    }

    /// The value of an object.
    #[must_use]
    pub fn object(&self, index: u16, subindex: u8) -> Option<&[u8]> {
        self.objects.get(&(index, subindex))
    }

    /// A millisecond: the command of the program in, the status word out. Braking cancels the release; a drive in error is
    /// reset while it is not released.
    fn follow(&mut self, command: u8) -> u16 {
        if self.lost {
            self.machine.power_on();
            return 0;
        }
        let goal = match (command & BRAKE != 0, command & ENABLE != 0) {
            (true, _) => State::SwitchOnDisabled,
            (false, true) => State::Enabled,
            (false, false) => State::SwitchedOn,
        };
        if command & ENABLE == 0 {
            self.machine.reset();
        }
        self.machine.step(StateMachine::word_towards(self.machine.status(), goal));
        let quick_stop_not_active = 0x20;
        // Bit 4 tells of CAN drives that the voltage is not there.
        self.machine.state() as u16 | quick_stop_not_active
    }

    /// Its answer to a request of up to four bytes of data.
    fn answer(&mut self, request: [u8; 8]) -> [u8; 8] {
        let [command, low, high, subindex, ..] = request;
        let index = u16::from_le_bytes([low, high]);
        let result = match command {
            0x40 => self.upload(index, subindex),
            _ if command >> 4 == 2 && command & 2 != 0 => self.download(index, subindex, request),
            _ => Err(abort::COMMAND),
        };
        let (first, data) = result.unwrap_or_else(|code| (ABORT, code.to_le_bytes()));
        let [a, b, c, d] = data;
        [first, low, high, subindex, a, b, c, d]
    }

    fn upload(&self, index: u16, subindex: u8) -> Result<(u8, [u8; 4]), u32> {
        let value = self.objects.upload(index, subindex)?;
        let mut data = [0; 4];
        // A longer object would take several packets.
        data.get_mut(..value.len()).ok_or(abort::ACCESS)?.copy_from_slice(value);
        Ok((0x43 | (4 - value.len() as u8) << 2, data))
    }

    fn download(&mut self, index: u16, subindex: u8, request: [u8; 8]) -> Result<(u8, [u8; 4]), u32> {
        let len = if request[0] & 1 != 0 {
            4 - usize::from(request[0] >> 2 & 3)
        } else {
            // The request leaves the size to the object.
            self.objects.upload(index, subindex)?.len()
        };
        let data = request.get(4..4 + len).ok_or(abort::ACCESS)?;
        self.objects.download(index, subindex, data)?;
        Ok((0x60, [0; 4]))
    }
}

/// An answer on its way.
#[derive(Clone, Copy, Debug)]
struct Pending {
    axis: u8,
    left: u32,
    /// `None`: nobody will answer.
    answer: Option<CanPacket>,
    packet: Addr,
    busy: Addr,
}

/// The drives by axis.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Drives {
    all: BTreeMap<u8, CanDrive>,
    pending: Option<Pending>,
}

impl Drives {
    pub(in super::super) fn drive(&mut self, axis: u8) -> &mut CanDrive {
        self.all.entry(axis).or_insert_with(|| CanDrive { node: axis, ..CanDrive::default() })
    }

    /// CAN_AX_SEND: behind the axis the operands are the packets of request and answer and the busy byte.
    pub(in super::super) fn send(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let axis = number(call, 0)? as u8;
        let (Some((request, _)), Some((packet, _)), Some((busy, _))) =
            (call.area(1)?, call.area(2)?, call.area(3)?)
        else {
            return Ok(());
        };
        let drive = self.all.get_mut(&axis);
        let node = u16::from(drive.as_ref().map_or(axis, |drive| drive.node)) & NODE;
        let mut data = [0; 8];
        data.copy_from_slice(call.bytes(request.saturating_add(4), 8)?);
        call.write(request, &CanPacket::new(REQUEST | node, &data).to_bytes())?;
        call.write(busy, &[BUSY])?;
        let answer = drive
            .filter(|drive| !drive.silent && !drive.lost)
            .map(|drive| CanPacket::new(ANSWER | node, &drive.answer(data)));
        // A packet that still waits is replaced.
        self.pending = Some(Pending { axis, left: ANSWER_MILLIS, answer, packet, busy });
        Ok(())
    }

    /// One millisecond.
    pub(in super::super) fn tick(&mut self) {
        if let Some(pending) = &mut self.pending {
            pending.left = pending.left.saturating_sub(1);
        }
    }

    /// A cycle begins: an answer that has come reaches the program.
    pub(in super::super) fn inputs(&mut self, memory: &mut [u8], messages: &mut Messages) {
        let Some(pending) = self.pending.take_if(|pending| pending.left == 0) else { return };
        let axis = i64::from(pending.axis);
        let Some(answer) = pending.answer else {
            messages.of_control(message::NO_ANSWER, [Some(axis), None, None]);
            return;
        };
        let bytes = answer.to_bytes();
        if bytes[4] == ABORT {
            messages.of_control(message::BAD_ANSWER, [Some(axis), None, None]);
        }
        let start = pending.packet as usize;
        if let Some(target) = memory.get_mut(start..start.saturating_add(bytes.len())) {
            target.copy_from_slice(&bytes);
        }
        if let Some(busy) = memory.get_mut(pending.busy as usize) {
            *busy = 0;
        }
    }

    /// A millisecond: commands and status words of all drives.
    pub(in super::super) fn follow(&mut self, memory: &mut [u8]) {
        for (axis, drive) in &mut self.all {
            let place = 2 * (u32::from(*axis).wrapping_sub(1) & 15);
            let command = memory.get((devices::CAN_COMMAND + place) as usize).copied().unwrap_or(0);
            let status = drive.follow(command).to_le_bytes();
            let at = (devices::CAN_STATUS + place) as usize;
            if let Some(word) = memory.get_mut(at..at + 2) {
                word.copy_from_slice(&status);
            }
        }
    }

    /// Nobody reaches these drives.
    pub(in super::super) fn set_lost(&mut self, lost: impl Fn(u8) -> bool) {
        for (axis, drive) in &mut self.all {
            drive.lost = lost(*axis);
        }
    }

    /// Why a drive is in error, which it tells at once.
    pub(in super::super) fn set_error(&mut self, error: impl Fn(u8) -> Option<u16>, messages: &mut Messages) {
        for (axis, drive) in &mut self.all {
            let cause = error(*axis);
            if cause != drive.cause
                && let Some(code) = cause
            {
                let parameters = [Some(i64::from(*axis)), Some(ANY_ERROR), Some(i64::from(code))];
                messages.of_control(message::EMERGENCY, parameters);
            }
            drive.cause = cause;
            drive.machine.set_cause(cause);
        }
    }

    pub(in super::super) fn start(&mut self, cold: bool) {
        self.pending = None;
        if cold {
            for drive in self.all.values_mut() {
                drive.objects.restore();
                drive.machine.power_on();
            }
        }
    }
}
