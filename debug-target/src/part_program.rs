//! Blocks of the machine file as the PLC is given them.

use technol_machine::{BlockExtra, BlockFlag, BlockMode, BlockStart};
use technol_runtime::{self as runtime, Block, BlockFlags, BlockReal, Prepared};

/// Millimetres in a metre.
const MM: f64 = 1000.0;

/// A block that the machine starts.
pub(crate) fn block(start: BlockStart) -> Block {
    let BlockStart { m, s, t, h, motion_ms, rapid, mode, extra } = start;
    let mode = match mode {
        BlockMode::Auto => runtime::BlockMode::Auto,
        BlockMode::CentralAnnulment => runtime::BlockMode::CentralAnnulment,
        BlockMode::Reference => runtime::BlockMode::Reference,
        BlockMode::Other => runtime::BlockMode::Other,
    };
    Block { m, t, s, h, motion_ms, rapid, mode, prepared: Some(Box::new(prepared(&extra))) }
}

fn prepared(extra: &BlockExtra) -> Prepared {
    let mut prepared = Prepared { flags: flags(extra), ..Prepared::default() };
    for (place, value) in prepared.integers.iter_mut().zip(&extra.integers) {
        *place = Some(*value);
    }
    for (place, value) in prepared.reals.iter_mut().zip(&extra.reals) {
        *place = Some(*value);
    }
    for (axis, target) in &extra.axes {
        if let Some(place) = prepared.axes.get_mut(usize::from(*axis)) {
            *place = Some(*target);
        }
    }
    for (real, value) in [
        (BlockReal::SpindleSpeed, extra.speed),
        (BlockReal::ConstCuttingSpeed, extra.cutting_speed.map(|speed| speed * MM)),
        (BlockReal::SpindleSpeedLimit, extra.speed_limit),
        (BlockReal::FeedProgr, extra.feed),
        (BlockReal::FeedMax, extra.feed_max),
        (BlockReal::BlockLen, extra.length),
        (BlockReal::Delay, extra.dwell),
        (BlockReal::Scale, extra.scale),
    ] {
        if let Some(value) = value {
            prepared.set(real, value);
        }
    }
    prepared
}

fn flags(extra: &BlockExtra) -> BlockFlags {
    let mut flags = BlockFlags::default();
    if extra.first {
        flags = flags.with(runtime::BlockFlag::First);
    }
    if extra.last {
        flags = flags.with(runtime::BlockFlag::Last);
    }
    for flag in &extra.flags {
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
