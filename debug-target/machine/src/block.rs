//! Part-program blocks that the control starts.

use alloc::vec::Vec;

use serde::Deserialize;
use technol_runtime::{self as runtime, Block, BlockFlags, BlockReal, Prepared, Shared};

use crate::compile::Compiler;
use crate::config;
use crate::signal::{InputImage, OutputImage, Signal};

/// How a block is started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlockMode {
    /// Automatic.
    #[default]
    Auto,
    /// Central annulment.
    CentralAnnulment,
    /// Reference run.
    Reference,
    /// None of these.
    Other,
}

/// A property of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlockFlag {
    /// It runs backwards.
    Backward,
    /// The operator selected it.
    Selected,
    /// It approaches from a place off the path.
    Approach,
    /// It runs without technology.
    WithoutTechnology,
    /// Feed per revolution, G95.
    RevFeed,
    /// Continuous run, G23.
    Continuous,
    /// Constant cutting speed, G96.
    ConstCutSpeed,
    /// Thread cutting, G33.
    Thread,
}

/// What a block tells beyond its functions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockExtra {
    /// The first of its program.
    pub first: bool,
    /// The last of its program.
    pub last: bool,
    /// Properties.
    pub flags: Vec<BlockFlag>,
    /// Spindle speed in rev/min.
    pub speed: Option<f64>,
    /// Constant cutting speed in m/min.
    pub cutting_speed: Option<f64>,
    /// Largest spindle speed at constant cutting speed in rev/min.
    pub speed_limit: Option<f64>,
    /// Feed in mm/min, or in mm/rev.
    pub feed: Option<f64>,
    /// Largest feed in mm/min.
    pub feed_max: Option<f64>,
    /// Length of the path in mm.
    pub length: Option<f64>,
    /// Dwell.
    pub dwell: Option<f64>,
    /// Scale.
    pub scale: Option<f64>,
    /// Integer parameters for the PLC.
    pub integers: Vec<i32>,
    /// Real parameters for the PLC.
    pub reals: Vec<f64>,
    /// NC axes and their targets in mm.
    pub axes: Vec<(u8, f64)>,
}

/// A block to be started; values are within the ranges of [`config::Block`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockStart {
    /// M functions.
    pub m: Vec<u8>,
    /// Spindle value.
    pub s: Option<u16>,
    /// Tool.
    pub t: Option<u32>,
    /// H function.
    pub h: Option<u8>,
    /// Duration of its movement in milliseconds, when it has no targets.
    pub motion_ms: u32,
    /// Rapid traverse.
    pub rapid: bool,
    /// Mode.
    pub mode: BlockMode,
    /// The rest.
    pub extra: BlockExtra,
}

/// Millimetres in a metre.
const MM: f64 = 1000.0;

impl BlockStart {
    /// The block as the PLC is given it. Its copies share what it lists.
    #[must_use]
    pub fn block(&self) -> Block {
        Block {
            m: self.m.as_slice().into(),
            t: self.t,
            s: self.s,
            h: self.h,
            motion_ms: self.motion_ms,
            rapid: self.rapid,
            mode: match self.mode {
                BlockMode::Auto => runtime::BlockMode::Auto,
                BlockMode::CentralAnnulment => runtime::BlockMode::CentralAnnulment,
                BlockMode::Reference => runtime::BlockMode::Reference,
                BlockMode::Other => runtime::BlockMode::Other,
            },
            prepared: Some(Shared::new(self.extra.prepared())),
        }
    }
}

impl BlockExtra {
    fn prepared(&self) -> Prepared {
        let mut prepared = Prepared { flags: self.block_flags(), ..Prepared::default() };
        for (place, value) in prepared.integers.iter_mut().zip(&self.integers) {
            *place = Some(*value);
        }
        for (place, value) in prepared.reals.iter_mut().zip(&self.reals) {
            *place = Some(*value);
        }
        for (axis, target) in &self.axes {
            if let Some(place) = prepared.axes.get_mut(usize::from(*axis)) {
                *place = Some(*target);
            }
        }
        for (real, value) in [
            (BlockReal::SpindleSpeed, self.speed),
            (BlockReal::ConstCuttingSpeed, self.cutting_speed.map(|speed| speed * MM)),
            (BlockReal::SpindleSpeedLimit, self.speed_limit),
            (BlockReal::FeedProgr, self.feed),
            (BlockReal::FeedMax, self.feed_max),
            (BlockReal::BlockLen, self.length),
            (BlockReal::Delay, self.dwell),
            (BlockReal::Scale, self.scale),
        ] {
            if let Some(value) = value {
                prepared.set(real, value);
            }
        }
        prepared
    }

