//! The block cycle (manual 5.3): from a block that waits to the end of BLOCK_DONE, and what breaks it off.

use alloc::vec::Vec;

use technol_image::program::{ModuleKind, SequenceKind};
use technol_image::system;

use super::Progress;
use crate::block::{Block, Rejection, Stage};
use crate::code::module_of;
use crate::control::Hold;
use crate::event::RuntimeEvent;
use crate::execute::World;
use crate::runtime::Runtime;
use crate::sequence;

impl Runtime {
    /// Queues a block, unless it can't run.
    pub(super) fn accept_block(&mut self, block: Block, events: &mut Vec<RuntimeEvent>) {
        let accepted =
            if self.state.is_cycling() { self.block.accept(block) } else { Err(Rejection::NotRunning) };
        if let Err(rejection) = accepted {
            events.push(RuntimeEvent::BlockRejected(rejection));
        } else if self.block.request_start(&mut self.machine.memory) {
            self.queue_event(system::event::START_REQ);
        }
    }

    /// Block cycle: as far as it comes in this cycle.
    pub(super) fn run_block(&mut self, world: &mut World<'_>) -> Progress {
        if self.block.take_start(&mut self.machine.memory) {
            world.control.hold(Hold::Go);
            self.block.tell_position(&mut self.machine.memory, world.control);
            self.queue_event(system::event::START);
        }
        self.block.take_axes(&mut self.machine.memory, world.control);
        loop {
            match self.block.stage {
                Stage::Idle => {
                    if !self.block.begin(&mut self.machine.memory, world.control) {
                        return Progress::Done;
                    }
                    if self.block.lacks_feed(&self.machine.memory) {
                        world.events.push(RuntimeEvent::BlockRejected(Rejection::NoFeed));
                        self.abort_block(world);
                        return Progress::Done;
                    }
                    world.events.push(RuntimeEvent::BlockStarted { cycle: self.cycle() });
                    self.activate(SequenceKind::BlockInit);
                }
                Stage::Preparing => {
                    if self.run_block_module(ModuleKind::BlockInit, world) == Progress::Stopped {
                        return Progress::Stopped;
                    }
                    if self.is_active(SequenceKind::BlockInit) {
                        return Progress::Done;
                    }
                    self.block.release(&mut self.machine.memory, world.control);
                }
                Stage::Moving { .. } => {
                    if self.block.lost(world.control) {
                        self.stop_block(Hold::Stop, world);
                    }
                    if !self.block.arrived(world.control) {
                        return Progress::Done;
                    }
                    self.block.reach(&mut self.machine.memory);
                }
                Stage::Dwelling { .. } => {
                    if !self.block.has_dwelt() {
                        return Progress::Done;
                    }
                    self.block.close(&mut self.machine.memory);
                    self.activate(SequenceKind::BlockDone);
                }
                Stage::Closing => {
                    if self.run_block_module(ModuleKind::BlockDone, world) == Progress::Stopped {
                        return Progress::Stopped;
                    }
                    if !self.is_active(SequenceKind::BlockDone) {
                        if self.block.finish(&mut self.machine.memory) {
                            self.queue_event(system::event::STOP);
                        }
                        world.events.push(RuntimeEvent::BlockFinished { cycle: self.cycle() });
                    }
                    return Progress::Done;
                }
            }
        }
    }

    fn run_block_module(&mut self, kind: ModuleKind, world: &mut World<'_>) -> Progress {
        match self.program.modules.iter().position(|m| m.kind == kind) {
            Some(index) => self.run_module(index, world),
            None => Progress::Done,
        }
    }

    fn activate(&mut self, kind: SequenceKind) {
        if let Some(number) = self.sequence_of_kind(kind) {
            sequence::rest(&self.program, &mut self.machine, number);
            let bit = sequence::activation(&self.program.sequences[usize::from(number)]);
            // Without its module nothing would ever clear the bit.
            let has_module =
                module_of(&self.program, self.program.sequences[usize::from(number)].start).is_some();
            self.machine.memory.set_flag(bit, has_module);
        }
    }

    fn is_active(&self, kind: SequenceKind) -> bool {
        self.sequence_of_kind(kind).is_some_and(|number| {
            let bit = sequence::activation(&self.program.sequences[usize::from(number)]);
            self.machine.memory.flag(bit)
        })
    }

    /// Breaks the block in progress, rewinds the block modules and forgets queued blocks.
    pub(super) fn abort_block(&mut self, world: &mut World<'_>) {
        world.control.end_block(self.machine.memory.bytes_mut());
        if !self.block.abort(&mut self.machine.memory) {
            return;
        }
        for kind in [SequenceKind::BlockInit, SequenceKind::BlockDone] {
            if let Some(number) = self.sequence_of_kind(kind) {
                sequence::rest(&self.program, &mut self.machine, number);
            }
        }
        world.events.push(RuntimeEvent::BlockAborted { cycle: self.cycle() });
    }

    pub(super) fn take_stop_request(&mut self, world: &mut World<'_>) {
        if let Some(code) = self.block.take_stop_request(&mut self.machine.memory) {
            self.queue_event(code);
            let emergency = code == system::event::STOP_EMERGENCY_REQ;
            self.stop_block(if emergency { Hold::Emergency } else { Hold::Stop }, world);
        }
    }

    pub(super) fn stop_block(&mut self, hold: Hold, world: &mut World<'_>) {
        world.control.hold(hold);
        if self.block.stop(&mut self.machine.memory) {
            self.queue_event(system::event::STOP);
        }
        self.block.tell_position(&mut self.machine.memory, world.control);
    }
}
