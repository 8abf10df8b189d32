//! Fixed places in the system region that the supervisor itself reads or writes.
//!
//! This is the interface between control and PLC program of this implementation; the catalogue of system
//! symbols (names, types, meaning) uses these addresses and allocates every other symbol from
//! [`FREE`] on. Changing one is a new image version.

use crate::op::{Addr, BitRef};

pub mod data;

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