    fn block_flags(&self) -> BlockFlags {
        let mut flags = BlockFlags::default();
        if self.first {
            flags = flags.with(runtime::BlockFlag::First);
        }
        if self.last {
            flags = flags.with(runtime::BlockFlag::Last);
        }
        for flag in &self.flags {
            flags = flags.with(match flag {
                BlockFlag::Backward => runtime::BlockFlag::Backward,
                BlockFlag::Selected => runtime::BlockFlag::Selected,
                BlockFlag::Approach => runtime::BlockFlag::Approach,
                BlockFlag::WithoutTechnology => runtime::BlockFlag::WithoutTechnology,
                BlockFlag::RevFeed => runtime::BlockFlag::RevFeed,
                BlockFlag::Continuous => runtime::BlockFlag::Continuous,
                BlockFlag::ConstCutSpeed => runtime::BlockFlag::ConstCutSpeed,
                BlockFlag::Thread => runtime::BlockFlag::Thread,
            });
        }
        flags
    }
}

/// The farthest target in mm.
const FARTHEST: f64 = 1e6;

/// What starts a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Trigger {
    AtCycle(u64),
    Rising(Signal),
}

/// Blocks that are started together, one after another.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    trigger: Trigger,
    blocks: Vec<Block>,
    /// Level of the signal at the last look; it counts as on at first, so that only a change starts anything.
    was_on: bool,
}

impl Program {
    /// Groups blocks: one without a trigger of its own belongs to the one before it.
    pub(crate) fn compile(blocks: &[config::Block], compiler: &mut Compiler<'_>) -> Vec<Program> {
        let mut programs: Vec<(Trigger, Vec<BlockStart>)> = Vec::new();
        let mut known = Known::default();
        for (index, block) in blocks.iter().enumerate() {
            compiler.enter("block", Some(index));
            check_ranges(block, compiler);
            if block.at_cycle.is_some() || block.on.is_some() {
                known = Known::default();
            }
            known.check(block, compiler);
            let trigger = match (block.at_cycle, &block.on) {
                (Some(_), Some(_)) => {
                    compiler.error("on", "cannot be combined with `at-cycle`");
                    continue;
                }
                (Some(cycle), None) => Some(Trigger::AtCycle(cycle)),
                (None, Some(name)) => match compiler.signal("on", name) {
                    Some(signal) => Some(Trigger::Rising(signal)),
                    None => continue,
                },
                (None, None) => None,
            };
            match (trigger, programs.last_mut()) {
                (Some(trigger), _) => programs.push((trigger, [start(block)].to_vec())),
                (None, Some((_, blocks))) => blocks.push(start(block)),
                (None, None) if index == 0 => {
                    compiler.error("", "the first block needs `at-cycle` or `on`");
                }
                (None, None) => {} // the block before it is wrong, which is reported
            }
        }
        let program = |(trigger, mut blocks): (Trigger, Vec<BlockStart>)| {
            if let Some(first) = blocks.first_mut() {
                first.extra.first = true;
            }
            if let Some(last) = blocks.last_mut() {
                last.extra.last = true;
            }
            Program { trigger, blocks: blocks.iter().map(BlockStart::block).collect(), was_on: true }
        };
        programs.into_iter().map(program).collect()
    }

    /// Its blocks.
    pub(crate) fn len(&self) -> usize {
        self.blocks.len()
    }

    pub(crate) fn reset(&mut self) {
        self.was_on = true;
    }

