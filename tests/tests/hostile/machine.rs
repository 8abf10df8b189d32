//! Texts of machine files: read, and what is right is put behind a program.

use std::path::Path;
use std::sync::LazyLock;

use technol_image::Program;
use technol_image::system;
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
    let seeds: Vec<String> = blocks.chain([lathe]).map(str::to_owned).collect();
    assert!(seeds.len() > 5, "the book shows machine files");
    seeds
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

/// Nothing but the interface: what a machine does then, it does by itself.
static PROGRAM: LazyLock<Program> = LazyLock::new(|| {
    use technol_image::program::{Region, RegionKind};
    Program::without_code(
        String::new(),
        vec![Region { kind: RegionKind::System, start: 0, len: system::LEN }],
    )
});

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
        let plant = simulation.plant_mut();
        for name in keys.iter().filter(|_| millis % 30 == 7) {
            plant.press(name, millis % 60 == 7).expect("a key of its own");
        }
        for name in faults.iter().filter(|_| millis % 70 == 9) {
            plant.set_fault(name, millis % 140 == 9).expect("a fault of its own");
        }
    }
    assert!(simulation.runtime().fault().is_none(), "a program without code does not fault");
    let _ = simulation.state_hash();
}

/// Where the cells of some output ports begin.
fn system_output(n: u32) -> u32 {
    system::OUT_PORTS + n * 8
}
