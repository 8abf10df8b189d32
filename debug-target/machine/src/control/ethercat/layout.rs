//! Where the values of slaves lie in the process image.

use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::MachineConfig;
use crate::compile::Compiler;
use crate::config::{ProcessData, ProcessType, Slave};
use crate::control::elements::{CellType, identifier, names_a_bit};
use crate::signal::{BUS_INPUTS, BUS_OUTPUTS};

/// Objects of drives (CiA 402).
pub(in crate::control) mod object {
    pub(in crate::control) const CONTROL: u16 = 0x6040;
    pub(in crate::control) const STATUS: u16 = 0x6041;
    pub(in crate::control) const ERROR: u16 = 0x603F;
    pub(in crate::control) const POSITION: u16 = 0x6064;
    pub(in crate::control) const TARGET: u16 = 0x607A;
    pub(in crate::control) const SPEED: u16 = 0x60FF;
}

/// The values of a drive unless the description lists others: name, type, object.
const DRIVE_INPUTS: [(&str, ProcessType, u16); 3] = [
    ("Status word", ProcessType::Word, object::STATUS),
    ("Position actual value", ProcessType::Int32, object::POSITION),
    ("Error code", ProcessType::Word, object::ERROR),
];
const DRIVE_OUTPUTS: [(&str, ProcessType, u16); 3] = [
    ("Control word", ProcessType::Word, object::CONTROL),
    ("Target position", ProcessType::Int32, object::TARGET),
    ("Target velocity", ProcessType::Int32, object::SPEED),
];
/// Servo loops with a drive.
const SERVOS: u8 = 16;

/// A value in the image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    /// Its slave, in the order of wiring.
    pub(crate) slave: usize,
    /// Its identifier as written: `ECAT.Valves.Outputs.Clamp`.
    pub(crate) name: String,
    /// The same in the one spelling that is compared.
    pub(crate) id: String,
    /// It goes to the slave.
    pub(crate) output: bool,
    /// Its first byte among those of the bus.
    pub(crate) first: usize,
    /// Its bit, if it is one.
    pub(crate) bit: Option<u8>,
    /// Its bytes.
    pub(crate) bytes: usize,
    /// The object behind it.
    pub(crate) object: Option<u16>,
    kind: ProcessType,
}

impl Line {
    pub(in crate::control) fn cell(&self) -> CellType {
        let int = |signed| CellType::Int { bytes: self.bytes, signed };
        match self.kind {
            ProcessType::Bit => CellType::Bit(self.bit.unwrap_or(0)),
            ProcessType::Real => CellType::Real,
            ProcessType::Int8 | ProcessType::Int16 | ProcessType::Int32 | ProcessType::Int64 => int(true),
            ProcessType::Byte | ProcessType::Word | ProcessType::Dword | ProcessType::Qword => int(false),
        }
    }
}

fn bytes(kind: ProcessType) -> usize {
    match kind {
        ProcessType::Bit | ProcessType::Byte | ProcessType::Int8 => 1,
        ProcessType::Word | ProcessType::Int16 => 2,
        ProcessType::Dword | ProcessType::Int32 => 4,
        ProcessType::Qword | ProcessType::Int64 | ProcessType::Real => 8,
    }
}

/// All values of the slaves; those that lie outside the image are past its end.
pub(crate) fn lines(slaves: &[Slave]) -> Vec<Line> {
    let mut lines = Vec::new();
    for output in [false, true] {
        // The next free byte; bits share the one before it.
        let (mut next, mut bits) = (0, 8);
        for (number, slave) in slaves.iter().enumerate() {
            for data in values(slave, output) {
                let is_bit = data.kind == ProcessType::Bit;
                let bytes = bytes(data.kind);
                let first = if is_bit && bits < 8 {
                    next - 1
                } else {
                    bits = if is_bit { 0 } else { 8 };
                    next += bytes;
                    next - bytes
                };
                let bit = is_bit.then_some(bits);
                bits += u8::from(is_bit);
                let way = if output { "Outputs" } else { "Inputs" };
                let name = format!("ECAT.{}.{way}.{}", slave.name, data.name);
                let id = identifier(name.as_bytes()).unwrap_or_default();
                let (kind, object) = (data.kind, data.object);
                lines.push(Line { slave: number, name, id, output, first, bit, bytes, object, kind });
            }
            // Each slave has bytes of its own.
            bits = 8;
        }
    }
    lines
}

