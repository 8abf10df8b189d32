//! Units that the control itself serves on the CAN bus: INOUT08, KLA50 and hand panels (manual 9.5).

use alloc::collections::BTreeMap;

use technol_image::op::Addr;
use technol_image::op::Width::{self, Byte, DWord, Word};
use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::number;

/// Group of the INOUT08 units.
const INOUT08: u16 = 1;
/// IO_DIS_ERPIS in CONTROL.
const NO_REPORT: u32 = 2;
/// IO_DIS_TMOUT in CONTROL.
const NO_TIMEOUT: u32 = 4;
/// ERR_IO8_ERROR and ERR_IO8_SHORT in ERROR.
const ANY_ERROR: u32 = 1;
const SHORT: u32 = 2;
/// CAN_IO_ERROR_CODE: BYTE, with number of the unit, time-out and its number behind it; then CAN_MAT_ and CAN_TOC_.
const ERRORS: Addr = 0x0C8D;
/// Groups of units.
const GROUPS: u16 = 3;

/// Who fills a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Control,
    Program,
}
use By::{Control, Program};

/// Members of the structure INOUTS.
const MEMBERS: [(&str, Width, By); 45] = [
    ("SIZE", Word, Control),
    ("PRESENT", Byte, Control),
    ("MODE", Byte, Program),
    ("VENDORID", DWord, Control),
    ("DEVICENAME", DWord, Control),
    ("HWVERSION", DWord, Control),
    ("SWVERSION", DWord, Control),
    ("IN0", Byte, Control),
    ("IN1", Byte, Control),
    ("IN2", Byte, Control),
    ("IN3", Byte, Control),
    ("OUT0", Byte, Program),
    ("OUT1", Byte, Program),
    ("OUT2", Byte, Program),
    ("ANL0", Byte, Control),
    ("ANL1", Byte, Control),
    ("ANL2", Byte, Control),
    ("ANL3", Byte, Control),
    ("ANL4", Byte, Control),
    ("ANL5", Byte, Control),
    ("ANL6", Byte, Control),
    ("ANL7", Byte, Control),
    ("ERROR", Byte, Control),
    ("ERR_CODE", Byte, Control),
    ("ERR_STAT", Byte, Control),
    ("CONTROL", Byte, Program),
    ("COUNT", Word, Control),
    ("SEND_REQ", Byte, Program),
    ("RESP_COUNT", Byte, Control),
    ("SHORT_SEND_REQ", Byte, Program),
    ("SHORT_OUT0", Byte, Program),
    ("SHORT_OUT1", Byte, Program),
    ("SHORT_OUT2", Byte, Program),
    ("RPDO_COUNT", Word, Control),
    ("TPDO_COUNT", Word, Control),
    ("PXIN", Word, Control),
    ("PXOUT", Word, Control),
    ("IRC0", Word, Control),
    ("IRC1", Word, Control),
    ("MODE_ACT", Byte, Control),
    ("MODE_FAZE", Byte, Control),
    ("TL0", Byte, Control),
    ("TL1", Byte, Control),
    ("TL2", Byte, Control),
    ("TL3", Byte, Control),
];

fn member(name: &str) -> Option<usize> {
    MEMBERS.iter().position(|(known, ..)| known.eq_ignore_ascii_case(name))
}

fn mask(width: Width) -> u32 {
    u32::MAX >> (32 - width.bits().min(32))
}

/// A unit.
#[derive(Clone, Debug)]
pub struct CanUnit {
    /// What the program sees.
    seen: [u32; MEMBERS.len()],
    /// What the unit says.
    said: [u32; MEMBERS.len()],
    /// The cable is cut.
    lost: bool,
    /// Its error register at the last look.
    error: u32,
    /// What the control has put into ERR_CODE; something else there is the unit's own.
    last: u32,
}

impl Default for CanUnit {
    fn default() -> CanUnit {
        let mut unit =
            CanUnit { seen: [0; MEMBERS.len()], said: [0; MEMBERS.len()], lost: false, error: 0, last: 0 };
        unit.set("PRESENT", 1);
        unit.seen = unit.said;
        unit
    }
}

impl CanUnit {
    /// Sets a member, cut to its width. Members that the control fills reach the program in the next cycle. `false`: there is
    /// no such member.
    pub fn set(&mut self, name: &str, value: u32) -> bool {
        let Some(n) = member(name) else { return false };
        let (_, width, by) = MEMBERS[n];
        let place = if by == Control { &mut self.said[n] } else { &mut self.seen[n] };
        *place = value & mask(width);
        true
    }

