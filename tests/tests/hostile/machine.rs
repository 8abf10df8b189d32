//! Texts of machine files: read, and what is right is put behind a program.

// Each file of this test uses a part; fuzz targets take the files one by one.
#[allow(dead_code, clippy::duplicate_mod)]
#[path = "../common/families.rs"]
mod families;

use std::path::Path;
use std::sync::LazyLock;

use technol_image::Program;
use technol_image::system;
use technol_machine::CanPacket;
use technol_target::{Simulation, parse_machine};

/// Milliseconds that a machine runs.
const MILLIS: u32 = 300;
/// Keys and faults that are switched: a file may describe any number.
const SWITCHES: usize = 16;

/// The machine files of the examples and of the book, one text each.
pub(crate) fn seeds() -> Vec<String> {
    let book = include_str!("../../../docs/machine.md");
    let blocks = book.split("```toml").skip(1).filter_map(|rest| rest.split("```").next());
    let lathe = include_str!("../../../examples/lathe/machine.toml");
    let seeds: Vec<String> = blocks.chain(EVERY_KEY).chain([lathe]).map(str::to_owned).collect();
    assert!(seeds.len() > 8, "the book shows machine files");
    seeds
}

/// Files that have each key of each table at least once.
pub(crate) const EVERY_KEY: [&str; 3] = [
    include_str!("machines/elements.toml"),
    include_str!("machines/motion.toml"),
    include_str!("machines/buses.toml"),
];

/// The keys of a table, or the tables themselves (`""`), as the reader lists them when it meets another.
#[allow(dead_code)] // the fuzz target has no use for it
pub(crate) fn keys(table: &str) -> Vec<String> {
    let told = [
        format!("{table}\nno-such-key = 1"),
        format!("{}\nno-such-key = 1", table.replace("[[", "[").replace("]]", "]")),
    ];
    let errors = told.iter().filter_map(|text| parse_machine(Path::new("machine.toml"), text).err());
    let message = errors.flatten().map(|error| error.message).find(|message| message.contains("expected"));
    let message = message.unwrap_or_else(|| panic!("{table} takes any key"));
    let (_, listed) = message.split_once("expected").expect("it was looked for");
    listed.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Reads a machine file, and runs what it describes. Answers whether it was right; what is wrong has at least one error with a
/// place in the text.
pub(crate) fn check(text: &str) -> bool {
    match parse_machine(Path::new("machine.toml"), text) {
        Ok(machine) => {
            run(&machine);
            true
        }
        Err(errors) => {
            assert!(!errors.is_empty());
            let lines = text.split('\n').count() as u32;
            for error in errors {
                assert!((1..=lines).contains(&error.line) && error.col > 0, "{error}");
                assert!(!error.message.is_empty());
            }
            false
        }
    }
}

/// A program that talks to all that a machine file can describe: slaves, drives, units, axes, named inputs.
static PROGRAM: LazyLock<Program> = LazyLock::new(families::program);

fn run(machine: &technol_machine::MachineConfig) {
    // What the check lets through can be loaded.
    let mut simulation = match Simulation::new(PROGRAM.clone(), Some(machine)) {
        Ok(simulation) => simulation,
        Err(error) => panic!("{error}"),
    };
    let keys: Vec<String> =
        simulation.plant().keys().map(|(name, _)| name.to_owned()).take(SWITCHES).collect();
    let faults: Vec<String> =
        simulation.plant().faults().map(|(name, _)| name.to_owned()).take(SWITCHES).collect();
    simulation.set_data(families::data());
    simulation.start(true);
    let mut events = Vec::new();
    for millis in 0..MILLIS {
        events.clear();
        simulation.tick(&mut events);
        // Every output is on for a while.
        if millis % 50 == 10 {
            let at = system_output(millis / 50);
            let _ = simulation.runtime_mut().write_memory(at, &[0xFF; 8]);
        }
        if millis % 20 == 3 {
            let control = simulation.control_mut();
            control
                .can_mut()
                .feed(1 + (millis % 40 / 20) as u8, CanPacket::new(0x581, &[0x60, millis as u8]));
            control.serial_mut(1).feed(&[millis as u8; 3]);
        }
        let plant = simulation.plant_mut();
        for name in keys.iter().filter(|_| millis % 30 == 7) {
            plant.press(name, millis % 60 == 7).expect("a key of its own");
        }
        for name in faults.iter().filter(|_| millis % 70 == 9) {
            plant.set_fault(name, millis % 140 == 9).expect("a fault of its own");
        }
    }
    assert_eq!(simulation.runtime().fault(), None, "a machine does not make a program fault");
    let _ = simulation.state_hash();
}

/// Where the cells of some output ports begin.
fn system_output(n: u32) -> u32 {
    system::OUT_PORTS + n * 8
}
