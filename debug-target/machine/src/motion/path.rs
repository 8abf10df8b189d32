//! A block of the part program: several axes on a straight line.

use alloc::vec::Vec;

use super::axis::Axis;
use super::feed::Feed;
use super::ramp::{Goal, Ramp};
use super::units::{per_minute, root};

/// Movement of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockMove {
    /// Axes (1 to 16) and how far they go, in µm.
    pub travel: Vec<(u8, i64)>,
    /// Feed along the path in mm/min; not used in rapid traverse.
    pub feed: f64,
    /// Rapid traverse: as fast as the slowest axis allows.
    pub rapid: bool,
}

/// How a block stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BlockState {
    /// There is none, or it was broken off.
    #[default]
    None,
    /// On its way, or held.
    Moving,
    /// Its target is reached.
    Done,
}

/// Why a block is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// It is not.
    #[default]
    Go,
    /// STOP, or the preparatory functions are not through yet.
    Stop,
    /// Emergency stop: by the steepest ramps.
    Emergency,
}

/// The path in progress.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    /// Index of an axis, where it began and its share of the path.
    axes: Vec<(usize, f64, f64)>,
    length: f64,
    along: Ramp,
    feed: f64,
    rapid: bool,
    accel: f64,
    emergency: f64,
    /// The greatest speed along the path with which no axis is too fast.
    greatest: f64,
}

impl Path {
    /// A path of axes that are free; `None` when it has no length.
    pub(crate) fn new(block: &BlockMove, all: &[Axis]) -> Option<Path> {
        let mut ways = [0.0; super::AXES];
        for &(number, way) in &block.travel {
            if let Some(sum) = ways.get_mut(usize::from(number).wrapping_sub(1)) {
                *sum += way as f64;
            }
        }
        let length = root(ways.iter().map(|way| way * way).sum());
        if length <= 0.0 {
            return None;
        }
        let mut path = Path {
            axes: Vec::new(),
            length,
            along: Ramp::default(),
            feed: per_minute(block.feed),
            rapid: block.rapid,
            accel: f64::INFINITY,
            emergency: f64::INFINITY,
            greatest: f64::INFINITY,
        };
        for (index, (axis, way)) in all.iter().zip(ways).enumerate().filter(|(_, (_, way))| *way != 0.0) {
            let share = way / length;
            let steepest =
                if block.rapid { axis.settings.acceleration_rapid } else { axis.settings.acceleration };
            path.accel = path.accel.min(steepest / share.abs());
            path.emergency = path.emergency.min(axis.settings.emergency / share.abs());
            path.greatest = path.greatest.min(axis.settings.rapid / share.abs());
            path.axes.push((index, axis.ramp.position, share));
        }
        Some(path)
    }

    /// Axes that take part, a bit an axis.
    pub(crate) fn mask(&self) -> u16 {
        self.axes.iter().fold(0, |mask, (index, ..)| mask | 1 << index)
    }

    /// It does not move.
    pub(crate) fn stands(&self) -> bool {
        self.along.velocity == 0.0
    }

    /// Its axes: index, share of the path with sign, and where they are on it.
    pub(crate) fn places(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        self.axes.iter().map(|&(index, begin, share)| (index, share, begin + share * self.along.position))
    }

    /// One tick; `true` at the end of the path.
    pub(crate) fn tick(&mut self, all: &mut [Axis], feed: &Feed, hold: Hold, slow: f64) -> bool {
        let speed = if self.rapid {
            feed.rapid(self.greatest, self.greatest)
        } else {
            feed.working(self.feed, self.greatest)
        };
        let speed = if hold == Hold::Go { speed.min(slow) } else { 0.0 };
        let accel = if hold == Hold::Emergency { self.emergency } else { self.accel };
        let done = self.along.tick(Goal::Position { target: self.length, speed, approach: 0.0 }, accel);
        for &(index, begin, share) in &self.axes {
            let axis = &mut all[index];
            let before = axis.ramp.position;
            axis.ramp =
                Ramp { position: begin + share * self.along.position, velocity: share * self.along.velocity };
            axis.shift(axis.ramp.position - before, 0);
        }
        done
    }
}
