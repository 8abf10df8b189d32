//! The continuous run (G23): blocks that follow each other without a halt, and how long they take (manual 8.4.4).
//!
//! It goes on from block to block as long as each is programmed so, moves at a feed and has neither functions nor a dwell. Angles between
//! blocks are not looked at: what is too great is a matter of the path, of which a PLC knows nothing.

use crate::block::Block;
use crate::memory::Memory;
use crate::prepared::{self, BLOCK_AXES, BlockFlag};
use crate::root::root;

/// Milliseconds in a minute.
const MINUTE: f64 = 60_000.0;

/// A block may be the first of a continuous run: it is programmed so, and moves at a feed.
pub(crate) fn may_run_on(block: &Block) -> bool {
    block.has(BlockFlag::Continuous) && !block.rapid && (block.has_targets() || block.motion_ms > 0)
}

/// A continuous run goes on with a block: functions and a dwell would end it.
pub(crate) fn goes_on(block: &Block) -> bool {
    let functions = !block.m.is_empty() || block.t.is_some() || block.s.is_some() || block.h.is_some();
    may_run_on(block) && !functions && block.dwell_ms() == 0
}

/// Milliseconds that the blocks of the run take, of those that wait. Ramps are not counted, and those that came after the
/// block in progress began have no record yet.
pub(crate) fn time_of<'a>(waiting: impl Iterator<Item = &'a Block>, memory: &Memory) -> u32 {
    let known = prepared::waiting(memory);
    let run = waiting.zip(1..=known).take_while(|(block, _)| goes_on(block));
    run.fold(0, |sum: u32, (block, number)| sum.saturating_add(time(block, number, memory)))
}

fn time(block: &Block, number: u32, memory: &Memory) -> u32 {
    if !block.has_targets() {
        return block.motion_ms;
    }
    let feed = prepared::feed_of(memory, number);
    if feed <= 0.0 || block.has(BlockFlag::RevFeed) {
        return 0;
    }
    let way =
        |axis| prepared::target_of(memory, number, axis) - prepared::target_of(memory, number - 1, axis);
    let squares = (0..BLOCK_AXES as u32).map(|axis| way(axis) * way(axis)).sum();
    (root(squares) / feed * MINUTE) as u32
}
