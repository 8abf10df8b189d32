//! Fixed places in the system region that the supervisor itself reads or writes.
//!
//! This is the interface between control and PLC program of this implementation; the catalogue of system
//! symbols (names, types, meaning) uses these addresses and allocates every other symbol from
//! [`FREE`] on. Changing one is a new image version.

use crate::op::{Addr, BitRef};

pub mod data;
pub mod devices;
pub mod motion;

/// P1IN … P128IN: input ports.
pub const IN_PORTS: Addr = 0x0000;
/// Number of input ports.
pub const IN_PORT_COUNT: u32 = 128;
/// P0OUT … P95OUT: output ports.
pub const OUT_PORTS: Addr = 0x0080;
/// Number of output ports.
pub const OUT_PORT_COUNT: u32 = 96;
/// SETL_P1IN … : force-to-0 masks of the inputs.
pub const IN_FORCE_LOW: Addr = 0x00E0;
/// SETH_P1IN … : force-to-1 masks of the inputs.
pub const IN_FORCE_HIGH: Addr = 0x0160;
/// SETL_P0OUT … : force-to-0 masks of the outputs.
pub const OUT_FORCE_LOW: Addr = 0x01E0;
/// SETH_P0OUT … : force-to-1 masks of the outputs.
pub const OUT_FORCE_HIGH: Addr = 0x0240;
/// ERRLI_P0OUT … : short-circuit bits of the outputs.
pub const OUT_SHORTED: Addr = 0x02A0;
/// First byte of the block interface (functions of the block in progress).
pub const BLOCK: Addr = 0x0300;
/// First byte that the symbol catalogue may allocate.
pub const FREE: Addr = 0x0400;
/// Length of the system region.
pub const LEN: u32 = 0x8000;

const fn bit(addr: Addr, bit: u8) -> BitRef {
    BitRef { addr, bit, indexed: false }
}

