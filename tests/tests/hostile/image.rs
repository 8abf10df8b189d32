//! Images that no compiler wrote: any bytes, and real programs whose operations and tables were changed and sealed again, so that
//! they pass the checksum and reach the checks of the runtime, or run.
//!
//! An input is readable by eye: the first byte names a real program, or says that the rest is an image file. Then come the
//! number of changes, six bytes for each, and one byte for everything that a debugger and an operator do while it runs.

// Each file of this test uses a part; fuzz targets take the files one by one.
#[allow(dead_code, clippy::duplicate_mod)]
#[path = "../common/families.rs"]
mod families;

use std::path::Path;
use std::sync::LazyLock;

use serde::Serialize;
use serde::de::DeserializeOwned;
use technol_analysis::project::FileReader;
use technol_image::{Image, Op, Program, Service, container, decode, encode};
use technol_machine::{CanPacket, ElementValue, MachineConfig, Value};
use technol_runtime::{Block, Command, Limits, Resume, TickOutcome};
use technol_target::{Simulation, parse_machine};

/// From here on the first byte says that an image file follows.
pub(crate) const RAW: u8 = 0xC0;
/// Milliseconds that an image runs.
const MILLIS: u32 = 240;
/// A byte of the script acts each so many milliseconds.
const ACTS: u32 = 3;
/// Operations of a pass of a module.
const PER_PASS: u32 = 6_000;
/// Modules of a program that is run: each has its budget, and images may hold any number.
const MODULES: usize = 64;
/// Stops at which the whole state is looked at.
const THOROUGH: usize = 3;
/// Bytes of a change.
const CHANGE: usize = 6;

/// A program of the seeds, with the machine in front of which it is run.
struct Base {
    program: Program,
    machine: Option<MachineConfig>,
}

static BASES: LazyLock<Vec<Base>> = LazyLock::new(|| {
    let mechanisms = families::Lone(include_str!("../common/processor.plc"));
    let lathe = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/lathe");
    let text = std::fs::read_to_string(lathe.join("machine.toml")).expect("the lathe has a machine");
    let machine = parse_machine(Path::new("machine.toml"), &text).expect("it is right");
    let lathe = families::build(&lathe.to_string_lossy(), &Disk);
    vec![
        Base { program: families::program(), machine: None },
        Base { program: lathe, machine: Some(machine) },
        Base { program: families::build("plc.plc", &mechanisms), machine: None },
    ]
});

struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        std::fs::read(path).map_err(|e| e.to_string())
    }
}

/// Number of real programs that inputs begin from.
pub(crate) fn bases() -> usize {
    BASES.len()
}

/// The image file of a real program, as an input.
pub(crate) fn file_of(base: usize) -> Vec<u8> {
    let image = Image { program: BASES[base % BASES.len()].program.clone(), debug: None };
    [vec![RAW], encode(&image)].concat()
}

/// The operations that a real program executes here when nothing of it was changed.
#[allow(dead_code)] // the fuzz target does not count
pub(crate) fn executed(base: usize) -> Vec<Op> {
    let base = &BASES[base % BASES.len()];
    let mut simulation = Simulation::new(base.program.clone(), base.machine.as_ref()).expect("it is real");
    simulation.runtime_mut().set_limits(Limits { per_pass: PER_PASS, ..Limits::default() });
    simulation.runtime_mut().count_statements(true);
    families::furnish(&mut simulation);
    simulation.start(true);
    for millis in 0..MILLIS {
        simulation.tick(&mut Vec::new());
        if millis.is_multiple_of(20) {
            families::feed(&mut simulation, millis / 20);
        }
    }
    simulation.shut_down(&mut Vec::new());
    assert_eq!(simulation.runtime().fault(), None, "a seed runs through");
    families::executed(simulation.runtime())
}

/// The service behind an operation of a real program.
#[allow(dead_code)] // the fuzz target does not count
pub(crate) fn service(base: usize, op: &Op) -> Option<Service> {
    let Op::Service(index) = op else { return None };
    Some(BASES[base % BASES.len()].program.services[usize::from(*index)].service)
}