fn values(slave: &Slave, output: bool) -> Vec<ProcessData> {
    let (own, usual) = if output { (&slave.outputs, DRIVE_OUTPUTS) } else { (&slave.inputs, DRIVE_INPUTS) };
    match own {
        Some(own) => own.clone(),
        None if slave.drive => {
            let usual = usual.into_iter();
            usual
                .map(|(name, kind, object)| ProcessData { name: name.into(), kind, object: Some(object) })
                .collect()
        }
        None => Vec::new(),
    }
}

/// Reports what is wrong with names, drives and the length of the image.
pub(in crate::control) fn check(config: &MachineConfig, compiler: &mut Compiler<'_>) {
    let slaves = &config.ethercat;
    let lines = lines(slaves);
    for (n, slave) in slaves.iter().enumerate() {
        compiler.enter("ethercat", Some(n));
        let own: Vec<&Line> = lines.iter().filter(|line| line.slave == n).collect();
        if !slave.name.is_empty()
            && slaves[..n].iter().any(|other| other.name.eq_ignore_ascii_case(&slave.name))
        {
            compiler.error("name", format!("`{}` is used twice; names must differ", slave.name));
        }
        if slave.name.is_empty() && !own.is_empty() {
            compiler.error("name", "is needed: inputs, outputs and drives are named by it");
        }
        let mut known = BTreeSet::new();
        for line in own.iter().filter(|_| !slave.name.is_empty()) {
            let key = if line.output { "outputs" } else { "inputs" };
            if line.id.is_empty() || line.id.ends_with('.') {
                compiler.error(key, format!("`{}` is no identifier: 1 to 255 ASCII characters", line.name));
            } else if names_a_bit(&line.id) {
                let name = &line.name;
                compiler.error(
                    key,
                    format!("`{name}` would mean one bit of a number; give it a name that does not end with `.Bit`"),
                );
            } else if !known.insert(&line.id) {
                compiler.error(key, format!("`{}` is there twice", line.name));
            }
        }
        drive(slave, &slaves[..n], &own, compiler);
    }
    for (output, key, room) in [(false, "inputs", BUS_INPUTS), (true, "outputs", BUS_OUTPUTS)] {
        let too_far = |line: &&Line| line.output == output && line.first + line.bytes > room;
        if let Some(line) = lines.iter().find(too_far) {
            compiler.enter("ethercat", Some(line.slave));
            compiler.error(key, format!("all slaves together have more than {room} bytes of {key}"));
        }
    }
}

fn drive(slave: &Slave, before: &[Slave], own: &[&Line], compiler: &mut Compiler<'_>) {
    let has = |object, output| own.iter().any(|line| line.output == output && line.object == Some(object));
    if slave.drive && !has(object::CONTROL, true) {
        compiler.error("outputs", "a drive needs its control word: one with `object = 0x6040`");
    }
    if slave.drive && !has(object::STATUS, false) {
        compiler.error("inputs", "a drive needs its status word: one with `object = 0x6041`");
    }
    let Some(servo) = slave.servo else { return };
    if !slave.drive {
        compiler.error("servo", "belongs to a drive; add `drive = true`");
    }
    if servo >= SERVOS {
        compiler.error("servo", format!("{servo} is not between 0 and 15"));
    }
    if before.iter().any(|other| other.servo == Some(servo)) {
        compiler.error("servo", format!("the servo loop {servo} has a drive already"));
    }
}
