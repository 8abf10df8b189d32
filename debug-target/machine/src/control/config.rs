//! What is connected to the buses, as `machine.toml` says it.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use super::SimulatedControl;
use crate::compile::Compiler;
use crate::config::MachineConfig;

/// `[licences]`: the hardware key.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Licences {
    /// It is plugged in.
    pub key: bool,
    /// Numbers of the licences it holds, 0 to 9.
    pub features: Vec<u8>,
}

/// A logical channel of serial ports.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Serial {
    /// Its number.
    pub channel: u8,
    /// Bits a second; 9600 unless given.
    pub baud: Option<u32>,
    /// A real serial device at the other end, for a target that runs in real time; without it the line leads nowhere.
    pub port: Option<String>,
}

/// A unit of the control on the CAN bus.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct CanUnit {
    /// Channel, 1 or 2.
    pub can: u8,
    /// Group, 1 to 3.
    pub group: u8,
    /// Number in the group, 1 to 32.
    pub board: u8,
}

/// The CAN drive of an axis.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct CanDrive {
    /// Axis, 1 to 16.
    pub axis: u8,
    /// NODE-ID, 1 to 127; the number of the axis unless given.
    pub node: Option<u8>,
    /// What it holds.
    #[serde(default)]
    pub object: Vec<Object>,
}

/// A slave of the EtherCAT master; they stand in the order of wiring.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Slave {
    /// CANopen objects.
    pub object: Vec<Object>,
    /// Registers of its drives.
    pub register: Vec<Register>,
}

/// An object of CANopen.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Object {
    /// Index.
    pub index: u16,
    /// Subindex.
    #[serde(default)]
    pub subindex: u8,
    /// Length.
    #[serde(rename = "type")]
    pub kind: Kind,
    /// Value at power-on, cut to its length.
    #[serde(default)]
    pub value: i64,
    /// It cannot be written.
    #[serde(default)]
    pub read_only: bool,
}

/// A register of SERCOS.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Register {
    /// Drive in the slave.
    #[serde(default)]
    pub drive: u8,
    /// Number; bit 15 is set for the P class.
    pub idn: u16,
    /// Length.
    #[serde(rename = "type")]
    pub kind: Kind,
    /// Value at power-on, cut to its length.
    #[serde(default)]
    pub value: i64,
    /// It cannot be written.
    #[serde(default)]
    pub read_only: bool,
}

/// Length of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// One byte.
    Byte,
    /// Two bytes.
    Word,
    /// Four bytes.
    Dword,
    /// Eight bytes.
    Qword,
}

impl Kind {
    fn bytes(self, value: &[u8; 8]) -> &[u8] {
        &value[..match self {
            Kind::Byte => 1,
            Kind::Word => 2,
            Kind::Dword => 4,
            Kind::Qword => 8,
        }]
    }
}

/// Reports numbers that are out of range.
pub(crate) fn check(config: &MachineConfig, compiler: &mut Compiler<'_>) {
    let mut range = |table, index, key, value: usize, min: usize, max: usize| {
        if !(min..=max).contains(&value) {
            compiler.enter(table, index);
            compiler.error(key, format!("{value} is not between {min} and {max}"));
        }
    };
    for feature in &config.licences.features {
        range("licences", None, "features", usize::from(*feature), 0, 9);
    }
    for (n, unit) in config.can_unit.iter().enumerate() {
        range("can-unit", Some(n), "can", unit.can.into(), 1, 2);
        range("can-unit", Some(n), "group", unit.group.into(), 1, 3);
        range("can-unit", Some(n), "board", unit.board.into(), 1, 32);
    }
    for (n, drive) in config.can_drive.iter().enumerate() {
        range("can-drive", Some(n), "axis", drive.axis.into(), 1, 16);
        range("can-drive", Some(n), "node", drive.node.unwrap_or(1).into(), 1, 127);
    }
    range("ethercat", None, "", config.ethercat.len(), 0, 256);
}

impl SimulatedControl {
    /// Connects what a machine describes.
    pub(crate) fn connect_buses(&mut self, config: &MachineConfig) {
        self.licences.connect_key(config.licences.key);
        for feature in &config.licences.features {
            self.licences.set_feature(*feature, true);
        }
        for port in &config.serial {
            self.serial_mut(port.channel).set_baud(port.baud.unwrap_or(9600));
        }
        for unit in &config.can_unit {
            self.can_unit_mut(unit.can, unit.group, unit.board);
        }
        for described in &config.can_drive {
            let drive = self.can_drive_mut(described.axis);
            drive.set_node(described.node.unwrap_or(described.axis));
            for Object { index, subindex, kind, value, read_only } in &described.object {
                drive.set_object(*index, *subindex, kind.bytes(&value.to_le_bytes()), *read_only);
            }
        }
        for (place, described) in (0..).zip(&config.ethercat) {
            let Some(slave) = self.ethercat.slave_mut(place) else { return };
            for Object { index, subindex, kind, value, read_only } in &described.object {
                slave.set_object(*index, *subindex, kind.bytes(&value.to_le_bytes()), *read_only);
            }
            for Register { drive, idn, kind, value, read_only } in &described.register {
                slave.set_register(*drive, *idn, kind.bytes(&value.to_le_bytes()), *read_only);
            }
        }
    }
}
