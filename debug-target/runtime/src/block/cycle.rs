//! The block cycle: functions of a part-program block, MODULE_BLOCK_INIT, movement, dwell, MODULE_BLOCK_DONE
//! (manual 5.2, 8.1, 8.2).

use alloc::collections::VecDeque;

use technol_image::op::BitRef;
use technol_image::system;

use super::{Block, BlockMode, Rejection};
use crate::continuous;
use crate::control::{AxesOfBlock, BlockMotion, BlockSpindle, BlockWay, Control};
use crate::m_functions::{self, Groups};
use crate::memory::Memory;
use crate::prepared::{self, BLOCK_AXES, BlockFlag, BlockReal};

/// Blocks that wait for their turn.
pub(crate) const QUEUE_LEN: usize = 16;

/// Stage of the block in progress.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Stage {
    /// No block.
    Idle,
    /// MODULE_BLOCK_INIT runs.
    Preparing,
    /// The movement runs.
    Moving { left_ms: u32 },
    /// The position is reached; the dwell of the block (G04) runs.
    Dwelling { left_ms: u32 },
    /// MODULE_BLOCK_DONE runs.
    Closing,
}

/// How the block in progress moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Movement {
    /// For a time.
    Time,
    /// To its targets, as soon as their axes are free.
    Wanted,
    /// To its targets; the control has the axes.
    Taken,
}

/// A start that was requested and not yet carried out (manual 8.1.13).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Start {
    /// Of the blocks that wait.
    Program,
    /// Of the block that was stopped.
    Again,
}

/// The block in progress and those that wait.
#[derive(Clone, Debug)]
pub(crate) struct BlockCycle {
    pub(crate) stage: Stage,
    pub(crate) queue: VecDeque<Block>,
    pub(crate) groups: Groups,
    /// M01 stops.
    pub(crate) conditional_stop: bool,
    start: Option<Start>,
    /// Started: blocks follow each other.
    running: bool,
    /// M40 is in force: the gear follows the programmed speed.
    automatic_gear: bool,
    /// The program stops behind the block in progress.
    stop_behind: bool,
    /// The block in progress, or the last one, runs backwards.
    backward: bool,
    /// The last block was finished.
    finished: bool,
    /// The part program ends with the block in progress.
    ends_program: bool,
    /// Movement of the block in progress.
    movement: Movement,
    motion_ms: u32,
    /// Milliseconds of its dwell.
    dwell_ms: u32,
    rapid: bool,
    /// It is programmed to run on into the next one (G23).
    continuous: bool,
    /// A continuous run is in progress.
    running_on: bool,
    targets: [Option<f64>; BLOCK_AXES],
    per_revolution: bool,
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
            groups: Groups::new(),
            conditional_stop: false,
            start: None,
            running: false,
            automatic_gear: false,
            stop_behind: false,
            backward: false,
            finished: false,
            ends_program: false,
            movement: Movement::Time,
            motion_ms: 0,
            dwell_ms: 0,
            rapid: false,
            continuous: false,
            running_on: false,
            targets: [None; BLOCK_AXES],
            per_revolution: false,
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

    /// A block was queued. True when that is the start of a program, which `_ON_EVENT` is to be asked about first.
    pub(crate) fn request_start(&mut self, memory: &mut Memory) -> bool {
        // What waits behind a stop waits for the START key, also when more of the program comes.
        let waits = memory.flag(system::PO_STOP) && self.queue.len() > 1;
        self.request((self.is_idle() && !waits).then_some(Start::Program), memory)
    }

    fn is_idle(&self) -> bool {
        self.stage == Stage::Idle && !self.running && !self.queue.is_empty()
    }

    /// The START key after a stop: in a block, behind one (M00), or of something else that the control holds. True as
    /// in [`request_start`](Self::request_start).
    pub(crate) fn request_restart(&mut self, held: bool, memory: &mut Memory) -> bool {
        let again = self.stopped || held;
        let start = if again { Some(Start::Again) } else { self.is_idle().then_some(Start::Program) };
        self.request(start, memory)
    }

    fn request(&mut self, start: Option<Start>, memory: &mut Memory) -> bool {
        if self.start.is_some() || start.is_none() {
            return false;
        }
        memory.set_flag(system::START_SUSPEND, false);
        self.start = start;
        true
    }