    /// The blocks to start in this millisecond.
    pub(crate) fn step(&mut self, millis: u64, outputs: &OutputImage, inputs: &InputImage) -> &[Block] {
        let starts = match self.trigger {
            Trigger::AtCycle(cycle) => millis.is_multiple_of(20) && millis / 20 == cycle,
            Trigger::Rising(signal) => {
                let on = match signal {
                    Signal::Input { port, bit } => inputs[usize::from(port)] >> bit & 1 != 0,
                    Signal::Output { port, bit } => outputs[usize::from(port)] >> bit & 1 != 0,
                };
                let was_on = core::mem::replace(&mut self.was_on, on);
                on && !was_on
            }
        };
        if starts { &self.blocks } else { &[] }
    }
}

/// What the blocks of a program have programmed so far.
#[derive(Default)]
struct Known {
    feed: bool,
    cutting_speed: bool,
}

impl Known {
    /// Whether a block has what its movement needs.
    fn check(&mut self, block: &config::Block, compiler: &mut Compiler<'_>) {
        self.feed |= block.feed.is_some_and(|feed| feed > 0.0);
        self.cutting_speed |= block.cutting_speed.is_some_and(|speed| speed > 0.0);
        if !block.axes.is_empty() && !block.rapid && !self.feed {
            compiler.error("axes", "needs `feed`, here or in a block before it, or `rapid = true`");
        }
        if block.flags.contains(&BlockFlag::ConstCutSpeed) && !self.cutting_speed {
            compiler
                .error("flags", "\"const-cut-speed\" needs `cutting-speed`, here or in a block before it");
        }
    }
}

fn check_ranges(block: &config::Block, compiler: &mut Compiler<'_>) {
    if block.m.iter().any(|m| *m > 99) {
        compiler.error("m", "M functions go from 0 to 99");
    }
    if block.h.is_some_and(|h| h > 99) {
        compiler.error("h", "must be 0 to 99");
    }
    if block.t.is_some_and(|t| t > 99_999_999) {
        compiler.error("t", "has more than eight digits");
    }
    if block.s.is_some_and(|s| s > 0x7FFF) {
        compiler.error("s", "must be 0 to 32767");
    }
    for (key, len) in [("integers", block.integers.len()), ("reals", block.reals.len())] {
        if len > 5 {
            compiler.error(key, "a block has five parameters of each kind");
        }
    }
    if block.axes.iter().any(|(axis, _)| *axis > 15) {
        compiler.error("axes", "NC axes go from 0 to 15");
    }
    if block.axes.iter().any(|(_, target)| target.is_nan() || target.abs() > FARTHEST) {
        compiler.error("axes", "targets go from -1000000 to 1000000 mm");
    }
    let twice = |(n, (axis, _)): (usize, &(u8, f64))| block.axes[..n].iter().any(|(other, _)| other == axis);
    if block.axes.iter().enumerate().any(twice) {
        compiler.error("axes", "has an axis twice");
    }
    if block.motion_ms > 0 && !block.axes.is_empty() {
        compiler.error("motion-ms", "cannot be combined with `axes`, whose movement takes its own time");
    }
    for (key, value) in [
        ("speed", block.speed),
        ("cutting-speed", block.cutting_speed),
        ("speed-limit", block.speed_limit),
        ("feed", block.feed),
    ] {
        if value.is_some_and(|value| value.is_nan() || value < 0.0) {
            compiler.error(key, "must not be negative");
        }
    }
}

fn start(block: &config::Block) -> BlockStart {
    BlockStart {
        m: block.m.clone(),
        s: block.s,
        t: block.t,
        h: block.h,
        motion_ms: block.motion_ms,
        rapid: block.rapid,
        mode: block.mode,
        extra: BlockExtra {
            first: false,
            last: false,
            flags: block.flags.clone(),
            speed: block.speed,
            cutting_speed: block.cutting_speed,
            speed_limit: block.speed_limit,
            feed: block.feed,
            feed_max: block.feed_max,
            length: block.length_mm,
            dwell: block.dwell,
            scale: block.scale,
            integers: block.integers.clone(),
            reals: block.reals.clone(),
            axes: block.axes.clone(),
        },
    }
}
