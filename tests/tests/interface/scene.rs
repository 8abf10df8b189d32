//! A machine, a program that does next to nothing, and what is done to its interface.

use std::path::Path;
use std::rc::Rc;

use technol_analysis::expression::{self, Assignment};
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};
use technol_image::DebugInfo;
use technol_image::system;
use technol_runtime::Command;
use technol_target::{Simulation, parse_machine};

use crate::frame;

/// Cells of the program.
const DATA: &str = "FLAGS: DFM GO";
/// Bytes that every symbol lies in.
const SYSTEM: usize = system::LEN as usize;

/// Something to look at for so many cycles.
pub(crate) struct Scene {
    pub(crate) name: &'static str,
    /// `machine.toml`.
    pub(crate) machine: String,
    /// Lines of MODULE_INIT and MODULE_MAIN, separated by ` / `.
    pub(crate) init: String,
    pub(crate) main: String,
    /// `cycle: act act …`, a line each: `NAME=VALUE` by the program or debugger, `+key` and `-key`, `go`, `halt`,
    /// `fault=name` and `mended=name`.
    pub(crate) script: String,
    pub(crate) cycles: u32,
    /// What is done before the PLC starts, and before each cycle.
    pub(crate) before: fn(&mut Simulation),
    pub(crate) also: fn(&mut Simulation, u32),
}

impl Scene {
    pub(crate) fn new(name: &'static str, cycles: u32) -> Scene {
        Scene {
            name,
            machine: String::new(),
            init: String::new(),
            main: String::new(),
            script: String::new(),
            cycles,
            before: |_| (),
            also: |_, _| (),
        }
    }
}

/// What happened.
pub(crate) struct Track<'s> {
    /// The system region and what left the control, after each millisecond.
    moments: Vec<(Vec<u8>, Outside)>,
    /// As the PLC has started.
    begin: Play<'s>,
    /// State of control and machine at the end.
    end: (u64, u64),
    /// Bits of the system region that changed within a millisecond.
    pub(crate) moved: Vec<u8>,
}

/// What can be seen from outside.
#[derive(PartialEq)]
struct Outside {
    outputs: Vec<u8>,
    analog: Vec<i16>,
    events: usize,
    saved: u64,
}

/// Bits that have other values than they would, at the beginning of each millisecond.
pub(crate) struct Force<'f> {
    /// From this millisecond on.
    pub(crate) from: u32,
    /// Byte, mask and value.
    pub(crate) bits: &'f [(usize, u8, u8)],
}

struct OneFile(String);

impl FileReader for OneFile {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if path == "plc.plc" { Ok(self.0.clone().into_bytes()) } else { Err("no such file".to_owned()) }
    }
}

/// A scene that is being played.
#[derive(Clone)]
struct Play<'s> {
    scene: &'s Scene,
    simulation: Simulation,
    debug: Rc<DebugInfo>,
    events: usize,
}

impl Scene {
    fn begin(&self) -> Play<'_> {
        let lines = |text: &str| text.split(" / ").map(line).collect::<String>();
        let source = frame::program(DATA, &lines(&self.main), &lines(&self.init));
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load("plc.plc", &OneFile(source))), texts: Vec::new() });
        let built = host.analysis().build().expect("nothing cancels it");
        let image = built.unwrap_or_else(|findings| panic!("{}: {findings:?}", self.name)).image;
        let machine = parse_machine(Path::new("machine.toml"), &self.machine)
            .unwrap_or_else(|error| panic!("{}: {error:?}", self.name));
        let mut simulation = Simulation::new(image.program, Some(&machine)).expect("a machine");
        (self.before)(&mut simulation);
        let debug = image.debug.expect("a build has debug information").into();
        Play { scene: self, simulation, debug, events: 0 }
    }

    pub(crate) fn run(&self) -> Track<'_> {
        let mut play = self.begin();
        let mut moved = vec![0; SYSTEM];
        play.simulation.start(true);
        let before = play.initial();
        play.tick();
        mark_changes(&mut moved, &before, play.memory());
        let mut track = Track { moments: Vec::new(), begin: play.clone(), end: (0, 0), moved };
        for millis in 0..self.cycles * 20 {
            play.act(millis);
            let before = play.memory().to_vec();
            play.tick();
            let after = play.memory().to_vec();
            mark_changes(&mut track.moved, &before, &after);
            track.moments.push((after, play.outside()));
        }
        assert_eq!(play.simulation.runtime().fault().map(|fault| fault.kind), None, "{}", self.name);
        track.end = play.end();
        track
    }

    /// What it has come to at its end.
    pub(crate) fn played(&self) -> Simulation {
        let mut play = self.begin();
        play.simulation.start(true);
        play.tick();
        for millis in 0..self.cycles * 20 {
            play.act(millis);
            play.tick();
        }
        play.simulation
    }
}