    /// A member as the program sees it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<u32> {
        member(name).map(|n| self.seen[n])
    }

    /// A cycle begins: the unit follows its mode, and what it says is the truth again.
    fn cycle(&mut self) {
        if self.lost {
            // What it said last stays.
            if let Some(n) = member("PRESENT") {
                self.seen[n] = 0;
            }
            return;
        }
        let mode = self.get("MODE").unwrap_or(0);
        self.set("MODE_ACT", mode);
        for (n, (.., by)) in MEMBERS.iter().enumerate() {
            if *by == Control {
                self.seen[n] = self.said[n];
            }
        }
        let shorted =
            ["SHORT_OUT0", "SHORT_OUT1", "SHORT_OUT2"].into_iter().any(|name| self.get(name) > Some(0));
        let told = self.get("ERROR").unwrap_or(0) | if shorted { SHORT } else { 0 };
        let error = told | if told != 0 { ANY_ERROR } else { 0 };
        if let Some(n) = member("ERROR") {
            self.seen[n] = error;
        }
        // The last one is kept from when it arises.
        if error != 0
            && error != self.error
            && let Some(n) = member("ERR_CODE").filter(|n| self.said[*n] == self.last)
        {
            (self.said[n], self.last) = (error, error);
        }
        self.error = error;
    }

    /// Nobody answers, and the program wants to know.
    fn is_late(&self) -> bool {
        self.lost && self.get("CONTROL").is_some_and(|control| control & NO_TIMEOUT == 0)
    }
}

/// The units by channel, group and number.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Units {
    all: BTreeMap<(u16, u16, u16), CanUnit>,
}

impl Units {
    pub(in super::super) fn unit(&mut self, can: u8, group: u8, board: u8) -> &mut CanUnit {
        self.all.entry((can.into(), group.into(), board.into())).or_default()
    }

    /// A cycle of 20 ms begins.
    pub(in super::super) fn cycle(&mut self, memory: &mut [u8]) {
        self.all.values_mut().for_each(CanUnit::cycle);
        if !self.all.is_empty() {
            (1..=GROUPS).for_each(|group| self.tell_errors(group, memory));
        }
    }

    /// The first unit of a group in error and the first that is late (manual 9.3).
    fn tell_errors(&self, group: u16, memory: &mut [u8]) {
        let own = || self.all.iter().filter(|((_, its, _), _)| *its == group);
        let error = own().find_map(|((.., board), unit)| {
            unit.get("ERROR")
                .filter(|error| *error != 0 && !unit.lost)
                .map(|error| (error as u8, *board as u8))
        });
        let late = own().find(|(_, unit)| unit.is_late()).map(|((.., board), _)| (1, *board as u8));
        let ((error, in_error), (timeout, silent)) = (error.unwrap_or_default(), late.unwrap_or_default());
        let at = (ERRORS + 4 * Addr::from(group - 1)) as usize;
        if let Some(bytes) = memory.get_mut(at..at + 4) {
            bytes.copy_from_slice(&[error, in_error, timeout, silent]);
        }
    }

    /// The cable of a channel is cut, or is there.
    pub(in super::super) fn set_cut(&mut self, cut: impl Fn(u8) -> bool) {
        for ((can, ..), unit) in &mut self.all {
            unit.lost = cut(*can as u8);
        }
    }

    /// Outputs with a short circuit, as bytes of P0OUT …: each INOUT08 tells in SHORT_OUT0 … those that are on. Those of a unit
    /// with IO_DIS_ERPIS are taken out: the program is not told of them.
    pub(in super::super) fn tell_shorted(&mut self, shorted: &mut [u8], outputs: &[u8]) {
        for ((_, group, board), unit) in &mut self.all {
            let first = 3 * usize::from(board.wrapping_sub(1));
            let (INOUT08, Some(ports)) = (*group, shorted.get_mut(first..first + 3)) else { continue };
            let driven = outputs.get(first..first + 3).unwrap_or_default();
            for ((name, port), driven) in
                ["SHORT_OUT0", "SHORT_OUT1", "SHORT_OUT2"].into_iter().zip(&*ports).zip(driven)
            {
                unit.set(name, u32::from(port & driven));
            }
            if unit.get("CONTROL").is_some_and(|control| control & NO_REPORT != 0) {
                ports.fill(0);
            }
        }
    }

    /// CAN_SYSIO_READ and CAN_SYSIO_WRITE.
    pub(in super::super) fn execute(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let key = (number(call, 0)?, number(call, 1)?, number(call, 2)?);
        let found = self.all.get_mut(&key).zip(call.keyword(3).and_then(member));
        call.set_rlo(found.is_none());
        let Some((unit, n)) = found else { return Ok(()) };
        if call.service() == Service::CanSysioRead {
            call.set_dr(i64::from(unit.seen[n]));
        } else {
            unit.seen[n] = call.dr() as u32 & mask(MEMBERS[n].1);
        }
        Ok(())
    }
}
