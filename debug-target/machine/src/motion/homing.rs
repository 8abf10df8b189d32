//! Reference of the axes: who asks for it, who makes it, and in what order the bits change (manual 8.1.23 and 15).

use technol_image::op::BitRef;
use technol_image::system::{self, motion as place};

use technol_runtime::Hold;

use super::axis::Work;
use super::cells::Cells;
use super::run::{Plan, Run};
use super::signals::{has, put};
use super::units::FRACTION;
use super::{Motion, Refused, index};

/// Requests of the operator that may wait for the next tick.
const MAX_REQUESTS: usize = 32;

/// What the operator asks for by the menus of the control.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// The reference of one axis (1 to 16), see [`Motion::home`].
    Home(u8),
    /// References made by the program, a bit an axis.
    HomeByProgram(u16),
    /// The group reference.
    HomeGroup,
    /// Pseudo-reference of an axis.
    PseudoReference(u8),
    /// The bit of an axis in HOMING becomes this.
    Reference(u8, bool),
    /// Central annulment.
    Annul,
    /// The step of the handwheel, in µm.
    WheelStep(u16),
    /// The mode of the independent shift, by turns.
    ShiftMode,
    /// The handwheel shifts, by turns.
    ShiftActive,
}

impl Motion {
    /// The operator asks for something: it is done in the next tick. `false`: too much waits already.
    pub fn ask(&mut self, request: Request) -> bool {
        let room = self.requests.len() < MAX_REQUESTS;
        if room {
            self.requests.push(request);
        }
        room
    }

    /// Does what the operator has asked for; an axis that does not exist is not looked for.
    pub(crate) fn answer(&mut self, cells: &mut Cells<'_>) {
        for request in core::mem::take(&mut self.requests) {
            let _: Result<(), Refused> = match request {
                Request::Home(axis) => self.home(cells, axis),
                Request::PseudoReference(axis) => self.pseudo_reference(cells, axis),
                Request::Reference(axis, valid) => self.simulate_reference(cells, axis, valid),
                Request::HomeByProgram(axes) => {
                    self.home_by_program(cells, axes);
                    Ok(())
                }
                Request::HomeGroup => {
                    self.home_group(cells);
                    Ok(())
                }
                Request::Annul => {
                    self.annul(cells);
                    Ok(())
                }
                Request::WheelStep(step) => {
                    cells.set_word(place::WHEEL_STEP, step);
                    Ok(())
                }
                Request::ShiftMode => {
                    by_turns(cells, place::OFFSET_MODE);
                    Ok(())
                }
                Request::ShiftActive => {
                    by_turns(cells, place::OFFSET_ACTIVE);
                    Ok(())
                }
            };
        }
    }

    /// The operator asks for the reference of one axis (1 to 16). With method 1, or when references go through the
    /// program, the program is asked; else the run begins with the next tick in which the axis is free.
    pub fn home(&mut self, cells: &mut Cells<'_>, axis: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        let reference = &self.axes[index].settings.reference;
        let by_program = reference.method == 1;
        if by_program || reference.via_plc {
            cells.set_bit(place::HOMING_SINGLE, true);
            cells.set_word(place::HOMING_AXES, 1 << index);
            if by_program {
                cells.set_bit(place::HOMING_PLC, true);
            }
        } else {
            self.wanted |= 1 << index;
        }
        Ok(())
    }

    /// The operator asks for references made by the program; `axes` has a bit an axis.
    pub fn home_by_program(&mut self, cells: &mut Cells<'_>, axes: u16) {
        cells.set_word(place::HOMING_AXES, axes);
        cells.set_bit(place::HOMING_PLC, true);
    }

    /// The operator asks for the group reference, which the program makes.
    pub fn home_group(&mut self, cells: &mut Cells<'_>) {
        cells.set_bit(place::HOMING_GROUP, true);
    }

