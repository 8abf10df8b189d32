//! What instructions of the program do with axes and outputs (manual 12 and 19).

use technol_image::system::motion as place;

use super::axis::Work;
use super::cells::Cells;
use super::config::AfterRef;
use super::output::{Analog, Role};
use super::ramp::Ramp;
use super::run::{Method, Plan, Run};
use super::unit::{PosControl, PosMode};
use super::units::UM;
use super::{AXES, HELD_AT_ONCE, Motion, Refused, index};

/// Operands of SPI_AX, as the instruction finds them; `None` where the attribute of the axis decides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpiAx {
    /// Speed to the zero pulse in 1/1000 ° per minute; the sign is the direction.
    pub feed1: Option<i16>,
    /// Speed of the additional rotation in 1/1000 ° per minute; its sign does not matter, that of `angle` does.
    pub feed2: Option<i16>,
    /// Additional rotation from the zero pulse in 1/1000 °.
    pub angle: Option<i32>,
    /// Ramp in mm/s² (°/s²).
    pub accel: Option<u16>,
    /// Axis, 1 to 16; that of the last AX_SPI when left out.
    pub axis: Option<u8>,
}

/// A speed of SPI_AX, 1/1000 ° per minute, as 1/1000 °/s.
fn turning(feed: i16) -> f64 {
    f64::from(feed.unsigned_abs()) / 60.0
}

impl Motion {
    /// POS_INIT and POS_INIT_x: the program takes an axis (1 to 16); `space` is where it moves, 0 to 6, 5 when the
    /// instruction names none. POS_STV_ERR is set when it cannot be taken.
    pub fn pos_init(&mut self, cells: &mut Cells<'_>, axis: u8, space: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        let held = (0..AXES).filter(|&n| n != index && self.units[n].held).count();
        let refused = if !matches!(self.axes[index].work, Work::Free | Work::Unit) {
            Some(Refused::Busy)
        } else if !cells.bit(place::LOOP_CLOSED.of(axis - 1)) {
            Some(Refused::LoopOpen)
        } else if held >= HELD_AT_ONCE {
            Some(Refused::TooMany)
        } else {
            None
        };
        if let Some(refused) = refused {
            self.units[index].error = true;
            return Err(refused);
        }
        self.units[index].init(cells, &self.axes[index], space);
        self.axes[index].work = Work::Unit;
        Ok(())
    }

    /// POS_RESET and POS_RESET_x: the axis belongs to the NC again, as soon as it has stopped by its ramp.
    pub fn pos_reset(&mut self, cells: &mut Cells<'_>, axis: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        self.units[index].reset(cells);
        Ok(())
    }

    /// POS_MODE and POS_MODE_x: a motion is prepared. POS_STV_ERR is set when it cannot be.
    pub fn pos_mode(&mut self, cells: &mut Cells<'_>, axis: u8, mode: PosMode) -> Result<(), Refused> {
        let index = index(axis)?;
        if !self.units[index].held {
            self.units[index].error = true;
            return Err(Refused::NotHeld);
        }
        self.units[index].mode(cells, &self.axes[index], mode);
        if mode.accel == 0 { Err(Refused::NoRamp) } else { Ok(()) }
    }

    /// POS_CONTROL and POS_CONTROL_x: speed and enable go to the unit, its state to the status record.
    pub fn pos_control(
        &mut self,
        cells: &mut Cells<'_>,
        axis: u8,
        control: PosControl,
    ) -> Result<(), Refused> {
        let index = index(axis)?;
        self.units[index].control(cells, &self.axes[index], control);
        Ok(())
    }

    /// ANALOG_PORT: the output (1 to 16) that [`Analog::Port`] means from now on.
    pub fn analog_port(&mut self, port: u8) -> Result<(), Refused> {
        self.outputs.active = Some(index(port)?);
        Ok(())
    }

