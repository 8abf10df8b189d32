//! Same inputs, same result: a second run, the other form of execution, and a run from a saved state.
//!
//! `TECHNOL_CYCLES` says how many cycles; `cargo xtask bench` has a million of them done by an optimised build.

use std::collections::BTreeSet;

use technol_runtime::{PlcState, RuntimeEvent};
use technol_target::Simulation;

use crate::lathe;

/// Five rounds of all faults and keys.
const CYCLES: u64 = 10_000;
const CYCLES_PER_SECOND: u64 = 50;

fn cycles() -> u64 {
    match std::env::var("TECHNOL_CYCLES") {
        Ok(text) => text.parse().expect("TECHNOL_CYCLES is a number"),
        Err(_) => CYCLES,
    }
}

/// Runs up to a cycle. Gives the state after each second, and what happened, in words, if anybody wants to know.
fn run(simulation: &mut Simulation, from: u64, to: u64, mut happened: impl FnMut(&RuntimeEvent)) -> Vec<u64> {
    let mut events = Vec::new();
    let mut seconds = Vec::new();
    for cycle in from..to {
        lathe::act(simulation, cycle);
        simulation.cycle(&mut events);
        events.drain(..).for_each(|event| happened(&event));
        if (cycle + 1) % CYCLES_PER_SECOND == 0 {
            seconds.push(simulation.state_hash());
        }
    }
    seconds
}

fn first_difference(one: &[u64], other: &[u64]) -> Option<usize> {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).position(|(a, b)| a != b)
}

#[test]
fn the_lathe_does_the_same_again_in_both_forms_and_from_a_saved_state() {
    let cycles = cycles();
    let (mut messages, mut blocks, mut other) = (BTreeSet::new(), 0, Vec::new());
    let mut first = lathe::started();
    let reference = run(&mut first, 0, cycles, |event| match event {
        RuntimeEvent::Message { number, .. } => drop(messages.insert(*number)),
        RuntimeEvent::BlockFinished { .. } => blocks += 1,
        RuntimeEvent::Fault(fault) => other.push(format!("{fault:?}")),
        _ => {}
    });
    // What is compared is worth comparing: much happens, and no second is like another.
    assert_eq!(first.runtime().state(), PlcState::Running, "{other:?}");
    assert!(messages.len() >= 4 && blocks >= 6, "messages {messages:?}, {blocks} blocks");
    assert_eq!(reference.iter().collect::<BTreeSet<_>>().len() as u64, cycles / CYCLES_PER_SECOND);

    let again = run(&mut lathe::started(), 0, cycles, |_| {});
    assert_eq!(first_difference(&reference, &again), None, "second of a second run");

    let mut slow = lathe::started();
    slow.runtime_mut().set_line_by_line(true);
    let slow = run(&mut slow, 0, cycles, |_| {});
    assert_eq!(first_difference(&reference, &slow), None, "second of a run line by line");

    // In the middle of a second, of a block and of faults.
    let half = cycles / 2 + 417;
    let mut original = lathe::started();
    run(&mut original, 0, half, |_| {});
    let saved = original.clone();
    run(&mut original, half, cycles, |_| {});
    drop(original);
    let mut continued = saved;
    let rest = run(&mut continued, half, cycles, |_| {});
    let skipped = (half / CYCLES_PER_SECOND) as usize;
    assert_eq!(first_difference(&reference[skipped..], &rest), None, "second of a run from a saved state");
}

#[test]
fn the_state_hash_tells_states_apart_that_memory_does_not() {
    let mut simulation = lathe::started();
    run(&mut simulation, 0, 150, |_| {});
    let hash = simulation.state_hash();
    assert_eq!(simulation.clone().state_hash(), hash);
    let differs = |what: &str, change: &dyn Fn(&mut Simulation)| {
        let mut other = simulation.clone();
        change(&mut other);
        assert_ne!(other.state_hash(), hash, "{what}");
    };
    differs("a fault of the machine", &|s| s.plant_mut().set_fault("turret-jammed", true).unwrap());
    differs("a key", &|s| s.plant_mut().press("pedal", true).unwrap());
    differs("an input that nothing drives", &|s| s.inputs_mut()[100] = 1);
    differs("a queued event", &|s| s.runtime_mut().command(technol_runtime::Command::Event(1)));
    differs("a byte of memory", &|s| {
        let last = s.runtime().memory().len() as u32 - 1;
        let byte = s.runtime().memory()[last as usize];
        s.runtime_mut().write_memory(last, &[byte ^ 1]).unwrap();
    });
    differs("a register", &|s| {
        let registers = s.runtime().registers();
        s.runtime_mut().set_registers(technol_runtime::Registers { dr: registers.dr ^ 1, ..registers });
    });
    let breakpoint = simulation.runtime().program().statements[10];
    let mut watched = simulation.clone();
    let _ = watched.runtime_mut().set_breakpoints(&[breakpoint]);
    assert_eq!(watched.state_hash(), hash, "looking changes nothing");
}
