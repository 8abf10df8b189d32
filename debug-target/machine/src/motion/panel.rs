//! Keys of the operator panel that concern axes and spindles (manual 8.1.11, 12 and 20).

use alloc::format;
use alloc::string::String;

use serde::Deserialize;

use super::{AXES, Direction, Motion, Refused, Request};
use crate::compile::Compiler;

/// What such a key does; axes have the numbers 1 to 16.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PanelKey {
    /// Manual movement as long as it is pressed: the axis, negative in negative direction.
    Jog(i8),
    /// Rapid traverse for it.
    JogRapid,
    /// Preselects an axis for the handwheel.
    SelectAxis(u8),
    /// The handwheel turns by so many steps of KNOB_STEP each time.
    Wheel(i32),
    /// The step of the handwheel is so many µm from now on (KNOB_STEP).
    WheelStep(u16),
    /// Selects the mode of the independent shift, and leaves it again (REQ_ESHIFT).
    ShiftMode,
    /// Lets the handwheel shift, and not any more (ACT_ESHIFT).
    ShiftActive,
    /// Asks for the reference of an axis.
    Home(u8),
    /// Asks for the group reference.
    HomeGroup,
    /// The potentiometer of the feed stands here from now on, in per cent.
    FeedPercent(u8),
    /// The potentiometer of the spindle.
    SpeedPercent(u8),
}

impl PanelKey {
    fn axis(self) -> Option<u8> {
        match self {
            PanelKey::Jog(axis) => Some(axis.unsigned_abs()),
            PanelKey::SelectAxis(axis) | PanelKey::Home(axis) => Some(axis),
            _ => None,
        }
    }

    /// What is wrong with it.
    pub(crate) fn check(self, compiler: &mut Compiler<'_>) {
        if self.axis().is_some_and(|axis| !(1..=AXES as u8).contains(&axis)) {
            compiler.error("panel", "axes have the numbers 1 to 16; `jog` may be negative");
        }
    }

    /// In words.
    pub(crate) fn describe(self) -> String {
        match self {
            PanelKey::Jog(axis) => {
                let way = if axis < 0 { '-' } else { '+' };
                format!("jogs axis {}{way}", axis.unsigned_abs())
            }
            PanelKey::JogRapid => String::from("jogs by rapid traverse"),
            PanelKey::SelectAxis(axis) => format!("preselects axis {axis} for the handwheel"),
            PanelKey::Wheel(steps) => format!("turns the handwheel by {steps}"),
            PanelKey::WheelStep(step) => format!("sets the step of the handwheel to {step} µm"),
            PanelKey::ShiftMode => String::from("selects and leaves the independent shift"),
            PanelKey::ShiftActive => String::from("begins and ends shifting by the handwheel"),
            PanelKey::Home(axis) => format!("asks for the reference of axis {axis}"),
            PanelKey::HomeGroup => String::from("asks for the group reference"),
            PanelKey::FeedPercent(percent) => format!("sets the feed override to {percent} %"),
            PanelKey::SpeedPercent(percent) => format!("sets the spindle override to {percent} %"),
        }
    }
}

impl Motion {
    /// A key of the panel is pressed (`down`) or released.
    ///
    /// # Errors
    /// There is no such axis.
    pub fn panel_key(&mut self, key: PanelKey, down: bool) -> Result<(), Refused> {
        match key {
            PanelKey::Jog(axis) => {
                let way = if axis < 0 { Direction::Minus } else { Direction::Plus };
                self.jog_key(axis.unsigned_abs(), down.then_some(way))?;
            }
            PanelKey::JogRapid => self.jog_rapid(down),
            _ if !down => {}
            PanelKey::SelectAxis(axis) => self.select_key(axis)?,
            PanelKey::Wheel(steps) => self.turn_wheel(steps),
            PanelKey::WheelStep(step) => {
                self.ask(Request::WheelStep(step));
            }
            PanelKey::ShiftMode => {
                self.ask(Request::ShiftMode);
            }
            PanelKey::ShiftActive => {
                self.ask(Request::ShiftActive);
            }
            PanelKey::Home(axis) => {
                self.ask(Request::Home(axis));
            }
            PanelKey::HomeGroup => {
                self.ask(Request::HomeGroup);
            }
            PanelKey::FeedPercent(percent) => self.feed_percent = percent,
            PanelKey::SpeedPercent(percent) => self.speed_percent = percent,
        }
        Ok(())
    }
}