    /// Carries out a requested start unless the PLC forbids or holds it. True when it did.
    pub(crate) fn take_start(&mut self, memory: &mut Memory) -> bool {
        if memory.flag(system::START_DISABLE) || memory.flag(system::START_SUSPEND) {
            return false;
        }
        match self.start.take() {
            None => return false,
            Some(Start::Program) => self.running = true,
            Some(Start::Again) => self.restart(memory),
        }
        true
    }

    /// Takes the next block over into the block cells. False when there is none or no program was started.
    pub(crate) fn begin(&mut self, memory: &mut Memory, control: &mut dyn Control) -> bool {
        if !self.running {
            return false;
        }
        let Some(block) = self.queue.pop_front() else {
            self.running = false;
            return false;
        };
        memory.set_word(system::CNT_NEXT_BLOCKS, self.queue.len() as u16);
        prepared::write_all(memory, &self.groups, &block, self.queue.iter());
        self.stopped = false;
        self.stop_behind = block.is_stop(self.conditional_stop);
        self.backward = block.has(BlockFlag::Backward);
        self.finished = false;
        memory.set_flag(system::PO_STOP, false);
        memory.set_flag(system::PO_POL, false);
        memory.set_flag(system::PO_F, true);
        memory.set_flag(system::AUTPI, block.mode == BlockMode::Auto);
        memory.set_flag(system::CAPI, block.mode == BlockMode::CentralAnnulment);
        memory.set_flag(system::REFPI, block.mode == BlockMode::Reference);
        memory.set_flag(system::G00PI, block.rapid);
        memory.set_flag(system::G33PI, block.has(BlockFlag::Thread));
        self.write_functions(&block, memory, control);
        self.ends_program = block.ends_program();
        self.motion_ms = block.motion_ms;
        self.dwell_ms = block.dwell_ms();
        self.rapid = block.rapid;
        self.continuous = continuous::may_run_on(&block);
        self.per_revolution = block.has(BlockFlag::RevFeed);
        self.targets = block.prepared.as_ref().map_or([None; BLOCK_AXES], |prepared| prepared.axes);
        self.movement = if block.has_targets() { Movement::Wanted } else { Movement::Time };
        self.stage = Stage::Preparing;
        if !self.lacks_feed(memory) {
            self.take_axes(memory, control);
        }
        true
    }

    /// It should move its axes by a feed that nobody has programmed.
    pub(crate) fn lacks_feed(&self, memory: &Memory) -> bool {
        self.movement == Movement::Wanted && !self.rapid && prepared::feed(memory) <= 0.0
    }

    /// The control takes the axes of the block, as soon as they are free.
    pub(crate) fn take_axes(&mut self, memory: &mut Memory, control: &mut dyn Control) {
        if self.movement != Movement::Wanted {
            return;
        }
        let motion = BlockMotion {
            targets: &self.targets,
            feed: prepared::feed(memory),
            per_revolution: self.per_revolution,
            rapid: self.rapid,
        };
        match control.take_axes(&motion, memory.bytes_mut()) {
            AxesOfBlock::Busy => {}
            AxesOfBlock::None => {
                self.movement = Movement::Time;
                if let Stage::Moving { left_ms } = &mut self.stage {
                    *left_ms = self.motion_ms;
                }
            }
            AxesOfBlock::Taken => {
                self.movement = Movement::Taken;
                if matches!(self.stage, Stage::Moving { .. }) {
                    control.release_axes();
                }
            }
        }
    }

    fn write_functions(&mut self, block: &Block, memory: &mut Memory, control: &mut dyn Control) {
        for m in block.m.iter() {
            let group = self.groups.of(*m);
            m_functions::write(memory, *m, group);
            if group == 3 {
                self.automatic_gear = *m == 40;
            }
        }
        if let Some(tool) = block.t {
            m_functions::write_tool(memory, tool);
        }
        if let Some(h) = block.h {
            m_functions::write_h(memory, h);
        }
        let programmed = block.prepared.as_ref().and_then(|p| p.value(BlockReal::SpindleSpeed));
        let cutting = block.has(BlockFlag::ConstCutSpeed).then(|| prepared::cutting_speed(memory));
        let spindle = BlockSpindle {
            programmed,
            speed: prepared::spindle_speed(memory),
            automatic_gear: self.automatic_gear,
            gear_programmed: block.m.contains(&40),
            cutting_speed: cutting,
            speed_limit: prepared::spindle_speed_limit(memory),
        };
        control.block_spindle(&spindle, memory.bytes_mut());
        if let Some(value) = block.s {
            m_functions::write_spindle(memory, value);
        }
    }

