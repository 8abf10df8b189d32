//! The block cycle: functions of a part-program block, MODULE_BLOCK_INIT, movement, MODULE_BLOCK_DONE
//! (manual 5.2, 8.1, 8.2).

use alloc::collections::VecDeque;
use alloc::vec::Vec;
use core::fmt;

use technol_image::op::BitRef;
use technol_image::system;

use crate::m_functions;
use crate::memory::Memory;

/// Blocks that wait for their turn.
pub(crate) const QUEUE_LEN: usize = 16;

/// How a block was started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BlockMode {
    /// Automatic: AUTPI.
    #[default]
    Auto,
    /// Central annulment: CAPI.
    CentralAnnulment,
    /// Reference run: REFPI.
    Reference,
    /// None of these (manual data input, jog).
    Other,
}

/// A part-program block as handed to the PLC.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Block {
    /// M functions, 0..=99, in the order they are written.
    pub m: Vec<u8>,
    /// T function, at most eight digits.
    pub t: Option<u32>,
    /// Spindle value for PB11/PB12, 0..=7FFFh.
    pub s: Option<u16>,
    /// H function, 0..=99.
    pub h: Option<u8>,
    /// The movement takes this many milliseconds; 0 is a block without movement.
    pub motion_ms: u32,
    /// Rapid traverse: G00PI.
    pub rapid: bool,
    /// Mode of the start.
    pub mode: BlockMode,
}

/// Why a block was not accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejection {
    /// The PLC is not running.
    NotRunning,
    /// 16 blocks are waiting already.
    QueueFull,
    /// An M or H function above 99, T above 99999999 or S above 7FFFh.
    OutOfRange,
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Rejection::NotRunning => "the PLC is not running; start it first",
            Rejection::QueueFull => "16 blocks are waiting already; wait until one has finished",
            Rejection::OutOfRange => "a function is out of range (M and H 0..99, T 8 digits, S 0..32767)",
        })
    }
}

/// Stage of the block in progress.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Stage {
    /// No block.
    Idle,
    /// MODULE_BLOCK_INIT runs.
    Preparing,
    /// The movement runs.
    Moving { left_ms: u32 },
    /// MODULE_BLOCK_DONE runs.
    Closing,
}

/// The block in progress and those that wait.
#[derive(Clone, Debug)]
pub(crate) struct BlockCycle {
    pub(crate) stage: Stage,
    pub(crate) queue: VecDeque<Block>,
    /// Movement of the block in progress.
    motion_ms: u32,
    /// A stop was taken: the movement holds.
    pub(crate) stopped: bool,
    /// STOPPI at the last look.
    stop_seen: bool,
}

impl BlockCycle {
    pub(crate) fn new() -> BlockCycle {
        BlockCycle {
            stage: Stage::Idle,
            queue: VecDeque::with_capacity(QUEUE_LEN),
            motion_ms: 0,
            stopped: false,
            stop_seen: false,
        }
    }

    /// Queues a block.
    pub(crate) fn accept(&mut self, block: Block) -> Result<(), Rejection> {
        let in_range = block.m.iter().all(|m| *m <= 99)
            && block.h.is_none_or(|h| h <= 99)
            && block.t.is_none_or(|t| t <= 99_999_999)
            && block.s.is_none_or(|s| s <= 0x7FFF);
        if !in_range {
            return Err(Rejection::OutOfRange);
        }
        if self.queue.len() >= QUEUE_LEN {
            return Err(Rejection::QueueFull);
        }
        self.queue.push_back(block);
        Ok(())
    }