/// PO_F: block in progress.
pub const PO_F: BitRef = bit(BLOCK, 0);
/// PO_POL: programmed position reached.
pub const PO_POL: BitRef = bit(BLOCK, 1);
/// PO_STOP: stop confirmed.
pub const PO_STOP: BitRef = bit(BLOCK, 2);
/// INPOS: axes in position tolerance.
pub const INPOS: BitRef = bit(BLOCK, 3);
/// AUTPI: block started in automatic mode.
pub const AUTPI: BitRef = bit(BLOCK, 4);
/// REFPI: reference run started.
pub const REFPI: BitRef = bit(BLOCK, 5);
/// CAPI: block started in the mode of central annulment.
pub const CAPI: BitRef = bit(BLOCK, 6);
/// G00PI: block with rapid traverse.
pub const G00PI: BitRef = bit(BLOCK, 7);
/// STOPPI: stop request of the PLC (rising edge).
pub const STOPPI: BitRef = bit(BLOCK + 1, 0);
/// STOP_REQ: acknowledged stop request.
pub const STOP_REQ: BitRef = bit(BLOCK + 1, 1);
/// STOP_EMERGENCY_REQ: acknowledged emergency stop request.
pub const STOP_EMERGENCY_REQ: BitRef = bit(BLOCK + 1, 2);
/// START_DISABLE: nothing can be started.
pub const START_DISABLE: BitRef = bit(BLOCK + 1, 3);
/// START_SUSPEND: holds a start in progress.
pub const START_SUSPEND: BitRef = bit(BLOCK + 1, 4);
/// BLOCK_RESTART: restart of a block.
pub const BLOCK_RESTART: BitRef = bit(BLOCK + 1, 5);
/// G33PI: thread cutting.
pub const G33PI: BitRef = bit(BLOCK + 1, 6);
/// M03PI: spindle clockwise (static).
pub const M03PI: BitRef = bit(BLOCK + 2, 0);
/// M04PI: spindle counter-clockwise (static).
pub const M04PI: BitRef = bit(BLOCK + 2, 1);
/// M19PI: oriented spindle stop (static).
pub const M19PI: BitRef = bit(BLOCK + 2, 2);
/// M41PI … M44PI: spindle gear (static), bits 3..=6.
pub const M41PI: BitRef = bit(BLOCK + 2, 3);
/// M07PI: coolant 1 (static).
pub const M07PI: BitRef = bit(BLOCK + 3, 0);
/// M08PI: coolant 2 (static).
pub const M08PI: BitRef = bit(BLOCK + 3, 1);
/// M50PI: coolant 3 (static).
pub const M50PI: BitRef = bit(BLOCK + 3, 2);
/// M51PI: coolant 4 (static).
pub const M51PI: BitRef = bit(BLOCK + 3, 3);
/// M00_PID (one block).
pub const M00_PID: BitRef = bit(BLOCK + 4, 0);
/// M01_PID (one block).
pub const M01_PID: BitRef = bit(BLOCK + 4, 1);
/// M02_PID (one block).
pub const M02_PID: BitRef = bit(BLOCK + 4, 2);
/// M30_PID (one block).
pub const M30_PID: BitRef = bit(BLOCK + 4, 3);
/// M10PID: clamp (one block).
pub const M10PID: BitRef = bit(BLOCK + 4, 4);
/// M11PID: unclamp (one block).
pub const M11PID: BitRef = bit(BLOCK + 4, 5);
/// M06PID: tool change (one block).
pub const M06PID: BitRef = bit(BLOCK + 4, 6);
/// M60PI: workpiece change (one block).
pub const M60PI: BitRef = bit(BLOCK + 4, 7);
/// ZMM1PI … ZMM14PI: change bits of the M groups, bits 0..=7 here, 8..=13 in the next byte.
pub const ZMM1PI: BitRef = bit(BLOCK + 5, 0);
/// ZMSHPI: change bit of H.
pub const ZMSHPI: BitRef = bit(BLOCK + 6, 6);
/// ZMSTPI: change bit of T.
pub const ZMSTPI: BitRef = bit(BLOCK + 6, 7);
/// ZMSSPI: change bit of S.
pub const ZMSSPI: BitRef = bit(BLOCK + 7, 0);
/// PB03 … PB20: BYTE cells of the command block; PBnn is at `PB00 + nn`. PB07..PB10 hold T (BCD, low byte
/// first), PB05 H, PB06 the M function of group 2, PB11/PB12 the spindle voltage.
pub const PB00: Addr = BLOCK + 0x10;
/// STATUS_RESTART: BYTE, stage of the block at a restart.
pub const STATUS_RESTART: Addr = BLOCK + 0x30;
/// CNT_NEXT_BLOCKS: WORD, number of prepared blocks.
pub const CNT_NEXT_BLOCKS: Addr = BLOCK + 0x32;

/// G23ACT: a continuous run is in progress.
pub const G23ACT: BitRef = bit(0x08B7, 0);
/// TIME_DIST: DWORD, milliseconds to the end of the continuous run.
pub const TIME_DIST: Addr = 0x08B8;
/// PRODLEVA: lamp of a dwell.
pub const PRODLEVA: BitRef = bit(0x1354, 0);
/// SF_RUN: functions are performed or axes move.
pub const SF_RUN: BitRef = bit(0x1354, 1);
/// SF_BLOCKINPROGR: a block is in progress.
pub const SF_BLOCKINPROGR: BitRef = bit(0x1354, 2);
/// SF_BLOCKFINISHED: the last block was finished.
pub const SF_BLOCKFINISHED: BitRef = bit(0x1354, 3);
/// SF_STOP: stopped, in a block or behind one.
pub const SF_STOP: BitRef = bit(0x1354, 4);
/// SF_NOTINPOS: the position is not reached.
pub const SF_NOTINPOS: BitRef = bit(0x1354, 5);
/// SF_DELAYINPROGR: a dwell runs.
pub const SF_DELAYINPROGR: BitRef = bit(0x1354, 6);
/// SF_CONDSTOPMODE: M01 stops.
pub const SF_CONDSTOPMODE: BitRef = bit(0x1355, 2);
/// SF_BACKWARD: the block runs backwards.
pub const SF_BACKWARD: BitRef = bit(0x1355, 7);
/// Records of the prepared blocks, `BLK[n]`: number 0 is the block in progress, the others are the waiting ones
/// (manual 8.3). A record past the last waiting block is zero.
pub const BLOCK_RECORDS: Addr = 0x6000;
/// Records: the block in progress and those that can wait.
pub const BLOCK_RECORD_COUNT: u32 = 17;
/// Member of the block that BX names, copied here by [`Op::SelectBlock`](crate::Op::SelectBlock) for the
/// operation after it.
pub const BLOCK_WINDOW: Addr = BLOCK_RECORDS + BLOCK_RECORD_COUNT * block_record::LEN;
/// Eight bytes that stay zero: the members of a block that there can never be.
pub const NO_BLOCK: Addr = BLOCK_WINDOW + 8;
/// First byte behind everything that the supervisor reads or writes.
pub const SUPERVISOR_END: Addr = NO_BLOCK + 8;

