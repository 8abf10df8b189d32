//! Elements of the control itself that a connection may name: bytes of INOUT08 units, which are ports (manual 9.3), EtherCAT
//! drives of servo loops (manual 13.18.2), and other cells of the interface.

use technol_image::op::Addr;
use technol_image::system::{self, devices};

use super::realtime;
use super::value::CellType;

/// A cell of the control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) addr: Addr,
    pub(super) kind: CellType,
    /// What 1 in the cell is in the unit of the element.
    pub(super) scale: f64,
}

/// The element belongs to the control, whether or not it is simulated.
pub(super) fn is_of_control(name: &str) -> bool {
    ["rtm.", "vkeyboard.", "can["].iter().any(|group| name.starts_with(group))
}

pub(super) const fn int(bytes: usize, signed: bool) -> CellType {
    CellType::Int { bytes, signed }
}

/// Elements of `RTM.Servo[n].Edrv`: name, first cell, type.
const EDRV: [(&str, Addr, CellType); 16] = [
    ("drivestatus", devices::EDRV_STATUS, int(2, false)),
    ("drivepos", devices::EDRV_POSITION, int(4, true)),
    ("driveerrreg", devices::EDRV_ERROR_CODE, int(2, false)),
    ("drivecontrol", devices::EDRV_CONTROL, int(2, false)),
    ("driveposreq", devices::EDRV_TARGET, int(4, true)),
    ("driveveloreq", devices::EDRV_SPEED, int(4, true)),
    ("state", devices::EDRV_STATE, int(1, false)),
    ("scalespeed", devices::EDRV_SCALE, CellType::Real),
    ("movedisreq", devices::EDRV_HOLD.addr, CellType::Bit(0)),
    ("error", devices::EDRV_ERROR.addr, CellType::Bit(0)),
    ("init", devices::EDRV_INIT.addr, CellType::Bit(0)),
    ("on", devices::EDRV_ON.addr, CellType::Bit(0)),
    ("enable", devices::EDRV_ENABLE.addr, CellType::Bit(0)),
    ("disable", devices::EDRV_DISABLE.addr, CellType::Bit(0)),
    ("done", devices::EDRV_DONE.addr, CellType::Bit(0)),
    ("erase", devices::EDRV_ERASE.addr, CellType::Bit(0)),
];

/// The cell behind a normal identifier.
pub(super) fn find(name: &str) -> Option<Cell> {
    if let Some(name) = name.strip_prefix("rtm.") {
        return drive(name).map(plain).or_else(|| realtime::find(name));
    }
    unit(name).map(plain)
}

const fn plain((addr, kind): (Addr, CellType)) -> Cell {
    Cell { addr, kind, scale: 1.0 }
}

/// An element of a drive: `servo[2].edrv.drivestatus`.
fn drive(name: &str) -> Option<(Addr, CellType)> {
    let (servo, rest) = index(name.strip_prefix("servo")?)?;
    let element = rest.strip_prefix(".edrv.")?;
    let (_, first, kind) = EDRV.into_iter().find(|(name, ..)| *name == element)?;
    let servo = u32::from(u8::try_from(servo).ok().filter(|servo| *servo < devices::DRIVES)?);
    Some(match kind {
        CellType::Bit(_) => (first + servo / 8, CellType::Bit((servo % 8) as u8)),
        _ => (first + servo * kind.size(0) as u32, kind),
    })
}

/// A byte of a unit: `can[1].inout08[2].ip0`.
fn unit(name: &str) -> Option<(Addr, CellType)> {
    // Units are on the second channel, `CAN[1]`.
    let (unit, rest) = index(name.strip_prefix("can[1].inout08")?)?;
    let input = rest.strip_prefix(".ip").map(|byte| (byte, 4, 4, system::IN_PORTS));
    let output = || rest.strip_prefix(".op").map(|byte| (byte, 3, 3, system::OUT_PORTS));
    let (byte, bytes, step, first) = input.or_else(output)?;
    let byte: u32 = byte.parse().ok().filter(|byte| *byte < bytes)?;
    (unit < 32).then_some((first + step * unit + byte, int(1, false)))
}

/// An index in brackets, 0 without one, and what follows.
fn index(text: &str) -> Option<(u32, &str)> {
    let Some(inner) = text.strip_prefix('[') else { return Some((0, text)) };
    let (digits, rest) = inner.split_once(']')?;
    Some((digits.parse().ok()?, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_of_the_control_are_cells() {
        for (name, cell) in [
            ("can[1].inout08.ip0", Some((0, int(1, false)))),
            ("can[1].inout08[31].ip3", Some((127, int(1, false)))),
            ("can[1].inout08[2].op1", Some((0x87, int(1, false)))),
            ("can[1].inout08[31].op2", Some((0xDF, int(1, false)))),
            ("can[1].inout08[32].op2", None),
            ("can[1].inout08[1].op3", None),
            ("can.inout08[1].op1", None),
            ("rtm.servo.edrv.drivestatus", Some((0x4A7C, int(2, false)))),
            ("rtm.servo[15].edrv.drivepos", Some((0x4AD8, int(4, true)))),
            ("rtm.servo[9].edrv.error", Some((0x4BAF, CellType::Bit(1)))),
            ("rtm.servo[2].edrv.scalespeed", Some((0x4BCC, CellType::Real))),
            ("rtm.servo[16].edrv.error", None),
            ("rtm.servo[1].edrv.nothing", None),
            ("door", None),
        ] {
            assert_eq!(find(name).map(|cell| (cell.addr, cell.kind)), cell, "{name}");
        }
    }
}
