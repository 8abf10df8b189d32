//! A program and its machine without link and clock.
#![allow(clippy::unwrap_used)] // tests

#[allow(dead_code)] // shared with the session tests
#[path = "session/program.rs"]
mod program;

use std::path::Path;

use program::{COUNT, FEEDBACK, LOAD, STORE, counter};
use technol_runtime::{Resume, RuntimeEvent, TickOutcome};
use technol_target::{Simulation, SimulationError, parse_machine};

const CONTACTOR: &str = "[[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'\non-delay-ms=110\noff-delay-ms=5\n";

fn simulation(machine: &str) -> Simulation {
    let machine = parse_machine(Path::new("machine.toml"), machine).unwrap();
    Simulation::new(counter(), Some(&machine)).unwrap()
}

fn word(simulation: &Simulation, addr: u32) -> u16 {
    let at = addr as usize;
    u16::from_le_bytes(simulation.runtime().memory()[at..at + 2].try_into().unwrap())
}

#[test]
fn a_start_takes_one_tick_and_then_each_cycle_is_twenty_milliseconds() {
    let (mut simulation, mut events) = (simulation(""), Vec::new());
    simulation.start(true);
    assert_eq!(simulation.tick(&mut events), TickOutcome::Done);
    assert_eq!((simulation.runtime().millis(), word(&simulation, COUNT.addr)), (0, 0));
    for cycle in 1..=3 {
        assert_eq!(simulation.cycle(&mut events), TickOutcome::Done);
        assert_eq!(simulation.runtime().millis(), u64::from(cycle) * 20);
        assert_eq!(word(&simulation, COUNT.addr), cycle);
    }
}

#[test]
fn directly_after_a_start_a_cycle_includes_it() {
    let (mut simulation, mut events) = (simulation(""), Vec::new());
    simulation.start(true);
    assert_eq!(simulation.cycle(&mut events), TickOutcome::Done);
    assert_eq!((simulation.runtime().millis(), word(&simulation, COUNT.addr)), (20, 1));
}

#[test]
fn a_plc_that_does_not_run_ends_a_cycle_at_once() {
    let (mut simulation, mut events) = (simulation(CONTACTOR), Vec::new());
    assert_eq!(simulation.cycle(&mut events), TickOutcome::Done);
    assert_eq!((simulation.runtime().millis(), events.len()), (0, 0));
}

#[test]
fn the_machine_answers_an_output_after_its_delay() {
    let (mut simulation, mut events) = (simulation(CONTACTOR), Vec::new());
    simulation.start(true);
    simulation.tick(&mut events);
    let mut on_at = None;
    for ms in 0..200 {
        simulation.tick(&mut events);
        if simulation.inputs()[0] & 1 != 0 && on_at.is_none() {
            on_at = Some(ms);
        }
    }
    // The output goes on in millisecond 0, the contactor sees it in millisecond 1.
    assert_eq!(on_at, Some(111));
    assert_eq!(simulation.runtime().memory()[FEEDBACK.addr as usize] & 1, 1);
}

#[test]
fn a_run_through_break_points_is_a_run_without() {
    let machine = format!("{CONTACTOR}[[block]]\nat-cycle=3\nm=[3]\nmotion-ms=70\n");
    let (mut straight, mut halting) = (simulation(&machine), simulation(&machine));
    let (mut events, mut halting_events) = (Vec::new(), Vec::new());
    straight.start(true);
    halting.start(true);
    halting.runtime_mut().set_breakpoints(&[LOAD, STORE]);
    let mut stops = 0;
    for _ in 0..500 {
        straight.tick(&mut events);
        while halting.tick(&mut halting_events) == TickOutcome::Stopped {
            stops += 1;
            halting.tick(&mut halting_events); // held for a while
            halting.runtime_mut().resume(Resume::Continue);
        }
    }
    assert!(stops >= 48, "{stops}");
    assert_eq!(straight.runtime().state_hash(), halting.runtime().state_hash());
    assert_eq!(straight.inputs(), halting.inputs());
    assert_eq!(events, halting_events);
    assert!(events.iter().any(|e| matches!(e, RuntimeEvent::BlockFinished { .. })), "{events:?}");
}

