//! A block of the part program: several axes on a straight line.

pub use technol_runtime::Hold;
use technol_runtime::root;

use super::AXES;
use super::axis::Axis;
use super::feed::Feed;
use super::ramp::{Goal, Ramp};
use super::units::{UM, per_minute};

/// Movement of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BlockMove {
    /// How far each axis goes, X first, in µm.
    pub travel: [f64; AXES],
    /// Feed along the path in mm/min, or in mm/rev; not used in rapid traverse.
    pub feed: f64,
    /// The feed is that of a revolution of the main spindle (G95).
    pub per_revolution: bool,
    /// Rapid traverse: as fast as the slowest axis allows.
    pub rapid: bool,
}

impl BlockMove {
    /// Axes (1 to 16; others do not count) that go so far, in µm, with this feed in mm/min.
    #[must_use]
    pub fn at_feed(travel: &[(u8, f64)], feed: f64) -> BlockMove {
        let mut block = BlockMove { feed, ..BlockMove::default() };
        for &(number, way) in travel {
            if let Some(sum) = block.travel.get_mut(usize::from(number).wrapping_sub(1)) {
                *sum += way;
            }
        }
        block
    }

    /// Axes that go so far in rapid traverse.
    #[must_use]
    pub fn rapid(travel: &[(u8, f64)]) -> BlockMove {
        BlockMove { rapid: true, ..BlockMove::at_feed(travel, 0.0) }
    }
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

/// What a tick lets a path do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Way {
    pub(crate) hold: Hold,
    /// The greatest speed that limits allow.
    pub(crate) slow: f64,
    /// How far it is to the first software limit.
    pub(crate) room: f64,
    /// Revolutions of the main spindle in a second.
    pub(crate) revolutions: f64,
}

/// The path in progress.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    /// Where each axis began…
    begin: [f64; AXES],
    /// …and its share of the path; 0 for those that take no part.
    share: [f64; AXES],
    /// The preparatory functions are through.
    released: bool,
    length: f64,
    along: Ramp,
    feed: f64,
    per_revolution: bool,
    rapid: bool,
    accel: f64,
    emergency: f64,
    /// The greatest speed along the path with which no axis is too fast.
    greatest: f64,
    /// The speed that it was let go in the last tick.
    allowed: f64,
}

impl Path {
    /// A path of axes that are free; `None` when it has no length.
    pub(crate) fn new(block: &BlockMove, all: &[Axis]) -> Option<Path> {
        let length = root(block.travel.iter().map(|way| way * way).sum());
        if !length.is_finite() || length <= 0.0 {
            return None;
        }
        let mut path = Path {
            begin: [0.0; AXES],
            share: [0.0; AXES],
            released: false,
            length,
            along: Ramp::default(),
            feed: if block.per_revolution { block.feed * UM } else { per_minute(block.feed) },
            per_revolution: block.per_revolution,
            rapid: block.rapid,
            accel: f64::INFINITY,
            emergency: f64::INFINITY,
            greatest: f64::INFINITY,
            allowed: 0.0,
        };
        let moving = all.iter().zip(block.travel).enumerate();
        for (index, (axis, way)) in moving.filter(|(_, (_, way))| *way != 0.0) {
            let share = way / length;
            let steepest =
                if block.rapid { axis.settings.acceleration_rapid } else { axis.settings.acceleration };
            path.accel = path.accel.min(steepest / share.abs());
            path.emergency = path.emergency.min(axis.settings.emergency / share.abs());
            path.greatest = path.greatest.min(axis.settings.rapid / share.abs());
            (path.begin[index], path.share[index]) = (axis.ramp.position, share);
        }
        Some(path)
    }

    /// Axes that take part, a bit an axis.
    pub(crate) fn mask(&self) -> u16 {
        self.places().fold(0, |mask, (index, ..)| mask | 1 << index)
    }

    /// Axes that go in negative direction, a bit an axis.
    pub(crate) fn negative(&self) -> u16 {
        self.places().filter(|(_, share, _)| *share < 0.0).fold(0, |mask, (index, ..)| mask | 1 << index)
    }

    /// It may move.
    pub(crate) fn release(&mut self) {
        self.released = true;
    }

    /// It does not move.
    pub(crate) fn stands(&self) -> bool {
        self.along.velocity == 0.0
    }

    /// Milliseconds to its end at the speed of now; how long it takes to get up to speed is not counted. It never ends while it
    /// is held.
    pub(crate) fn millis_left(&self) -> u32 {
        let (left, speed) = (self.length - self.along.position, self.allowed);
        let brake = speed * speed / (2.0 * self.accel);
        let seconds = if left < brake {
            root(2.0 * left / self.accel)
        } else {
            (left - brake) / speed + speed / self.accel
        };
        // What is no number is held; more than fits is the greatest.
        if seconds.is_nan() { u32::MAX } else { (seconds * 1000.0) as u32 }
    }

    /// An axis is shifted beside the path.
    pub(crate) fn shift(&mut self, axis: usize, step: f64) {
        self.begin[axis] += step;
    }

    /// Its axes: index, share of the path with sign, and where they are on it.
    pub(crate) fn places(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let taking_part = self.share.iter().enumerate().filter(|(_, share)| **share != 0.0);
        taking_part.map(|(index, share)| (index, *share, self.begin[index] + share * self.along.position))
    }

    /// One tick; `true` at the end of the path.
    pub(crate) fn tick(&mut self, all: &mut [Axis], feed: &Feed, way: Way) -> bool {
        let Way { hold, slow, room, revolutions } = way;
        if !self.released {
            return false;
        }
        let speed = if self.rapid {
            feed.rapid(self.greatest, self.greatest)
        } else {
            let each_second = if self.per_revolution { self.feed * revolutions } else { self.feed };
            feed.working(each_second, self.greatest)
        };
        let speed = if hold == Hold::Go { speed.min(slow) } else { 0.0 };
        let accel = if hold == Hold::Emergency { self.emergency } else { self.accel };
        self.allowed = speed;
        let target = self.length.min(self.along.position + room.max(0.0));
        let done = self.along.tick(Goal::Position { target, speed, approach: 0.0 }, accel);
        for (index, share) in self.share.iter().enumerate().filter(|(_, share)| **share != 0.0) {
            let (axis, begin) = (&mut all[index], self.begin[index]);
            let before = axis.ramp.position;
            axis.ramp =
                Ramp { position: begin + share * self.along.position, velocity: share * self.along.velocity };
            axis.shift(axis.ramp.position - before, 0);
        }
        done && target >= self.length
    }
}
