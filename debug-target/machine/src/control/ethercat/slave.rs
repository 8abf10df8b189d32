//! Slaves of the EtherCAT master: their states, objects and registers.

use super::layout::object;
use super::process::Drive;
use crate::control::objects::{Dictionary, Objects, Refused};

/// Element of a register that is its value.
pub(super) const VALUE: u8 = 0x40;

/// Codes with which a drive refuses an access to a register.
const NO_REGISTER: u32 = 0x1001;
const NO_ELEMENT: u32 = 0x1009;
const TOO_SHORT: u32 = 0x7002;
const TOO_LONG: u32 = 0x7003;
const READ_ONLY: u32 = 0x7004;

/// A state of the master or of a slave, with its number in answers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum EcatState {
    /// No mailbox, no cyclic data.
    Init = 1,
    /// The mailbox works.
    PreOperational = 2,
    /// For new firmware.
    Bootstrap = 3,
    /// Inputs are exchanged too.
    SafeOperational = 4,
    /// Everything is exchanged.
    #[default]
    Operational = 8,
}

impl EcatState {
    /// The state of a number.
    pub(super) fn of(number: i64) -> Option<EcatState> {
        Some(match number {
            1 => EcatState::Init,
            2 => EcatState::PreOperational,
            3 => EcatState::Bootstrap,
            4 => EcatState::SafeOperational,
            8 => EcatState::Operational,
            _ => return None,
        })
    }

    /// The next state on the way to `goal`: up one by one, down at once, to and from BOOTSTRAP by INIT only.
    pub(super) fn toward(self, goal: EcatState) -> EcatState {
        use EcatState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};
        match (self, goal) {
            _ if self == goal => goal,
            (Init, Bootstrap) => Bootstrap,
            (Bootstrap, _) | (_, Bootstrap) => Init,
            _ if goal < self => goal,
            (Init, _) => PreOperational,
            (PreOperational, _) => SafeOperational,
            (SafeOperational | Operational, _) => Operational,
        }
    }

    /// Objects and registers can be reached.
    pub(super) fn has_mailbox(self) -> bool {
        !matches!(self, EcatState::Init | EcatState::Bootstrap)
    }
}

/// A slave.
#[derive(Clone, Debug, Default)]
pub struct EcatSlave {
    pub(super) state: EcatState,
    pub(super) goal: EcatState,
    pub(super) silent: bool,
    /// The cable to it is cut, or it has no power.
    lost: bool,
    pub(super) drive: Option<Drive>,
    pub(super) objects: Dictionary,
    /// By drive, number of the register and element.
    registers: Objects<(u8, u16, u8)>,
}

impl EcatSlave {
    /// Its state; OPERATIONAL at first.
    #[must_use]
    pub fn state(&self) -> EcatState {
        self.state
    }

    /// It does not answer (true).
    pub fn set_silent(&mut self, silent: bool) {
        self.silent = silent;
    }

    /// It answers, and the cable is there.
    pub(super) fn is_reached(&self) -> bool {
        !self.silent && !self.lost
    }

    /// It is reached, and in this state.
    pub(super) fn is_in(&self, state: EcatState) -> bool {
        self.state == state && !self.lost
    }

    /// Without connection it falls back to SAFE-OPERATIONAL; the master leads it up again.
    pub(super) fn set_lost(&mut self, lost: bool) {
        self.lost = lost;
        if lost && self.state == EcatState::Operational {
            self.state = EcatState::SafeOperational;
        }
    }

    /// The object of a drive has its present value.
    pub(super) fn refresh(&mut self, index: u16, subindex: u8) {
        let own = self.drive.as_ref().and_then(|drive| drive.give(index));
        if let (Some(own), 0) = (own, subindex) {
            self.objects.update(&(index, 0), &own);
        }
    }

    /// It is a drive, which has its words as objects too.
    pub(super) fn make_drive(&mut self) {
        self.drive = Some(Drive::default());
        for (index, len) in [(object::STATUS, 2), (object::ERROR, 2), (object::POSITION, 4)] {
            self.objects.set((index, 0), &[0; 4][..len], true);
        }
    }

    /// Adds a CANopen object as it is at power-on.
    pub fn set_object(&mut self, index: u16, subindex: u8, value: &[u8], read_only: bool) {
        self.objects.set((index, subindex), value, read_only);
    }

    /// The value of a CANopen object.
    #[must_use]
    pub fn object(&self, index: u16, subindex: u8) -> Option<&[u8]> {
        self.objects.get(&(index, subindex))
    }

    /// Adds a register of a drive as it is at power-on.
    pub fn set_register(&mut self, drive: u8, idn: u16, value: &[u8], read_only: bool) {
        self.registers.set((drive, idn, VALUE), value, read_only);
    }

    /// Adds another element of a register, by its ElementFlag (02h is the name, 08h the unit …).
    pub fn set_element(&mut self, drive: u8, idn: u16, element: u8, value: &[u8]) {
        self.registers.set((drive, idn, element), value, element != VALUE);
    }

    /// The value of a register.
    #[must_use]
    pub fn register(&self, drive: u8, idn: u16) -> Option<&[u8]> {
        self.registers.get(&(drive, idn, VALUE))
    }

    pub(super) fn read_register(&self, drive: u8, idn: u16, element: u8) -> Result<&[u8], u32> {
        self.registers.get(&(drive, idn, element)).ok_or_else(|| self.missing(drive, idn))
    }

    pub(super) fn write_register(
        &mut self,
        drive: u8,
        idn: u16,
        element: u8,
        value: &[u8],
    ) -> Result<(), u32> {
        self.registers.write(&(drive, idn, element), value).map_err(|refused| match refused {
            Refused::Missing => self.missing(drive, idn),
            Refused::ReadOnly => READ_ONLY,
            Refused::TooShort => TOO_SHORT,
            Refused::TooLong => TOO_LONG,
        })
    }

    fn missing(&self, drive: u8, idn: u16) -> u32 {
        if self.registers.has((drive, idn, 0)..=(drive, idn, u8::MAX)) { NO_ELEMENT } else { NO_REGISTER }
    }

    /// Power-on: everything as it was configured.
    pub(super) fn power_on(&mut self, state: EcatState) {
        (self.state, self.goal) = (state, state);
        if let Some(drive) = &mut self.drive {
            drive.machine.power_on();
        }
        self.objects.restore();
        self.registers.restore();
    }
}