    /// Pseudo-reference: the axis is at zero where it stands, without corrections and software limits.
    pub fn pseudo_reference(&mut self, cells: &mut Cells<'_>, axis: u8) -> Result<(), Refused> {
        let index = index(axis)?;
        let here = self.axes[index].ramp.position;
        self.axes[index].set_zero(here, 0.0);
        set(cells, place::HOMING, index, true);
        set(cells, place::NLC_AXIS_ENABLE, index, false);
        set(cells, place::SLS_REFER, index, false);
        Ok(())
    }

    /// Simulated reference, or with `valid` false the end of a reference: only the bit in HOMING changes.
    pub fn simulate_reference(
        &mut self,
        cells: &mut Cells<'_>,
        axis: u8,
        valid: bool,
    ) -> Result<(), Refused> {
        set(cells, place::HOMING, index(axis)?, valid);
        Ok(())
    }

    /// Requests of this tick.
    pub(crate) fn begin_runs(&mut self, cells: &mut Cells<'_>) {
        let zero = cells.word(place::HOMING_REQ);
        let start = cells.word(place::HOMING_START_REQ) | self.wanted;
        if zero == 0 && start == 0 {
            return;
        }
        for index in 0..self.axes.len() {
            if has(zero, index) {
                let shift = cells.qword(place::REFPOINT_DIST + 8 * index as u32) as f64 / FRACTION;
                let axis = &mut self.axes[index];
                axis.set_zero(axis.ramp.position, axis.settings.reference.null_point + shift);
            }
            if has(start, index) && self.axes[index].work == Work::Free {
                self.begin_run(cells, index);
            }
        }
        if zero != 0 {
            cells.set_word(place::HOMING_REQ, 0);
        }
    }

    fn begin_run(&mut self, cells: &mut Cells<'_>, index: usize) {
        put(&mut self.wanted, index, false);
        let Some(plan) = Plan::reference(&self.axes[index].settings) else {
            // Method 1: only the program can make it.
            set(cells, place::HOMING_START_REQ, index, false);
            return;
        };
        set(cells, place::HOMING, index, false);
        cells.set_bit(system::REFPI, true);
        self.axes[index].work = Work::Run;
        self.runs[index] = Some(Run::new(plan, false));
    }

    /// A run has come to its end.
    pub(crate) fn finish_run(&mut self, cells: &mut Cells<'_>, index: usize) {
        let Some(run) = self.runs[index].take() else { return };
        self.axes[index].work = Work::Free;
        set(cells, place::HOMING, index, true);
        if run.orients {
            cells.set_bit(place::ORIENTING.of(index as u8), false);
        } else {
            set(cells, place::SLS_REFER, index, true);
            set(cells, place::HOMING_START_REQ, index, false);
            self.end_reference(cells);
        }
    }

    /// Breaks off a run; the axis stops by its ramp and has no reference.
    pub(crate) fn break_off(&mut self, cells: &mut Cells<'_>, index: usize) {
        let Some(run) = self.runs[index].take() else { return };
        self.axes[index].work = Work::Free;
        if run.orients {
            cells.set_bit(place::ORIENTING.of(index as u8), false);
        } else {
            set(cells, place::HOMING_START_REQ, index, false);
            self.end_reference(cells);
        }
    }

    /// Central annulment: runs, block and manual movement end; the axes stop by their ramps.
    pub fn annul(&mut self, cells: &mut Cells<'_>) {
        self.wanted = 0;
        for index in 0..self.axes.len() {
            self.break_off(cells, index);
        }
        self.drop_block();
        self.hold = Hold::Go;
    }

    fn end_reference(&self, cells: &mut Cells<'_>) {
        if self.runs.iter().flatten().all(|run| run.orients) {
            cells.set_bit(system::REFPI, false);
        }
    }
}

fn by_turns(cells: &mut Cells<'_>, bit: BitRef) {
    let on = cells.bit(bit);
    cells.set_bit(bit, !on);
}

/// Writes the bit of an axis in a WORD.
pub(crate) fn set(cells: &mut Cells<'_>, at: u32, axis: usize, value: bool) {
    let mut mask = cells.word(at);
    put(&mut mask, axis, value);
    cells.set_word(at, mask);
}
