//! The functions of a part-program block in the block cells of the system region (manual 8.2).

use core::fmt;

use technol_image::op::{Addr, BitRef};
use technol_image::system::{self, m_group};

use crate::decimal::to_bcd;
use crate::memory::Memory;

/// M functions.
const COUNT: usize = 100;
/// Highest group; functions that nobody puts elsewhere belong to it.
const OTHERS: u8 = 14;

/// An M function cannot be put into that group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroupError {
    /// The function.
    pub m: u8,
    /// The group that was asked for.
    pub group: u8,
}

impl fmt::Display for GroupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let GroupError { m, group } = *self;
        match m_group(m) {
            _ if usize::from(m) >= COUNT => write!(f, "there is no M{m}; M functions go from 0 to 99"),
            Some(own) if own != group => write!(f, "M{m:02} belongs to group {own} and cannot be moved"),
            _ => write!(f, "there is no group {group}; M functions have groups 1 to {OTHERS}"),
        }
    }
}

impl core::error::Error for GroupError {}

/// Group of each M function (element MFunctions of the configuration, manual 8.3.5).
#[derive(Clone, Debug)]
pub(crate) struct Groups([u8; COUNT]);

impl Groups {
    /// The fixed groups; all other functions are in group 14.
    pub(crate) fn new() -> Groups {
        Groups(core::array::from_fn(|m| m_group(m as u8).unwrap_or(OTHERS)))
    }

    /// The fixed groups and those given as pairs of function and group.
    pub(crate) fn with(groups: &[(u8, u8)]) -> Result<Groups, GroupError> {
        let mut table = Groups::new();
        for &(m, group) in groups {
            let free = m_group(m).is_none_or(|own| own == group);
            let place = table.0.get_mut(usize::from(m));
            *place.filter(|_| free && (1..=OTHERS).contains(&group)).ok_or(GroupError { m, group })? = group;
        }
        Ok(table)
    }

    pub(crate) fn of(&self, m: u8) -> u8 {
        self.0.get(usize::from(m)).copied().unwrap_or(OTHERS)
    }
}

/// Gears that M41 to M44 choose.
const GEARS: u8 = 4;

/// Cell that holds the BCD code of the group's function, for the groups that have one.
const fn bcd_cell(group: u8) -> Option<Addr> {
    let number = match group {
        2 => 6,
        10 => 3,
        11 => 13,
        12 => 14,
        13 => 15,
        14 => 16,
        _ => return None,
    };
    Some(system::PB00 + number)
}

/// Bits that hold for one block.
const ONE_BLOCK: [(u8, BitRef); 8] = [
    (0, system::M00_PID),
    (1, system::M01_PID),
    (2, system::M02_PID),
    (30, system::M30_PID),
    (10, system::M10PID),
    (11, system::M11PID),
    (6, system::M06PID),
    (60, system::M60PI),
];

/// Change bit of a group: eight bits in the first byte, the rest in the next.
fn change_bit(group: u8) -> BitRef {
    let n = group - 1;
    let first = system::ZMM1PI;
    BitRef { addr: first.addr + Addr::from(n / 8), bit: n % 8, indexed: false }
}

fn gear_bit(gear: u8) -> BitRef {
    BitRef { bit: system::M41PI.bit + gear, ..system::M41PI }
}

/// Writes M function `m` (0..=99) of `group`.
pub(crate) fn write(memory: &mut Memory, m: u8, group: u8) {
    memory.set_flag(change_bit(group), true);
    if let Some(cell) = bcd_cell(group) {
        memory.set_byte(cell, to_bcd(u32::from(m)) as u8);
    }
    for (function, bit) in ONE_BLOCK {
        if function == m {
            memory.set_flag(bit, true);
        }
    }
    // These stay until another function of the group.
    match group {
        2 => {
            for (bit, on) in [(system::M03PI, 3), (system::M04PI, 4), (system::M19PI, 19)] {
                memory.set_flag(bit, m == on);
            }
        }
        // M40 leaves the choice of the gear to the control: the bits stay until it makes one.
        3 if m != 40 => select_gear(memory, m.wrapping_sub(41)),
        5 => {
            memory.set_flag(system::M07PI, matches!(m, 7 | 17));
            memory.set_flag(system::M08PI, matches!(m, 8 | 17));
        }
        6 => {
            memory.set_flag(system::M50PI, matches!(m, 50 | 52));
            memory.set_flag(system::M51PI, matches!(m, 51 | 52));
        }
        _ => {}
    }
}

fn select_gear(memory: &mut Memory, gear: u8) {
    for n in 0..GEARS {
        memory.set_flag(gear_bit(n), n == gear);
    }
}

/// Writes T as eight BCD digits, low byte first.
pub(crate) fn write_tool(memory: &mut Memory, tool: u32) {
    for (n, byte) in to_bcd(tool).to_le_bytes().into_iter().enumerate() {
        memory.set_byte(system::PB00 + 7 + n as Addr, byte);
    }
    memory.set_flag(system::ZMSTPI, true);
}

/// Writes H as two BCD digits.
pub(crate) fn write_h(memory: &mut Memory, h: u8) {
    memory.set_byte(system::PB00 + 5, to_bcd(u32::from(h)) as u8);
    memory.set_flag(system::ZMSHPI, true);
}

/// Writes the programmed spindle value.
pub(crate) fn write_spindle(memory: &mut Memory, value: u16) {
    memory.set_word(system::PB00 + 11, value);
    memory.set_flag(system::ZMSSPI, true);
}

/// Clears what holds for one block.
pub(crate) fn clear_one_block(memory: &mut Memory) {
    for (_, bit) in ONE_BLOCK {
        memory.set_flag(bit, false);
    }
    for group in 1..=OTHERS {
        memory.set_flag(change_bit(group), false);
    }
    memory.set_flag(system::ZMSHPI, false);
    memory.set_flag(system::ZMSTPI, false);
    memory.set_flag(system::ZMSSPI, false);
}
