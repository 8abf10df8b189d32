//! The lathe, with and without a debugger: looking at a program does not change what it does.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use technol_analysis::project::FileReader;
use technol_image::{DebugInfo, Program};
use technol_runtime::{Resume, StopReason, TickOutcome};
use technol_target::{Simulation, load_machine};

use crate::plc::build;

const CYCLES: u64 = 300;

struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        std::fs::read(path).map_err(|e| e.to_string())
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("examples").join("lathe")
}

fn built() -> (Program, DebugInfo) {
    let built = build(&Disk, &folder().to_string_lossy());
    (built.image.program, built.image.debug.expect("a build has debug information"))
}

/// The lathe about to execute MODULE_INIT.
fn started(program: &Program) -> Simulation {
    let machine = load_machine(&folder().join("machine.toml")).expect("the lathe's machine");
    let mut simulation = Simulation::new(program.clone(), Some(&machine)).expect("the lathe can be loaded");
    simulation.start(true);
    simulation
}

/// What the state was at the end of each cycle, and how often the program was held.
#[derive(Debug, PartialEq)]
struct Course {
    states: BTreeMap<u64, u64>,
    stops: u32,
}

/// Runs to the end of the last cycle; `go_on` says how to go on from a stop.
fn run(simulation: &mut Simulation, mut go_on: impl FnMut(StopReason) -> Resume) -> Course {
    let mut course = Course { states: BTreeMap::new(), stops: 0 };
    let mut events = Vec::new();
    while simulation.runtime().millis() < CYCLES * 20 {
        match simulation.tick(&mut events) {
            TickOutcome::Stopped => {
                course.stops += 1;
                let stop = simulation.runtime().stopped().expect("it is held");
                assert!(stop.reason != StopReason::Fault, "{:?}", simulation.runtime().fault());
                simulation.runtime_mut().resume(go_on(stop.reason));
            }
            TickOutcome::Done => {
                let now = simulation.runtime().millis();
                if now.is_multiple_of(20) {
                    course.states.insert(now / 20, simulation.runtime().state_hash());
                }
            }
        }
    }
    course
}

fn undisturbed(program: &Program) -> Course {
    run(&mut started(program), |reason| panic!("nothing holds it: {reason:?}"))
}

/// The first cycle at whose end the states differ.
fn first_difference(one: &Course, other: &Course) -> Option<u64> {
    assert!(one.states.len() as u64 >= CYCLES, "{} cycles", one.states.len());
    (0..=CYCLES).find(|cycle| one.states.get(cycle) != other.states.get(cycle))
}

#[test]
fn two_runs_are_the_same() {
    let (program, _) = built();
    assert_eq!(program, built().0, "two builds are the same");
    let course = undisturbed(&program);
    assert_eq!(course, undisturbed(&program));
    let distinct: std::collections::BTreeSet<u64> = course.states.values().copied().collect();
    assert!(distinct.len() as u64 >= CYCLES, "the state changes in every cycle");
}

#[test]
fn stepping_is_the_same_as_running() {
    let (program, _) = built();
    let mut simulation = started(&program);
    simulation.runtime_mut().stop_at_entry();
    let stepped = run(&mut simulation, |_| Resume::StepInto);
    assert!(stepped.stops > 10_000, "{} stops", stepped.stops);
    assert_eq!(first_difference(&undisturbed(&program), &stepped), None);
}

#[test]
fn stepping_over_and_out_is_the_same_as_running() {
    let (program, _) = built();
    let mut simulation = started(&program);
    simulation.runtime_mut().stop_at_entry();
    let mut n = 0;
    let stepped = run(&mut simulation, |_| {
        n += 1;
        match n % 3 {
            0 => Resume::StepOut,
            1 => Resume::StepOver { sequence: None },
            _ => Resume::StepInto,
        }
    });
    assert!(stepped.stops > 1_000, "{} stops", stepped.stops);
    assert_eq!(first_difference(&undisturbed(&program), &stepped), None);
}

#[test]
fn a_run_through_break_points_is_the_same_as_one_without() {
    let (program, debug) = built();
    let mut simulation = started(&program);
    let pcs: Vec<u32> = debug.lines.iter().map(|line| line.pc).collect();
    let set = simulation.runtime_mut().set_breakpoints(&pcs);
    let armed = set.iter().filter(|result| result.is_ok()).count();
    assert!(armed > 300 && armed < pcs.len(), "{armed} of {} lines take one", pcs.len());
    let held = run(&mut simulation, |reason| {
        assert_eq!(reason, StopReason::Breakpoint);
        Resume::Continue
    });
    assert!(held.stops > 10_000, "{} stops", held.stops);
    assert_eq!(first_difference(&undisturbed(&program), &held), None);
}

#[test]
fn pauses_change_nothing() {
    let (program, _) = built();
    let mut simulation = started(&program);
    let mut paused = run_with_pauses(&mut simulation);
    assert!(paused.stops >= 50, "{} stops", paused.stops);
    paused.stops = 0;
    assert_eq!(first_difference(&undisturbed(&program), &paused), None);
}

/// Pauses every 37 ms and lets five more milliseconds of the outside go by each time.
fn run_with_pauses(simulation: &mut Simulation) -> Course {
    let mut course = Course { states: BTreeMap::new(), stops: 0 };
    let mut events = Vec::new();
    let mut due = 37;
    while simulation.runtime().millis() < CYCLES * 20 {
        let now = simulation.runtime().millis();
        if now >= due {
            due = now + 37;
            simulation.runtime_mut().pause();
        }
        if simulation.tick(&mut events) == TickOutcome::Stopped {
            course.stops += 1;
            for _ in 0..5 {
                assert_eq!(simulation.tick(&mut events), TickOutcome::Stopped);
            }
            simulation.runtime_mut().resume(Resume::Continue);
        } else if simulation.runtime().millis().is_multiple_of(20) {
            course.states.insert(simulation.runtime().millis() / 20, simulation.runtime().state_hash());
        }
    }
    course
}
