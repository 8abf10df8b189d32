//! Feed override and limits of the feed (manual 8.1.19 and 8.4.1).

use technol_image::system::motion as place;

use super::cells::Cells;
use super::units::{FRACTION, UM};

/// What counts on top of a programmed feed in this tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Feed {
    /// 1.0 is the programmed feed.
    pub(crate) factor: f64,
    /// Greatest working feed, µm/s.
    pub(crate) working: f64,
    /// Greatest rapid traverse, µm/s.
    pub(crate) rapid: f64,
}

impl Feed {
    /// `percent` is that of the panel; the program may put its own in its place, and multiplies either.
    pub(crate) fn read(cells: &Cells<'_>, percent: u8) -> Feed {
        let base = if cells.bit(place::FEED_FROM_PROGRAM) {
            f64::from(cells.word(place::OVERRIDE_FEED)) / 1000.0
        } else {
            f64::from(percent) / 100.0
        };
        let limit = |request, at| {
            if cells.bit(request) { f64::from(cells.dword(at).max(0)) / FRACTION * UM } else { f64::INFINITY }
        };
        Feed {
            factor: base * f64::from(cells.word(place::FEED_MULTIPLIER)) / 1000.0,
            working: limit(place::LIMIT_FEED_REQ, place::LIMIT_FEED),
            rapid: limit(place::LIMIT_FEED_RAPID_REQ, place::LIMIT_FEED_RAPID),
        }
    }

    /// A working feed after override and limits; `greatest` is what the axis can do.
    pub(crate) fn working(&self, feed: f64, greatest: f64) -> f64 {
        (feed * self.factor).min(self.working).min(greatest)
    }

    /// Rapid traverse: the override slows it down only.
    pub(crate) fn rapid(&self, feed: f64, greatest: f64) -> f64 {
        (feed * self.factor.min(1.0)).min(self.rapid).min(greatest)
    }
}
