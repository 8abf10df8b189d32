//! The cyclic exchange of process data between the master and its slaves.

use alloc::format;
use alloc::vec::Vec;

use super::layout::{self, Line, object};
use super::{EcatState, EtherCat};
use crate::config::Slave;
use crate::control::elements::{CellType, Conversion, ElementError, Elements};
use crate::control::state_machine::{State, StateMachine};
use crate::signal::{BUS_INPUTS, BUS_OUTPUTS};

/// A value that is exchanged.
#[derive(Clone, Debug)]
struct Value {
    slave: usize,
    /// The logical element.
    element: usize,
    kind: CellType,
    first: usize,
    object: Option<u16>,
}

/// A drive behind a slave.
#[derive(Clone, Debug, Default)]
pub(super) struct Drive {
    pub(super) machine: StateMachine,
    position: i32,
    /// What it was given in the last exchange.
    control: u16,
    target: Option<i32>,
    speed: i32,
    /// Thousandths of an increment.
    rest: i32,
}

/// The process image, and who it is exchanged with.
#[derive(Clone, Debug)]
pub(super) struct Image {
    inputs: Vec<Value>,
    outputs: Vec<Value>,
    given: [u8; BUS_INPUTS],
    taken: [u8; BUS_OUTPUTS],
}

impl Default for Image {
    fn default() -> Image {
        Image { inputs: Vec::new(), outputs: Vec::new(), given: [0; BUS_INPUTS], taken: [0; BUS_OUTPUTS] }
    }
}

impl Image {
    pub(super) fn is_empty(&self) -> bool {
        self.inputs.is_empty() && self.outputs.is_empty()
    }
}

impl EtherCat {
    /// Takes the process data of described slaves, and links drives to their servo loops.
    pub(in crate::control) fn exchange_with(
        &mut self,
        slaves: &[Slave],
        elements: &mut Elements,
    ) -> Result<(), ElementError> {
        for line in layout::lines(slaves) {
            let room = if line.output { BUS_OUTPUTS } else { BUS_INPUTS };
            if line.first + line.bytes > room {
                continue;
            }
            let element =
                if line.output { elements.bus_input(&line.id)? } else { elements.bus_output(&line.id)? };
            let (slave, kind, first, object) = (line.slave, line.cell(), line.first, line.object);
            let values = if line.output { &mut self.image.outputs } else { &mut self.image.inputs };
            values.push(Value { slave, element, kind, first, object });
            link_servo(&slaves[line.slave], &line, elements)?;
        }
        for (slave, _) in self.slaves.iter_mut().zip(slaves).filter(|(_, described)| described.drive) {
            slave.make_drive();
        }
        Ok(())
    }

    /// What the machine gives the slaves.
    pub(in crate::control) fn set_inputs(&mut self, inputs: &[u8; BUS_INPUTS]) {
        self.image.given = *inputs;
    }

    /// What the slaves were given.
    pub(in crate::control) fn outputs(&self) -> &[u8; BUS_OUTPUTS] {
        &self.image.taken
    }

    /// A millisecond: slaves in SAFE-OPERATIONAL give their inputs, those in OPERATIONAL take their outputs too. What is not
    /// exchanged stays at the master, and is 0 at the slave.
    pub(in crate::control) fn exchange(&mut self, elements: &mut Elements) {
        if self.image.is_empty() {
            return;
        }
        let EtherCat { image, slaves, .. } = self;
        image.taken.fill(0);
        for value in &image.outputs {
            let takes =
                |slave: &&mut super::EcatSlave| slave.state == EcatState::Operational && slave.is_reached();
            if let Some(slave) = slaves.get_mut(value.slave).filter(takes) {
                let size = value.kind.size(0);
                let cell = &mut image.taken[value.first..value.first + size];
                elements.bus_input_bytes(value.element, value.kind, cell);
                if let (Some(drive), Some(object)) = (&mut slave.drive, value.object) {
                    drive.take(object, cell);
                }
            } else if let Some(drive) = slaves.get_mut(value.slave).and_then(|slave| slave.drive.as_mut()) {
                drive.control = 0;
            }
        }
        for drive in slaves.iter_mut().filter_map(|slave| slave.drive.as_mut()) {
            drive.step();
        }
        for value in &image.inputs {
            let gives =
                |slave: &&super::EcatSlave| slave.state >= EcatState::SafeOperational && slave.is_reached();
            let Some(slave) = slaves.get(value.slave).filter(gives) else { continue };
            let own = slave.drive.as_ref().zip(value.object).and_then(|(drive, object)| drive.give(object));
            if let Some(own) = own {
                elements.set_bus_output(value.element, value.kind, &own);
            } else {
                let size = value.kind.size(0);
                let cell = &image.given[value.first..value.first + size];
                elements.set_bus_output(value.element, value.kind, cell);
            }
        }
    }
}

/// Joins a value of a drive with the one of its servo loop, as connections of the configuration would.
fn link_servo(slave: &Slave, line: &Line, elements: &mut Elements) -> Result<(), ElementError> {
    let element = match line.object {
        Some(object::CONTROL) => "DriveControl",
        Some(object::TARGET) => "DrivePosReq",
        Some(object::SPEED) => "DriveVeloReq",
        Some(object::STATUS) => "DriveStatus",
        Some(object::POSITION) => "DrivePos",
        Some(object::ERROR) => "DriveErrReg",
        _ => return Ok(()),
    };
    let Some(servo) = slave.servo.filter(|_| slave.drive) else { return Ok(()) };
    let own = format!("RTM.Servo[{servo}].Edrv.{element}");
    let (source, destination) = if line.output { (&own, &line.name) } else { (&line.name, &own) };
    elements.connect(source, destination, Conversion::default())
}

impl Drive {
    fn take(&mut self, object: u16, cell: &[u8]) {
        let mut all = [0; 4];
        for (place, byte) in all.iter_mut().zip(cell) {
            *place = *byte;
        }
        let value = i32::from_le_bytes(all);
        match object {
            object::CONTROL => self.control = value as u16,
            object::TARGET => self.target = Some(value),
            object::SPEED => self.speed = value,
            _ => {}
        }
    }

    /// A millisecond: an enabled drive stands at its target, or turns at its speed in increments a second.
    fn step(&mut self) {
        self.machine.step(self.control);
        if self.machine.state() != State::Enabled {
            return;
        }
        if let Some(target) = self.target.filter(|_| self.speed == 0) {
            self.position = target;
            return;
        }
        let way = self.speed.wrapping_add(self.rest);
        self.position = self.position.wrapping_add(way / 1000);
        self.rest = way % 1000;
    }

    pub(super) fn give(&self, object: u16) -> Option<[u8; 8]> {
        let value = match object {
            object::STATUS => i64::from(self.machine.status()),
            object::ERROR => i64::from(self.machine.code()),
            object::POSITION => i64::from(self.position),
            _ => return None,
        };
        Some(value.to_le_bytes())
    }
}
