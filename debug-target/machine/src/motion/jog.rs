//! Manual movement beside the mode of the control (AUTMAN; manual 8.1.11 and 20).

use technol_image::system::motion as place;

use super::cells::Cells;
use super::feed::Feed;
use super::settings::AxisSettings;
use super::signals::has;
use super::units::{UM, per_minute};

/// A direction of movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Positive.
    Plus,
    /// Negative.
    Minus,
}

/// Manual movement of all axes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jog {
    /// ACK_AUTMAN.
    pub(crate) active: bool,
    /// AUTMAN_REQ keeps it active, so that its end ends it.
    by_level: bool,
    /// It was ended while AUTMAN_REQ was 1, which must fall before it counts again.
    cancelled: bool,
    /// Keys of the panel: axes with bit 0 for X, and rapid traverse.
    pub(crate) panel_plus: u16,
    pub(crate) panel_minus: u16,
    pub(crate) panel_rapid: bool,
    /// What is asked for in this tick.
    pub(crate) plus: u16,
    pub(crate) minus: u16,
    rapid: bool,
    /// POS_SPACE_PLC or, from the panel, POS0.
    pub(crate) space: usize,
}

impl Jog {
    /// Requests of this tick: what begins and ends it, and which axes shall move.
    pub(crate) fn tick(&mut self, cells: &mut Cells<'_>) {
        self.switch(cells);
        cells.set_bit(place::JOG_ACTIVE, self.active);
        let external = cells.bit(place::EXTERNAL_JOG);
        cells.set_bit(place::JOG_FROM_PANEL, self.active && !external);
        let (mut plus, mut minus) = (0, 0);
        (self.rapid, self.space) = (false, 0);
        if self.active && external {
            (plus, minus) = (cells.six(place::EXTERNAL_PLUS), cells.six(place::EXTERNAL_MINUS));
            self.rapid = cells.bit(place::EXTERNAL_RAPID);
            self.space = usize::from(cells.byte(place::JOG_SPACE).min(6));
        } else if self.active {
            (plus, minus) = (self.panel_plus, self.panel_minus);
            self.rapid = self.panel_rapid;
        }
        // Both directions at once are none.
        (self.plus, self.minus) = (plus & !minus, minus & !plus);
        let selecting = self.active && external && cells.bit(place::EXTERNAL_SELECT);
        cells.set_bit(place::JOG_SELECTING, selecting);
        cells.set_bit(place::JOG_RAPID, self.active && !external && self.panel_rapid);
        cells.set_six(place::JOG_PLUS, self.plus);
        cells.set_six(place::JOG_MINUS, self.minus);
        if selecting {
            // An axis that is only preselected does not move.
            (self.plus, self.minus) = (0, 0);
        }
    }

    /// Nothing is active any more; the keys stay as they are.
    pub(crate) fn end(&mut self) {
        (self.active, self.cancelled, self.plus, self.minus) = (false, false, 0, 0);
    }

    /// What begins and ends manual movement. AUTMAN_REQ does as long as it is 1; AUTMAN_SELECT and AUTMAN_CANCEL do
    /// once, and are cleared whether or not they did something.
    fn switch(&mut self, cells: &mut Cells<'_>) {
        let (begin, end) = (cells.bit(place::JOG_BEGIN), cells.bit(place::JOG_END));
        let level = cells.bit(place::JOG_REQ);
        if begin || end {
            cells.set_bit(place::JOG_BEGIN, false);
            cells.set_bit(place::JOG_END, false);
        }
        self.cancelled &= level;
        if self.active {
            if end || self.by_level && !level {
                self.active = false;
                self.cancelled = level;
            }
        } else if cells.bit(place::JOG_ALLOWED) && !end && (begin || level && !self.cancelled) {
            self.active = true;
            self.by_level = !begin;
        }
    }

    /// Axes that shall move.
    pub(crate) fn moving(&self) -> u16 {
        self.plus | self.minus
    }

    /// Speed of an axis with sign, µm/s; 0: it shall not move. `revolutions` is the speed of the main spindle in
    /// rev/s, for feeds in µm a revolution.
    pub(crate) fn speed(
        &self,
        cells: &Cells<'_>,
        axis: usize,
        settings: &AxisSettings,
        feed: &Feed,
        revolutions: f64,
    ) -> f64 {
        let sign = match (has(self.plus, axis), has(self.minus, axis)) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => return 0.0,
        };
        let external = cells.bit(place::EXTERNAL_JOG);
        let speed = if self.rapid {
            let from_program = external && cells.bit(place::EXTERNAL_RAPID_FEED_REQ);
            let rapid = if from_program {
                per_minute(f64::from(cells.word(place::EXTERNAL_FEED_RAPID)))
            } else {
                settings.rapid
            };
            feed.rapid(rapid, settings.rapid)
        } else {
            let (value, own) = if external && cells.bit(place::EXTERNAL_FEED_REQ) {
                (f64::from(cells.word(place::EXTERNAL_FEED)), false)
            } else {
                (settings.feed * 60.0 / UM, true)
            };
            // With G95 a number of mm/min means µm a revolution.
            let per_revolution = cells.bit(place::JOG_PER_REVOLUTION);
            let speed = match (per_revolution, own) {
                (true, _) => value * revolutions,
                (false, true) => settings.feed,
                (false, false) => per_minute(value),
            };
            feed.working(speed, settings.rapid)
        };
        speed * sign
    }
}
