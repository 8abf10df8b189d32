//! The records of the prepared blocks, `BLK[n]` (manual 8.3): the block in progress and those that wait.
//!
//! What a block does not program keeps the value of the block before it, as on the control; the change bits tell
//! what it does program.

use technol_image::op::{Addr, BitRef};
use technol_image::system::{
    BLOCK_RECORD_COUNT, BLOCK_RECORDS, BLOCK_WINDOW, CNT_NEXT_BLOCKS, block_record as record,
};

use crate::block::Block;
use crate::decimal::to_bcd;
use crate::m_functions::Groups;
use crate::memory::Memory;

/// Integer and real parameters for the PLC that a block can carry.
pub const BLOCK_PARAMETERS: usize = 5;
/// Axes of the control.
pub const BLOCK_AXES: usize = 16;

/// A property of a block; the number is its place among the flags of the record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockFlag {
    /// FirstBlock: the first one of its program.
    First = 0,
    /// LastBlock: the last one.
    Last = 1,
    /// Backward: it runs backwards.
    Backward = 4,
    /// SelBlock: the operator selected it.
    Selected = 5,
    /// Cont: it approaches from a place off the path.
    Approach = 6,
    /// TchlOff: it runs without technology.
    WithoutTechnology = 7,
    /// RevFeed: feed per revolution, G95.
    RevFeed = 11,
    /// ContinuousMode: continuous run, G23.
    Continuous = 12,
    /// ConstCutSpeed: constant cutting speed, G96.
    ConstCutSpeed = 13,
    /// Thread cutting, G33: G33PI; the record has no flag for it.
    Thread = 14,
}

const STOP: u32 = 2;
const COND_STOP: u32 = 3;
const PARTIAL: u32 = 8;
const H_PROGRAMMED: u32 = 9;
const T_PROGRAMMED: u32 = 10;

/// A set of properties.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct BlockFlags(u16);

impl BlockFlags {
    /// The set with one more.
    #[must_use]
    pub const fn with(self, flag: BlockFlag) -> BlockFlags {
        BlockFlags(self.0 | 1 << flag as u16)
    }

    /// Whether it holds this one.
    #[must_use]
    pub const fn has(self, flag: BlockFlag) -> bool {
        self.0 >> flag as u16 & 1 != 0
    }
}

/// A real number of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockReal {
    /// Dwell; only for the block that programs it.
    Delay,
    /// Length of the path in mm; only for the block that has it.
    BlockLen,
    /// Scale; 1 where a block does not say.
    Scale,
    /// Programmed feed in mm/min.
    FeedProgr,
    /// Largest feed in mm/min.
    FeedMax,
    /// Criterion feed at the beginning of the block.
    FeedCriterial,
    /// Parabolic acceleration.
    ParabAccel,
    /// Linear acceleration.
    LinearAccel,
    /// Spindle speed in rev/min.
    SpindleSpeed,
    /// Largest spindle speed at constant cutting speed in rev/min.
    SpindleSpeedLimit,
    /// Constant cutting speed in mm/min.
    ConstCuttingSpeed,
}

impl BlockReal {
    /// All of them.
    pub const ALL: [BlockReal; 11] = [
        BlockReal::Delay,
        BlockReal::BlockLen,
        BlockReal::Scale,
        BlockReal::FeedProgr,
        BlockReal::FeedMax,
        BlockReal::FeedCriterial,
        BlockReal::ParabAccel,
        BlockReal::LinearAccel,
        BlockReal::SpindleSpeed,
        BlockReal::SpindleSpeedLimit,
        BlockReal::ConstCuttingSpeed,
    ];

    const fn offset(self) -> u32 {
        match self {
            BlockReal::Delay => record::DELAY,
            other => record::BLOCK_LEN + 8 * (other as u32 - 1),
        }
    }

    /// Value in a block that does not program it; `None`: that of the block before.
    const fn default(self) -> Option<f64> {
        match self {
            BlockReal::Delay | BlockReal::BlockLen => Some(0.0),
            BlockReal::Scale => Some(1.0),
            _ => None,
        }
    }
}

/// What a block programs beyond its functions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prepared {
    /// Properties.
    pub flags: BlockFlags,
    /// Integer parameters for the PLC.
    pub integers: [Option<i32>; BLOCK_PARAMETERS],
    /// Real parameters for the PLC.
    pub reals: [Option<f64>; BLOCK_PARAMETERS],
    /// Targets of the NC axes in mm; an axis with a target moves.
    pub axes: [Option<f64>; BLOCK_AXES],
    /// Numbers, by [`BlockReal`].
    pub values: [Option<f64>; BlockReal::ALL.len()],
}

impl Prepared {
    /// A programmed number.
    #[must_use]
    pub const fn value(&self, real: BlockReal) -> Option<f64> {
        self.values[real as usize]
    }

    /// Programs a number.
    pub const fn set(&mut self, real: BlockReal, value: f64) {
        self.values[real as usize] = Some(value);
    }
}

/// Writes the record of the block in progress and those of the waiting blocks; the others are zero.
pub(crate) fn write_all<'a>(
    memory: &mut Memory,
    groups: &Groups,
    current: &Block,
    waiting: impl Iterator<Item = &'a Block>,
) {
    write(memory, groups, 0, current);
    let mut count = 1;
    for block in waiting.take(BLOCK_RECORD_COUNT as usize - 1) {
        memory.copy(at(count - 1) as usize, at(count) as usize, record::LEN as usize);
        write(memory, groups, count, block);
        count += 1;
    }
    clear_from(memory, count);
}

