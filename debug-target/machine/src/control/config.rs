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

/// `[ethercat-master]`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Master {
    /// The program starts the cyclic exchange by flEcatStartCyclicOperation, as with EtherCATOPViaPLC = 1.
    pub start_by_program: bool,
}

/// A slave of the EtherCAT master; they stand in the order of wiring.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Slave {
    /// Its name in identifiers: `ECAT.name.Inputs.…`.
    pub name: String,
    /// What it gives in each cycle.
    pub inputs: Option<Vec<ProcessData>>,
    /// What it takes in each cycle.
    pub outputs: Option<Vec<ProcessData>>,
    /// It is a drive.
    pub drive: bool,
    /// Servo loop, 0 to 15, that the drive belongs to.
    pub servo: Option<u8>,
    /// CANopen objects.
    pub object: Vec<Object>,
    /// Registers of its drives.
    pub register: Vec<Register>,
}

/// A value of the process image.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct ProcessData {
    /// Its name in identifiers.
    pub name: String,
    /// Its type.
    #[serde(rename = "type")]
    pub kind: ProcessType,
    /// CANopen object behind it, which tells the values of a drive apart.
    pub object: Option<u16>,
}

/// Type of a value of the process image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProcessType {
    /// A bit; those that follow each other share bytes.
    Bit,
    /// One byte without sign.
    Byte,
    /// Two bytes without sign.
    Word,
    /// Four bytes without sign.
    Dword,
    /// Eight bytes without sign.
    Qword,
    /// One byte with sign.
    Int8,
    /// Two bytes with sign.
    Int16,
    /// Four bytes with sign.
    Int32,
    /// Eight bytes with sign.
    Int64,
    /// A real of eight bytes.
    Real,
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

/// Reports numbers that are out of range, and what is described twice.
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
    repeated("serial", "channel", config.serial.iter().map(|it| it.channel), compiler);
    let units = config.can_unit.iter().map(|it| (it.can, it.group, it.board));
    repeated("can-unit", "board", units, compiler);
    repeated("can-drive", "axis", config.can_drive.iter().map(|it| it.axis), compiler);
    for (n, drive) in config.can_drive.iter().enumerate() {
        objects("can-drive", n, &drive.object, compiler);
    }
    for (n, slave) in config.ethercat.iter().enumerate() {
        objects("ethercat", n, &slave.object, compiler);
        let keys: Vec<_> = slave.register.iter().map(|it| (it.drive, it.idn)).collect();
        if let Some((drive, idn)) = twice(&keys) {
            compiler.enter("ethercat", Some(n));
            compiler.error("register", format!("the register {idn} of drive {drive} is described twice"));
        }
    }
    super::ethercat::layout::check(config, compiler);
}

fn objects(table: &'static str, n: usize, objects: &[Object], compiler: &mut Compiler<'_>) {
    let keys: Vec<_> = objects.iter().map(|it| (it.index, it.subindex)).collect();
    if let Some((index, subindex)) = twice(&keys) {
        compiler.enter(table, Some(n));
        compiler.error("object", format!("the object {index:04X}h:{subindex} is described twice"));
    }
}

fn repeated<T: PartialEq>(
    table: &'static str,
    key: &'static str,
    all: impl Iterator<Item = T>,
    compiler: &mut Compiler<'_>,
) {
    let all: Vec<T> = all.collect();
    for (n, it) in all.iter().enumerate() {
        if let Some(first) = all[..n].iter().position(|other| other == it) {
            compiler.enter(table, Some(n));
            compiler.error(key, format!("{table}[{first}] describes the same; leave one of them"));
        }
    }
}

/// The first that is there twice.
fn twice<T: PartialEq + Copy>(all: &[T]) -> Option<T> {
    all.iter().enumerate().find(|(n, it)| all[..*n].contains(it)).map(|(_, it)| *it)
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
        self.ethercat.set_start_by_program(config.ethercat_master.start_by_program);
        for (place, described) in (0..).zip(&config.ethercat) {
            let Some(slave) = self.ethercat.slave_mut(place) else { break };
            for Object { index, subindex, kind, value, read_only } in &described.object {
                slave.set_object(*index, *subindex, kind.bytes(&value.to_le_bytes()), *read_only);
            }
            for Register { drive, idn, kind, value, read_only } in &described.register {
                slave.set_register(*drive, *idn, kind.bytes(&value.to_le_bytes()), *read_only);
            }
        }
        // What would be an error here was reported when the machine was compiled.
        let _ = self.ethercat.exchange_with(&config.ethercat, &mut self.elements);
    }
}