/// Loads and runs what an input stands for. It must be refused, or run into faults that are told; it must not panic, nor hang.
///
/// Answers whether it was loaded.
pub(crate) fn check(input: &[u8]) -> bool {
    let Some((first, rest)) = input.split_first() else { return false };
    if *first >= RAW {
        let Ok(image) = decode(rest) else { return false };
        return run(image.program, None, &rest[..rest.len().min(64)]);
    }
    let base = &BASES[usize::from(*first) % BASES.len()];
    let mut program = base.program.clone();
    let (changes, script) = changes(rest);
    for change in &changes {
        change.apply(&mut program);
    }
    // Sealed again and read as a file, as if a compiler had written it.
    let bytes = encode(&Image { program, debug: None });
    let image = decode(&bytes).expect("what was sealed can be opened");
    assert_eq!(container::encode_program(&image.program), bytes[14..bytes.len() - 4], "nothing was lost");
    run(image.program, base.machine.as_ref(), script)
}

/// The changes at the beginning of these bytes, and what follows.
fn changes(bytes: &[u8]) -> (Vec<Edit>, &[u8]) {
    let Some((count, bytes)) = bytes.split_first() else { return (Vec::new(), bytes) };
    let len = (usize::from(*count) * CHANGE).min(bytes.len() / CHANGE * CHANGE);
    let (changes, script) = bytes.split_at(len);
    let change = |b: &[u8]| Edit {
        table: b[0],
        how: b[1],
        at: usize::from(u16::from_le_bytes([b[2], b[3]])),
        place: b[4],
        value: b[5],
    };
    (changes.chunks_exact(CHANGE).map(change).collect(), script)
}

/// A change of one entry of one table.
struct Edit {
    table: u8,
    how: u8,
    at: usize,
    place: u8,
    value: u8,
}

impl Edit {
    fn apply(&self, program: &mut Program) {
        match self.table % 24 {
            // Code is most of a program.
            0..=9 => self.list(&mut program.code),
            10 => self.list(&mut program.statements),
            11 => self.list(&mut program.modules),
            12 | 13 => self.list(&mut program.sequences),
            14 => self.list(&mut program.timed),
            15 => self.list(&mut program.messages),
            16..=19 => self.list(&mut program.services),
            20 => self.list(&mut program.procedures),
            21 => self.list(&mut program.initial),
            22 => self.list(&mut program.regions),
            _ if self.how.is_multiple_of(2) => self.list(&mut program.init_finished),
            _ => self.list(&mut program.done_finished),
        }
    }

    fn list<T: Clone + Serialize + DeserializeOwned>(&self, list: &mut Vec<T>) {
        let Some(at) = self.at.checked_rem(list.len()) else { return };
        let other = (at + usize::from(self.value)) % list.len();
        match self.how % 12 {
            0 => drop(list.remove(at)),
            1 => list.swap(at, other),
            2 => list.insert(at, list[other].clone()),
            3 => list[at] = list[other].clone(),
            _ => {
                let mut bytes = postcard::to_allocvec(&list[at]).expect("plain data");
                let place = usize::from(self.place) % bytes.len();
                match self.how % 4 {
                    0 => bytes[place] ^= 1 << (self.value % 8),
                    1 => bytes[place] = self.value,
                    // A number as large as it can be, in place of one byte of the entry.
                    2 => drop(bytes.splice(place..=place, [0xFF, 0xFF, 0xFF, 0xFF, 0x0F])),
                    _ => drop(bytes.splice(place..=place, [self.value | 0x80, self.place, 0])),
                }
                if let Ok(entry) = postcard::from_bytes(&bytes) {
                    list[at] = entry;
                }
            }
        }
    }
}