    /// Preparation is over: the movement is released.
    pub(crate) fn release(&mut self, memory: &mut Memory, control: &mut dyn Control) {
        let timed = self.movement == Movement::Time;
        self.stage = Stage::Moving { left_ms: if timed { self.motion_ms } else { 0 } };
        if self.movement == Movement::Taken {
            control.release_axes();
        }
        self.running_on = self.continuous;
        self.tell_position(memory, control);
    }

    /// The movement is at its end and not held.
    pub(crate) fn arrived(&self, control: &dyn Control) -> bool {
        self.stage == Stage::Moving { left_ms: 0 }
            && !self.stopped
            && match self.movement {
                Movement::Time => true,
                Movement::Wanted => false,
                Movement::Taken => control.block_way() == BlockWay::Arrived,
            }
    }

    /// The control has given the movement up.
    pub(crate) fn lost(&self, control: &dyn Control) -> bool {
        matches!(self.stage, Stage::Moving { .. })
            && !self.stopped
            && self.movement == Movement::Taken
            && control.block_way() == BlockWay::Lost
    }

    /// INPOS: no axis moves, and no movement that only takes its time.
    pub(crate) fn tell_position(&self, memory: &mut Memory, control: &dyn Control) {
        let timed = matches!(self.stage, Stage::Moving { left_ms } if left_ms > 0) && !self.stopped;
        memory.set_flag(system::INPOS, !timed && control.in_position());
    }

    /// The target is reached; a dwell begins.
    pub(crate) fn reach(&mut self, memory: &mut Memory) {
        memory.set_flag(system::PO_POL, true);
        // A dwell ends a continuous run, and so does a block that does not go on with it.
        self.running_on &= self.dwell_ms == 0 && self.queue.front().is_some_and(continuous::goes_on);
        self.stage = Stage::Dwelling { left_ms: self.dwell_ms };
        if self.dwell_ms > 0 {
            memory.set_flag(system::PRODLEVA, true);
        }
    }

    /// The dwell is over and not held.
    pub(crate) fn has_dwelt(&self) -> bool {
        self.stage == Stage::Dwelling { left_ms: 0 } && !self.stopped
    }

    /// Closing functions begin.
    pub(crate) fn close(&mut self, memory: &mut Memory) {
        self.stage = Stage::Closing;
        self.end_dwell(memory);
    }

    /// The lamp goes out, unless the program alone has lit it.
    fn end_dwell(&mut self, memory: &mut Memory) {
        if core::mem::take(&mut self.dwell_ms) > 0 {
            memory.set_flag(system::PRODLEVA, false);
        }
    }

    /// One millisecond of movement or dwell.
    pub(crate) fn advance(&mut self) {
        if let Stage::Moving { left_ms } | Stage::Dwelling { left_ms } = &mut self.stage
            && !self.stopped
        {
            *left_ms = left_ms.saturating_sub(1);
        }
    }

    /// The block is finished. True when the program stops behind it: M00, or M01 where that counts.
    pub(crate) fn finish(&mut self, memory: &mut Memory) -> bool {
        let was_stopped = self.stopped;
        self.end(memory);
        self.finished = true;
        if self.ends_program {
            self.end_program(memory);
            return false;
        }
        let stops = self.stop_behind && !self.queue.is_empty() && !was_stopped;
        self.running &= !stops && !was_stopped && !self.queue.is_empty();
        if stops {
            memory.set_flag(system::PO_STOP, true);
        }
        stops
    }

    /// M02, M30: what is left of the program is forgotten. A program behind it goes on.
    fn end_program(&mut self, memory: &mut Memory) {
        while self.queue.front().is_some_and(|block| !block.has(BlockFlag::First)) {
            self.queue.pop_front();
        }
        self.running = !self.queue.is_empty();
        if !self.running {
            self.forget(memory);
        }
    }