    /// ANALOG: sends a value, cut to -7FFFh to 7FFFh. Without a port, and to an axis that is no spindle, nothing is sent.
    pub fn analog(&mut self, value: i32, to: Analog) -> Result<(), Refused> {
        let spindle = |motion: &Motion, axis: &usize| motion.axes[*axis].work == Work::Spindle;
        let port = match to {
            Analog::Port => self.outputs.active,
            Analog::Axis(Some(number)) => {
                let named = Some(index(number)?).filter(|axis| spindle(self, axis));
                named.or(self.outputs.last.filter(|axis| spindle(self, axis)))
            }
            Analog::Axis(None) => self.outputs.last.filter(|axis| spindle(self, axis)),
            Analog::Main => self.outputs.main.filter(|axis| spindle(self, axis)),
            Analog::Assist => self.outputs.assist.filter(|axis| spindle(self, axis)),
        };
        self.outputs.send(port.ok_or(Refused::NoOutput)?, value);
        Ok(())
    }

    /// ANALOG_SPI: sends a value to an axis (1 to 16) that works as spindle.
    pub fn analog_spi(&mut self, value: i32, axis: u8) -> Result<(), Refused> {
        let axis = index(axis)?;
        if self.axes[axis].work != Work::Spindle {
            return Err(Refused::NoOutput);
        }
        self.outputs.send(axis, value);
        Ok(())
    }

    /// AX_SPI: a rotary axis works as spindle; its position loop is opened.
    pub fn ax_spi(&mut self, cells: &mut Cells<'_>, axis: u8, role: Option<Role>) -> Result<(), Refused> {
        let number = axis;
        let axis = index(axis)?;
        if !matches!(self.axes[axis].work, Work::Free | Work::Spindle) {
            return Err(Refused::Busy);
        }
        if self.axes[axis].work == Work::Free {
            self.outputs.send(axis, 0);
        }
        self.axes[axis].work = Work::Spindle;
        cells.set_bit(place::LOOP_CLOSED.of(number - 1), false);
        self.outputs.assign(axis, role);
        Ok(())
    }

    /// SPI_MAIN: feed per revolution and threads follow this axis; the former main spindle becomes the auxiliary one.
    pub fn spi_main(&mut self, axis: u8) -> Result<(), Refused> {
        self.outputs.make_main(index(axis)?, true);
        Ok(())
    }

    /// SPI_AX: a spindle becomes an axis and goes to its zero pulse. POLOHV is 1 meanwhile.
    pub fn spi_ax(&mut self, cells: &mut Cells<'_>, operands: SpiAx) -> Result<(), Refused> {
        let axis = match operands.axis {
            Some(number) => index(number)?,
            None => self.outputs.last.ok_or(Refused::NoSuchAxis)?,
        };
        if !matches!(self.axes[axis].work, Work::Free | Work::Spindle) {
            return Err(Refused::Busy);
        }
        let settings = &self.axes[axis].settings;
        let of = &settings.reference;
        let speed = operands.feed1.map_or(of.speed_low, turning);
        let after = match operands.angle {
            Some(0) => AfterRef::None,
            Some(_) => AfterRef::Relative,
            None => of.after,
        };
        let plan = Plan {
            method: Method::Pulse,
            switch: of.switch,
            slow_down: false,
            inverted: operands.feed1.map_or(of.inverted, |feed| feed < 0),
            speed,
            speed_low: speed,
            accel: operands.accel.map_or(settings.acceleration, |accel| f64::from(accel) * UM),
            after,
            position_after: operands.angle.map_or(of.position_after, f64::from),
            speed_after: operands.feed2.map_or(of.speed_low, turning),
            null_point: of.null_point,
            override_counts: false,
        };
        self.outputs.send(axis, 0);
        let moved = &mut self.axes[axis];
        // What has turned meanwhile is no position error.
        moved.ramp = Ramp { position: moved.actual, ..moved.ramp };
        moved.work = Work::Run;
        self.runs[axis] = Some(Run::new(plan, true));
        let number = axis as u8;
        cells.set_bit(place::LOOP_CLOSED.of(number), true);
        cells.set_bit(place::ORIENTING.of(number), true);
        super::homing::set(cells, place::HOMING, axis, false);
        Ok(())
    }
}
