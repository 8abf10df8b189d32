//! The lathe of `examples/`, built.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};
use technol_image::Image;
use technol_machine::MachineConfig;
use technol_target::{Simulation, load_machine};

struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        std::fs::read(path).map_err(|e| e.to_string())
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("examples").join("lathe")
}

/// The program with its debug information.
pub(crate) fn image() -> &'static Image {
    static IMAGE: OnceLock<Image> = OnceLock::new();
    IMAGE.get_or_init(|| {
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load(&folder().to_string_lossy(), &Disk)), texts: Vec::new() });
        let built = host.analysis().build().expect("nothing cancels it");
        built.unwrap_or_else(|findings| panic!("the lathe cannot be built: {findings:?}")).image
    })
}

pub(crate) fn machine() -> MachineConfig {
    load_machine(&folder().join("machine.toml")).expect("the lathe's machine")
}

/// The lathe about to execute MODULE_INIT.
pub(crate) fn started() -> Simulation {
    let mut simulation =
        Simulation::new(image().program.clone(), Some(&machine())).expect("the lathe can be loaded");
    simulation.start(true);
    simulation
}

/// What the operator does and what breaks, over and over: cycle within the round, name, on or off.
const ROUND: &[(u64, Act)] = &[
    (400, Act::Fault("ccw-contactor-dead", true)),
    (430, Act::Key("start", true)),
    (440, Act::Key("start", false)),
    (600, Act::Fault("ccw-contactor-dead", false)),
    (610, Act::Key("acknowledge", true)),
    (620, Act::Key("acknowledge", false)),
    (700, Act::Key("next-tool", true)),
    (705, Act::Key("next-tool", false)),
    (720, Act::Fault("turret-jammed", true)),
    (900, Act::Fault("turret-jammed", false)),
    (905, Act::Key("acknowledge", true)),
    (915, Act::Key("acknowledge", false)),
    (950, Act::Key("coolant", true)),
    (960, Act::Key("coolant", false)),
    (1000, Act::Key("start", true)),
    (1010, Act::Key("start", false)),
    (1100, Act::Fault("cw-contactor-welded", true)),
    (1180, Act::Key("stop", true)),
    (1190, Act::Key("stop", false)),
    (1300, Act::Fault("cw-contactor-welded", false)),
    (1310, Act::Key("emergency-stop", true)),
    (1330, Act::Key("emergency-stop", false)),
    (1340, Act::Key("acknowledge", true)),
    (1350, Act::Key("acknowledge", false)),
    (1400, Act::Key("pedal", true)),
    (1420, Act::Key("pedal", false)),
    (1500, Act::Fault("no-lubrication", true)),
    (1900, Act::Fault("no-lubrication", false)),
    (1950, Act::Key("acknowledge", true)),
    (1960, Act::Key("acknowledge", false)),
];

/// Cycles of a round; a multiple of neither a second nor anything in the program.
const ROUND_CYCLES: u64 = 2_011;

#[derive(Clone, Copy, Debug)]
enum Act {
    Fault(&'static str, bool),
    Key(&'static str, bool),
}

/// Does what is due before a cycle; fixed, so the same in every run.
pub(crate) fn act(simulation: &mut Simulation, cycle: u64) {
    let due = ROUND.iter().filter(|(at, _)| *at == cycle % ROUND_CYCLES);
    for (_, act) in due {
        let plant = simulation.plant_mut();
        match *act {
            Act::Fault(name, on) => plant.set_fault(name, on),
            Act::Key(name, down) => plant.press(name, down),
        }
        .expect("the lathe has this fault or key");
    }
}