impl Track<'_> {
    /// The same happens while some bits are forced, these bits apart.
    pub(crate) fn is_the_same_with(&self, force: &Force<'_>) -> bool {
        let mut play = self.begin.clone();
        for (millis, (memory, outside)) in (0..).zip(&self.moments) {
            play.act(millis);
            if millis >= force.from {
                play.force(force);
            }
            play.tick();
            let mut now = play.memory().to_vec();
            for (at, mask, _) in force.bits {
                now[*at] = now[*at] & !mask | memory[*at] & mask;
            }
            if now != *memory || play.outside() != *outside {
                return false;
            }
        }
        play.end() == self.end
    }
}

/// A label stands at the start of its line, an instruction does not.
fn line(text: &str) -> String {
    let text = text.trim();
    if text.ends_with(':') { format!("{text}\n") } else { format!("  {text}\n") }
}

/// Most of it never changes.
fn mark_changes(moved: &mut [u8], before: &[u8], after: &[u8]) {
    const PART: usize = 256;
    let parts = before.chunks(PART).zip(after.chunks(PART)).enumerate();
    for (nth, (before, after)) in parts.filter(|(_, (before, after))| before != after) {
        for (moved, (before, after)) in moved[nth * PART..].iter_mut().zip(before.iter().zip(after)) {
            *moved |= before ^ after;
        }
    }
}

impl Play<'_> {
    /// Memory as the image has it; what the control writes at power-on comes on top.
    fn initial(&self) -> Vec<u8> {
        let alone = Simulation::new(self.simulation.runtime().program().clone(), None).expect("a program");
        alone.runtime().memory()[..SYSTEM].to_vec()
    }

    fn memory(&self) -> &[u8] {
        &self.simulation.runtime().memory()[..SYSTEM]
    }

    fn outside(&self) -> Outside {
        Outside {
            outputs: self.simulation.runtime().outputs().to_vec(),
            analog: self.simulation.control().motion().outputs().to_vec(),
            events: self.events,
            saved: self.simulation.control().times_saved(),
        }
    }

    fn end(&self) -> (u64, u64) {
        (self.simulation.control().state_hash(), self.simulation.plant().state_hash())
    }

    fn tick(&mut self) {
        let mut events = Vec::new();
        self.simulation.tick(&mut events);
        self.events += events.len();
    }

    fn force(&mut self, force: &Force<'_>) {
        for (at, mask, value) in force.bits {
            let byte = self.memory()[*at] & !mask | value & mask;
            self.simulation.runtime_mut().write_memory(*at as u32, &[byte]).expect("a byte");
        }
    }

    /// What the script does in a cycle, somewhere in its middle: an operator does not know of cycles.
    fn act(&mut self, millis: u32) {
        if millis % 20 != 7 {
            return;
        }
        let (scene, cycle) = (self.scene, millis / 20);
        let mine = scene.script.lines().filter_map(|line| line.split_once(':'));
        let mine = mine.filter(|(number, _)| number.trim().parse() == Ok(cycle));
        for word in mine.flat_map(|(_, acts)| acts.split_whitespace()) {
            self.one(word);
        }
        (scene.also)(&mut self.simulation, cycle);
    }

    fn one(&mut self, word: &str) {
        if word == "go" || word == "halt" {
            let stop = Command::StopBlock { emergency: false };
            self.simulation.runtime_mut().command(if word == "go" { Command::ContinueBlock } else { stop });
        } else if let Some(name) = word.strip_prefix("fault=") {
            self.simulation.plant_mut().set_fault(name, true).expect("a fault");
        } else if let Some(name) = word.strip_prefix("mended=") {
            self.simulation.plant_mut().set_fault(name, false).expect("a fault");
        } else if let Some((key, down)) =
            word.strip_prefix('+').map(|key| (key, true)).or(word.strip_prefix('-').map(|key| (key, false)))
        {
            self.simulation.plant_mut().press(key, down).expect("a key");
        } else {
            self.set(word);
        }
    }

    fn set(&mut self, text: &str) {
        let (name, value) = text.split_once('=').unwrap_or_else(|| panic!("NAME=VALUE: {text}"));
        let target =
            expression::resolve(&self.debug, Some(0), name).unwrap_or_else(|e| panic!("{text}: {e}"));
        let target = target.in_memory(self.simulation.runtime().program());
        let runtime = self.simulation.runtime_mut();
        match target.assign(value).unwrap_or_else(|e| panic!("{text}: {e}")) {
            Assignment::Bit { addr, bit, value } => runtime.write_bit(addr, bit, value),
            Assignment::Memory { addr, bytes } => runtime.write_memory(addr, &bytes),
            Assignment::Registers(_) => panic!("{text}: no register"),
        }
        .unwrap_or_else(|e| panic!("{text}: {e}"));
    }
}