    /// Takes the next block over into the block cells. False when there is none or the PLC forbids a start.
    pub(crate) fn begin(&mut self, memory: &mut Memory) -> bool {
        if memory.flag(system::START_DISABLE) || memory.flag(system::START_SUSPEND) {
            return false;
        }
        let Some(block) = self.queue.pop_front() else { return false };
        let waiting = self.queue.len() as u16;
        memory.set_word(system::CNT_NEXT_BLOCKS, waiting);
        self.stopped = false;
        memory.set_flag(system::PO_STOP, false);
        memory.set_flag(system::PO_POL, false);
        memory.set_flag(system::PO_F, true);
        memory.set_flag(system::AUTPI, block.mode == BlockMode::Auto);
        memory.set_flag(system::CAPI, block.mode == BlockMode::CentralAnnulment);
        memory.set_flag(system::REFPI, block.mode == BlockMode::Reference);
        memory.set_flag(system::G00PI, block.rapid);
        for m in &block.m {
            m_functions::write(memory, *m);
        }
        if let Some(tool) = block.t {
            m_functions::write_tool(memory, tool);
        }
        if let Some(h) = block.h {
            m_functions::write_h(memory, h);
        }
        if let Some(value) = block.s {
            m_functions::write_spindle(memory, value);
        }
        self.motion_ms = block.motion_ms;
        self.stage = Stage::Preparing;
        true
    }

    /// Preparation is over: the movement is released.
    pub(crate) fn release(&mut self, memory: &mut Memory) {
        self.stage = Stage::Moving { left_ms: self.motion_ms };
        memory.set_flag(system::INPOS, self.motion_ms == 0 || self.stopped);
    }

    /// The movement is at its end and not held.
    pub(crate) fn arrived(&self) -> bool {
        self.stage == Stage::Moving { left_ms: 0 } && !self.stopped
    }

    /// Closing functions begin.
    pub(crate) fn close(&mut self, memory: &mut Memory) {
        self.stage = Stage::Closing;
        memory.set_flag(system::INPOS, true);
        memory.set_flag(system::PO_POL, true);
    }

    /// One millisecond of movement.
    pub(crate) fn advance(&mut self) {
        if let Stage::Moving { left_ms } = &mut self.stage
            && !self.stopped
        {
            *left_ms = left_ms.saturating_sub(1);
        }
    }

    /// The block is over, finished or broken off.
    pub(crate) fn end(&mut self, memory: &mut Memory) {
        self.stage = Stage::Idle;
        self.stopped = false;
        memory.set_flag(system::PO_F, false);
        memory.set_flag(system::INPOS, true);
        memory.set_flag(system::BLOCK_RESTART, false);
        memory.set_byte(system::STATUS_RESTART, 0);
        m_functions::clear_one_block(memory);
    }

    /// Looks for a stop request of the PLC and takes it. Returns its event code.
    pub(crate) fn take_stop_request(&mut self, memory: &mut Memory) -> Option<i64> {
        let level = memory.flag(system::STOPPI);
        let edge = level && !self.stop_seen;
        self.stop_seen = level;
        let emergency = taken(memory, system::STOP_EMERGENCY_REQ);
        let requested = taken(memory, system::STOP_REQ) || edge;
        if emergency {
            Some(system::event::STOP_EMERGENCY_REQ)
        } else {
            requested.then_some(system::event::STOP_REQ)
        }
    }

    /// Stops what is running: the movement holds, queued blocks are forgotten. False when nothing was running.
    pub(crate) fn stop(&mut self, memory: &mut Memory) -> bool {
        self.queue.clear();
        memory.set_word(system::CNT_NEXT_BLOCKS, 0);
        if self.stage == Stage::Idle {
            return false;
        }
        self.stopped = true;
        memory.set_flag(system::PO_STOP, true);
        memory.set_flag(system::INPOS, true);
        true
    }

    /// Start after a stop.
    pub(crate) fn restart(&mut self, memory: &mut Memory) {
        if !self.stopped || memory.flag(system::START_DISABLE) {
            return;
        }
        self.stopped = false;
        let stage = match self.stage {
            Stage::Idle => 0,
            Stage::Preparing => 1,
            Stage::Moving { .. } => 2,
            Stage::Closing => 3,
        };
        memory.set_flag(system::PO_STOP, false);
        memory.set_flag(system::BLOCK_RESTART, true);
        memory.set_byte(system::STATUS_RESTART, stage);
        if matches!(self.stage, Stage::Moving { left_ms } if left_ms > 0) {
            memory.set_flag(system::INPOS, false);
        }
    }
}

/// Reads a request bit and clears it.
fn taken(memory: &mut Memory, bit: BitRef) -> bool {
    let set = memory.flag(bit);
    memory.set_flag(bit, false);
    set
}