    /// The status of the control as far as blocks make it (manual 8.3.6 and 8.4.4).
    pub(crate) fn publish(&self, memory: &mut Memory, control: &dyn Control) {
        let left = if self.running_on { self.time_left(memory, control) } else { 0 };
        memory.set_dword(system::TIME_DIST, left);
        let dwells = matches!(self.stage, Stage::Dwelling { left_ms } if left_ms > 0);
        let busy = self.stage != Stage::Idle;
        let in_position = memory.flag(system::INPOS);
        let stop = memory.flag(system::PO_STOP);
        for (bit, value) in [
            (system::SF_RUN, busy && !self.stopped),
            (system::SF_BLOCKINPROGR, busy),
            (system::SF_BLOCKFINISHED, self.finished),
            (system::SF_STOP, stop),
            (system::SF_NOTINPOS, !in_position),
            (system::SF_DELAYINPROGR, dwells),
            (system::G23ACT, self.running_on),
            (system::SF_CONDSTOPMODE, self.conditional_stop),
            (system::SF_BACKWARD, busy && self.backward),
        ] {
            memory.set_flag(bit, value);
        }
    }

    /// Milliseconds to the end of the continuous run.
    fn time_left(&self, memory: &Memory, control: &dyn Control) -> u32 {
        let own = match (self.stage, self.movement) {
            (Stage::Moving { left_ms }, Movement::Time) => left_ms,
            (Stage::Moving { .. }, _) => control.block_time_left(),
            _ => 0,
        };
        let behind = if self.dwell_ms == 0 { continuous::time_of(self.queue.iter(), memory) } else { 0 };
        own.saturating_add(behind)
    }

    /// The block is broken off, if there is one, and the program with it. True when there was one.
    pub(crate) fn abort(&mut self, memory: &mut Memory) -> bool {
        self.forget(memory);
        let was_busy = self.stage != Stage::Idle;
        if was_busy {
            self.end(memory);
        }
        prepared::end_current(memory);
        was_busy
    }

    fn end(&mut self, memory: &mut Memory) {
        if matches!(self.stage, Stage::Dwelling { .. }) {
            self.end_dwell(memory);
        }
        self.stage = Stage::Idle;
        self.stopped = false;
        self.running_on &= self.queue.front().is_some_and(continuous::goes_on);
        memory.set_flag(system::PO_F, false);
        memory.set_flag(system::BLOCK_RESTART, false);
        memory.set_byte(system::STATUS_RESTART, 0);
        m_functions::clear_one_block(memory);
    }

    /// Nothing waits any more, and nothing is to be started.
    fn forget(&mut self, memory: &mut Memory) {
        self.queue.clear();
        self.start = None;
        self.running = false;
        self.running_on = false;
        memory.set_word(system::CNT_NEXT_BLOCKS, 0);
        prepared::forget_waiting(memory);
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

    /// Stops what is running: the movement holds, and queued blocks wait. A start that is only requested is
    /// withdrawn, with the program it was for unless that waits behind M00. False when nothing was running.
    pub(crate) fn stop(&mut self, memory: &mut Memory) -> bool {
        let withdrawn = self.start.take() == Some(Start::Program);
        if self.stage == Stage::Idle {
            if withdrawn && !memory.flag(system::PO_STOP) {
                self.forget(memory);
            }
            if !self.running || self.queue.is_empty() {
                return false;
            }
            self.running = false;
        }
        self.stopped = self.stage != Stage::Idle;
        memory.set_flag(system::PO_STOP, true);
        true
    }

    /// Start after a stop.
    fn restart(&mut self, memory: &mut Memory) {
        self.stopped = false;
        self.running = true;
        let stage = match self.stage {
            Stage::Idle => 0,
            Stage::Preparing => 1,
            Stage::Moving { .. } => 2,
            Stage::Dwelling { .. } => 3,
            Stage::Closing => 4,
        };
        memory.set_flag(system::PO_STOP, false);
        memory.set_byte(system::STATUS_RESTART, stage);
        if self.stage != Stage::Idle {
            memory.set_flag(system::BLOCK_RESTART, true);
            prepared::mark_partial(memory);
        }
    }
}

/// Reads a request bit and clears it.
fn taken(memory: &mut Memory, bit: BitRef) -> bool {
    let set = memory.flag(bit);
    memory.set_flag(bit, false);
    set
}