/// Runs a program for a while with everything that comes from outside; false when it was refused.
fn run(program: Program, machine: Option<&MachineConfig>, script: &[u8]) -> bool {
    if program.modules.len() > MODULES {
        return false;
    }
    let code = program.code.len() as u32;
    let statements = program.statements.clone();
    let Ok(mut simulation) = Simulation::new(program, machine) else { return false };
    simulation.runtime_mut().set_limits(Limits { per_pass: PER_PASS, ..Limits::default() });
    families::furnish(&mut simulation);
    simulation.start(true);
    let mut events = Vec::new();
    let mut script = script.iter().copied().cycle();
    let mut stops = 0;
    for millis in 0..MILLIS {
        events.clear();
        if simulation.tick(&mut events) == TickOutcome::Stopped {
            look(&simulation);
            stops += 1;
            // Looking at everything costs more than running.
            if stops < THOROUGH {
                let _ = simulation.state_hash();
            }
            let over = Resume::StepOver { sequence: None };
            let how = [Resume::Continue, over, Resume::StepInto, Resume::StepOut][stops % 4];
            simulation.runtime_mut().resume(how);
        }
        // New break-points make the tables of the code anew, which costs more than running it.
        if millis % ACTS == 0
            && let Some(byte) = script.next()
        {
            act(&mut simulation, byte, millis, &statements);
        }
        if let Some(fault) = simulation.runtime().fault() {
            assert!(fault.pc < code && !fault.to_string().is_empty(), "{fault:?}");
            // It lives on, and a start is obeyed.
            if millis.is_multiple_of(16) {
                simulation.start(millis.is_multiple_of(32));
            }
        }
    }
    look(&simulation);
    let _ = simulation.state_hash();
    simulation.power_off();
    true
}

/// Everything that a debugger asks of a program that is held.
fn look(simulation: &Simulation) {
    let plc = simulation.runtime();
    if plc.stopped().is_some() {
        assert!(!plc.call_stack().is_empty());
    }
    let memory = plc.memory();
    let control = simulation.control();
    let shared = control.shared().iter().map(|it| (it.value(memory), it.limits(memory)));
    let data = control.data();
    let texts = control.board().transient().chain(control.board().persistent()).map(|it| it.text(data));
    let _ = (plc.registers(), plc.sequences().count(), shared.count(), texts.count());
}

/// What a byte of the script does.
fn act(simulation: &mut Simulation, byte: u8, millis: u32, statements: &[u32]) {
    let plc = simulation.runtime_mut();
    let value = byte >> 4;
    match byte & 15 {
        0 => {
            let every = usize::from(value) + 1;
            drop(plc.set_breakpoints(&statements.iter().copied().step_by(every).collect::<Vec<_>>()));
        }
        1 => drop(plc.set_breakpoints(&[])),
        2 => plc.pause(),
        3 => plc.set_line_by_line(value.is_multiple_of(2)),
        4 => plc.command(Command::StartBlock(Block {
            m: [value, 3, 30].into(),
            motion_ms: 5,
            ..Block::default()
        })),
        5 => plc.command(Command::AbortBlock),
        6 if value == 0 => plc.command(Command::StopPlc { power_off: true }),
        6 if value == 1 => plc.command(Command::Halt),
        6 if value == 2 => plc.command(Command::ClearPlc),
        6 => plc.command(Command::Event(i64::from(value))),
        7 => {
            let mut registers = plc.registers();
            registers.bx =
                [0, 1, 8, 0x7FFF, 0x8000, 0xFFFF, 1 << 31, u32::MAX, u32::MAX - 8][usize::from(value) % 9];
            plc.set_registers(registers);
        }
        8..=11 => {
            // A cell of the program, also one that is meant for the runtime alone.
            let len = plc.memory().len() as u32;
            let addr = (millis.wrapping_mul(2_654_435_761) ^ u32::from(byte)) % len.max(1);
            let _ = plc.write_memory(addr, &[value.wrapping_mul(17)]);
        }
        12 => simulation.inputs_mut()[usize::from(value)] ^= 0xFF,
        13 => {
            let packet = CanPacket::new(0x580 + u16::from(value), &[value; 8]);
            simulation.control_mut().can_mut().feed(1 + value % 2, packet);
            simulation.control_mut().serial_mut(1).feed(&[value; 40]);
        }
        14 => {
            let _ = simulation.control_mut().set_input("Pos[2]", i64::from(value));
            let _ = simulation.control_mut().set_input("inDoor", ElementValue::from(value.is_multiple_of(2)));
            simulation.control_mut().edit_table(0, 0, 1, Value::Int(i64::from(value)));
            simulation.control_mut().select_row(0, usize::from(value) % 3);
        }
        _ => {}
    }
}
