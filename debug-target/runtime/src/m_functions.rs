//! The functions of a part-program block in the block cells of the system region (manual 8.2).

use technol_image::op::{Addr, BitRef};
use technol_image::system;

use crate::decimal::to_bcd;
use crate::memory::Memory;

/// Fixed group of an M function; all others are in group 14.
fn group(m: u8) -> u8 {
    match m {
        0 | 1 | 2 | 30 => 1,
        3 | 4 | 5 | 19 => 2,
        40..=44 => 3,
        7 | 8 | 9 | 17 => 5,
        50..=53 => 6,
        10 | 11 => 7,
        48 | 49 => 8,
        6 | 60 => 9,
        _ => 14,
    }
}

/// Cell that holds the BCD code of the group's function, for the groups that have one. Groups 10 to 13 are
/// free by configuration of the control, which this runtime does not read.
fn bcd_cell(group: u8) -> Option<Addr> {
    match group {
        2 => Some(system::PB00 + 6),
        14 => Some(system::PB00 + 16),
        _ => None,
    }
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

/// Writes M function `m` (0..=99).
pub(crate) fn write(memory: &mut Memory, m: u8) {
    let group = group(m);
    memory.set_flag(change_bit(group), true);
    if let Some(cell) = bcd_cell(group) {
        memory.set_byte(cell, to_bcd(u32::from(m)) as u8);
    }
    for (function, bit) in ONE_BLOCK {
        if function == m {
            memory.set_flag(bit, true);
        }
    }
    write_static(memory, m);
}

/// Bits that stay until another function of the group.
fn write_static(memory: &mut Memory, m: u8) {
    let mut write = |bit, value| memory.set_flag(bit, value);
    match m {
        3 | 4 | 5 | 19 => {
            write(system::M03PI, m == 3);
            write(system::M04PI, m == 4);
            write(system::M19PI, m == 19);
        }
        // M40 leaves the choice of the gear to the control: the bits stay until it makes one.
        41..=44 => (0..4).for_each(|gear| write(gear_bit(gear), m == 41 + gear)),
        7 | 8 | 9 | 17 => {
            write(system::M07PI, matches!(m, 7 | 17));
            write(system::M08PI, matches!(m, 8 | 17));
        }
        50..=53 => {
            write(system::M50PI, matches!(m, 50 | 52));
            write(system::M51PI, matches!(m, 51 | 52));
        }
        _ => {}
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
    for group in 1..=14 {
        memory.set_flag(change_bit(group), false);
    }
    memory.set_flag(system::ZMSHPI, false);
    memory.set_flag(system::ZMSTPI, false);
    memory.set_flag(system::ZMSSPI, false);
}