/// No block waits.
pub(crate) fn forget_waiting(memory: &mut Memory) {
    clear_from(memory, 1);
}

/// No block is in progress: nothing is programmed any more, but numbers stay what they are.
pub(crate) fn end_current(memory: &mut Memory) {
    memory.fill(at(0) as usize, record::BITS_LEN as usize, 0);
}

/// The block in progress goes on from its middle.
pub(crate) fn mark_partial(memory: &mut Memory) {
    set_flag(memory, 0, PARTIAL);
}

/// Spindle speed of the block in progress in rev/min.
pub(crate) fn spindle_speed(memory: &Memory) -> f64 {
    memory.real(at(0) + BlockReal::SpindleSpeed.offset())
}

/// Feed of the block in progress.
pub(crate) fn feed(memory: &Memory) -> f64 {
    memory.real(at(0) + BlockReal::FeedProgr.offset())
}

/// Blocks that waited when the block in progress began, and have a record.
pub(crate) fn waiting(memory: &Memory) -> u32 {
    u32::from(memory.word(CNT_NEXT_BLOCKS)).min(BLOCK_RECORD_COUNT - 1)
}

/// Feed of a block by the number of its record.
pub(crate) fn feed_of(memory: &Memory, number: u32) -> f64 {
    memory.real(at(number) + BlockReal::FeedProgr.offset())
}

/// Where an axis is at the end of a block.
pub(crate) fn target_of(memory: &Memory, number: u32, axis: u32) -> f64 {
    memory.real(at(number) + record::AXES + 8 * axis)
}

/// Constant cutting speed of the block in progress in mm/min.
pub(crate) fn cutting_speed(memory: &Memory) -> f64 {
    memory.real(at(0) + BlockReal::ConstCuttingSpeed.offset())
}

/// Largest spindle speed at constant cutting speed in rev/min; 0 for none.
pub(crate) fn spindle_speed_limit(memory: &Memory) -> f64 {
    memory.real(at(0) + BlockReal::SpindleSpeedLimit.offset())
}

/// Brings a member of the block whose number is in BX to the place where it is read.
pub(crate) fn select(memory: &mut Memory, bx: u32, offset: u16, len: u8) {
    let len = usize::from(len);
    if bx < BLOCK_RECORD_COUNT {
        memory.copy((at(bx) + u32::from(offset)) as usize, BLOCK_WINDOW as usize, len);
    } else {
        memory.fill(BLOCK_WINDOW as usize, len, 0);
    }
}

fn at(number: u32) -> Addr {
    BLOCK_RECORDS + number * record::LEN
}

fn clear_from(memory: &mut Memory, count: u32) {
    let len = (BLOCK_RECORD_COUNT - count) * record::LEN;
    memory.fill(at(count) as usize, len as usize, 0);
}

fn set_bit(memory: &mut Memory, number: u32, offset: u32, bit: u32) {
    let addr = at(number) + offset + bit / 8;
    memory.set_flag(BitRef { addr, bit: (bit % 8) as u8, indexed: false }, true);
}

fn set_flag(memory: &mut Memory, number: u32, flag: u32) {
    set_bit(memory, number, record::REALS_CHANGED, record::FIRST_FLAG + flag);
}

/// Writes a record over that of the block before.
fn write(memory: &mut Memory, groups: &Groups, number: u32, block: &Block) {
    let base = at(number);
    memory.fill(base as usize, record::BITS_LEN as usize, 0);
    for m in block.m.iter() {
        let group = u32::from(groups.of(*m));
        set_bit(memory, number, record::M_CHANGED, group);
        memory.set_dword(base + record::M + 4 * group, to_bcd(u32::from(*m)));
        match m {
            0 => set_flag(memory, number, STOP),
            1 => set_flag(memory, number, COND_STOP),
            _ => {}
        }
    }
    if let Some(tool) = block.t {
        set_flag(memory, number, T_PROGRAMMED);
        memory.set_dword(base + record::T, tool);
    }
    if let Some(h) = block.h {
        set_flag(memory, number, H_PROGRAMMED);
        memory.set_real(base + record::H, f64::from(h));
    }
    for axis in 0..3 {
        memory.set_dword(base + record::GEOMETRIC_AXES + 4 * axis, axis);
    }
    let nothing = Prepared::default();
    let prepared = block.prepared.as_deref().unwrap_or(&nothing);
    write_prepared(memory, number, prepared);
}

fn write_prepared(memory: &mut Memory, number: u32, prepared: &Prepared) {
    let base = at(number);
    for flag in 0..BlockFlag::Thread as u32 {
        if prepared.flags.0 >> flag & 1 != 0 {
            set_flag(memory, number, flag);
        }
    }
    for (n, value) in (0..).zip(prepared.integers) {
        if let Some(value) = value {
            set_bit(memory, number, record::INTEGERS_CHANGED, n);
            memory.set_dword(base + record::INTEGERS + 4 * n, value.cast_unsigned());
        }
    }
    for (n, value) in (0..).zip(prepared.reals) {
        if let Some(value) = value {
            set_bit(memory, number, record::REALS_CHANGED, n);
            memory.set_real(base + record::REALS + 8 * n, value);
        }
    }
    for (n, target) in (0..).zip(prepared.axes) {
        if let Some(target) = target {
            set_bit(memory, number, record::AXES_MOVE, n);
            memory.set_real(base + record::AXES + 8 * n, target);
        }
    }
    for real in BlockReal::ALL {
        if let Some(value) = prepared.value(real).or(real.default()) {
            memory.set_real(base + real.offset(), value);
        }
    }
}