/// Offsets in the record of a prepared block.
pub mod block_record {
    /// Length in bytes.
    pub const LEN: u32 = 368;
    /// M0 … M14: change bits of the M groups, two bytes.
    pub const M_CHANGED: u32 = 0;
    /// AxNC0Move … AxNC15Move: two bytes.
    pub const AXES_MOVE: u32 = 2;
    /// IPlc0 … IPlc4.
    pub const INTEGERS_CHANGED: u32 = 4;
    /// RPlc0 … RPlc4; the bits from [`FIRST_FLAG`] on are the flags, in two more bytes.
    pub const REALS_CHANGED: u32 = 5;
    /// Bit of `FirstBlock` in the byte at [`REALS_CHANGED`]. LastBlock, Stop, CondStop, Backward, SelBlock, Cont,
    /// TchlOff, Partial, HProg, TProg, RevFeed, ContinuousMode and ConstCutSpeed follow.
    pub const FIRST_FLAG: u32 = 5;
    /// Length of all bits.
    pub const BITS_LEN: u32 = 8;
    /// M\[0\] … \[14\]: DWORD, BCD.
    pub const M: u32 = 8;
    /// IPlcParams\[0\] … \[4\]: DWORD.
    pub const INTEGERS: u32 = 68;
    /// AxG\[0\] … \[2\]: DWORD.
    pub const GEOMETRIC_AXES: u32 = 88;
    /// T: DWORD.
    pub const T: u32 = 100;
    /// H: REAL.
    pub const H: u32 = 104;
    /// RPlcParams\[0\] … \[4\]: REAL.
    pub const REALS: u32 = 112;
    /// Delay: REAL.
    pub const DELAY: u32 = 152;
    /// AxNC\[0\] … \[15\]: REAL.
    pub const AXES: u32 = 160;
    /// BlockLen: REAL. Scale, FeedProgr, FeedMax, FeedCriterial, ParabAccel, LinearAccel, SpindleSpeed,
    /// SpindleSpeedLimit and ConstCuttingSpeed follow.
    pub const BLOCK_LEN: u32 = 288;
}

/// Group of the M functions that have a fixed one (manual 8.2.1).
#[must_use]
pub const fn m_group(m: u8) -> Option<u8> {
    Some(match m {
        0 | 1 | 2 | 30 => 1,
        3 | 4 | 5 | 19 => 2,
        40..=44 => 3,
        7 | 8 | 9 | 17 => 5,
        50..=53 => 6,
        10 | 11 => 7,
        48 | 49 => 8,
        6 | 60 => 9,
        _ => return None,
    })
}

/// Event codes of `_ON_EVENT` (DR on entry).
pub mod event {
    /// Stop requested.
    pub const STOP_REQ: i64 = 1;
    /// Emergency stop requested.
    pub const STOP_EMERGENCY_REQ: i64 = 2;
    /// Stopped.
    pub const STOP: i64 = 3;
    /// Started.
    pub const START: i64 = 4;
    /// Start requested.
    pub const START_REQ: i64 = 5;
}