#[test]
fn a_part_program_longer_than_the_look_ahead_runs_to_its_end() {
    let blocks = "[[block]]\nm=[5]\nmotion-ms=30\n".repeat(29);
    let mut simulation = simulation(&format!("[[block]]\nat-cycle=2\n{blocks}"));
    let mut events = Vec::new();
    simulation.start(true);
    for _ in 0..200 {
        simulation.cycle(&mut events);
    }
    let finished = events.iter().filter(|e| matches!(e, RuntimeEvent::BlockFinished { .. })).count();
    assert_eq!(finished, 30);
    assert!(!events.iter().any(|e| matches!(e, RuntimeEvent::BlockRejected(_))), "{events:?}");
}

#[test]
fn central_annulment_ends_what_is_going_on() {
    let machine = "[[block]]\nat-cycle=2\nmotion-ms=10000\n[[block]]\nmotion-ms=10000\n\
                   [[block]]\nat-cycle=10\nmode='central-annulment'\n";
    let (mut simulation, mut events) = (simulation(machine), Vec::new());
    simulation.start(true);
    for _ in 0..30 {
        simulation.cycle(&mut events);
    }
    let blocks: Vec<_> = events
        .iter()
        .filter_map(|e| match e {
            RuntimeEvent::BlockStarted { .. } => Some("started"),
            RuntimeEvent::BlockAborted { .. } => Some("aborted"),
            RuntimeEvent::BlockFinished { .. } => Some("finished"),
            _ => None,
        })
        .collect();
    assert_eq!(blocks, ["started", "aborted", "started", "finished"]);
}

#[test]
fn m_functions_have_the_groups_of_the_configuration_and_of_the_machine() {
    let machine = "[[m-function]]\nnumber=92\ngroup=12\n[[block]]\nat-cycle=2\nm=[91,92,93]\nmotion-ms=40\n";
    let mut simulation = simulation(machine);
    // M03 cannot be moved, and there is no M100 nor a group 15.
    let m_groups = vec![(91, 10), (92, 11), (3, 4), (100, 10), (93, 15)];
    simulation.set_data(technol_machine::ControlData { m_groups, ..Default::default() });
    simulation.start(true);
    for _ in 0..4 {
        simulation.cycle(&mut Vec::new());
    }
    let pb = |n: usize| simulation.runtime().memory()[technol_image::system::PB00 as usize + n];
    assert_eq!([3, 13, 14, 16].map(pb), [0x91, 0, 0x92, 0x93], "groups 10, 11, 12 and 14");
}

#[test]
fn a_stop_keeps_the_whole_part_program_and_m30_ends_it() {
    let blocks = "[[block]]\nmotion-ms=30\n".repeat(20);
    let machine = format!(
        "[control]\nstop='P2IN.0'\nstart='P2IN.1'\n[[block]]\nat-cycle=2\n{blocks}[[block]]\nm=[30]\n{blocks}\
         [[block]]\nat-cycle=300\nm=[3]\n"
    );
    let (mut simulation, mut events) = (simulation(&machine), Vec::new());
    let finished = |events: &[RuntimeEvent]| {
        events.iter().filter(|e| matches!(e, RuntimeEvent::BlockFinished { .. })).count()
    };
    simulation.start(true);
    for cycle in 0..250 {
        simulation.inputs_mut()[1] = match cycle {
            20 => 1,
            100 => 2,
            _ => 0,
        };
        simulation.cycle(&mut events);
        assert!(!(22..100).contains(&cycle) || finished(&events) < 12, "stopped");
    }
    assert_eq!(finished(&events), 22, "one, twenty and M30");
    for _ in 250..310 {
        simulation.cycle(&mut events);
    }
    assert_eq!(finished(&events), 23, "the next program");
}

#[test]
fn a_program_that_is_not_sound_and_a_machine_that_is_wrong_are_refused() {
    let mut program = counter();
    program.modules[0].end = 1000;
    let refused = Simulation::new(program, None).err().unwrap();
    assert!(matches!(refused, SimulationError::Program(_)), "{refused}");
    let mut machine = technol_machine::MachineConfig::default();
    machine.io.fast_inputs.push("P0IN".into());
    let refused = Simulation::new(counter(), Some(&machine)).err().unwrap();
    let expected =
        "the machine description is wrong: io.fast-inputs: `P0IN` is not an input port; use P1IN to P128IN";
    assert_eq!(refused.to_string(), expected);
}

#[test]
fn the_machine_of_the_lathe_is_sound() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/lathe/machine.toml");
    if let Err(error) = technol_target::load_machine(&path) {
        panic!("{error}");
    }
}
