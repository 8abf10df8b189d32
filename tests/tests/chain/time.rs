//! Timers, counters and time blocks (manual 3.11), cycle by cycle.

use crate::coverage::with_mutants;
use crate::plc::Plc;

/// What holds after each cycle.
#[track_caller]
fn follow(given: &str, lines: &str, after: &[&str]) {
    with_mutants(|| {
        let mut plc = Plc::of(lines);
        plc.set(given);
        for (cycle, expected) in after.iter().enumerate() {
            plc.run(1);
            assert_eq!(plc.differences(expected), [""; 0], "{lines}, after cycle {cycle}");
        }
        assert_eq!(plc.fault(), None);
    });
}

#[test]
fn a_timer_is_on_once_its_condition_has_lasted() {
    let lines = "LDR I0 / LOD CNST.3 / TM B1 / WR O0";
    follow("I0=1", lines, &["O0=0 B1=1", "O0=0 B1=2", "O0=0 B1=3", "O0=1 B1=3", "O0=1 B1=3"]);
    follow("I0=0 B1=2", lines, &["O0=0 B1=0", "O0=0 B1=0"]);
    follow("I0=1 W1=0FFFEh", "LDR I0 / LOD CNST.-1 / TM W1 / WR O0", &["O0=0 W1=0FFFFh", "O0=1 W1=0FFFFh"]);
    for automatic in ["-", "NIL"] {
        let lines = format!("LDR I0 / LOD CNST.2 / TM {automatic} / WR O0");
        follow("I0=1", &lines, &["O0=0", "O0=0", "O0=1"]);
    }
}

#[test]
fn counters_and_timers_are_as_wide_as_their_cell() {
    let timer = |cell: &str, preset: &str| format!("LDR I0 / LOD CNST.{preset} / TM {cell} / WR O0");
    follow("I0=1 B2=5", &timer("B1", "3"), &["O0=0 B1=1 B2=5", "O0=0 B1=2 B2=5"]);
    follow("I0=1 W1=0FFh", &timer("W1", "100h"), &["O0=0 W1=100h", "O0=1 W1=100h"]);
    // Unsigned; a preset of 0 is over at once, without it the counter is cleared.
    follow("I0=1 W1=8000h", &timer("W1", "7FFFh"), &["O0=1 W1=8000h"]);
    follow("I0=1 B1=7Fh", &timer("B1", "80h"), &["O0=0 B1=80h", "O0=1 B1=80h"]);
    follow("I0=1", &timer("B1", "0"), &["O0=1 B1=0"]);
    follow("W1=7", &timer("W1", "0"), &["O0=0 W1=0"]);
    let counter = |count: &str| format!("{TOGGLE} / LOD CNST.3 / {count} / WR O0");
    follow("B2=5", &counter("CD B1"), &["B1=0FFh B2=5"]);
    follow("B1=0FFh B2=5", &counter("CU B1"), &["B1=0 B2=5"]);
    follow("B1=99h B2=5", &counter("CUBCD B1"), &["B1=0 B2=5"]);
    follow("W1=0FFh", &counter("CU W1"), &["W1=100h"]);
    follow("W1=9", &counter("CU W1"), &["W1=0Ah"]);
    follow("W1=99h", &counter("CUBCD W1"), &["W1=100h DR64=100h"]);
    follow("W1=9999h", &counter("CUBCD W1"), &["W1=0"]);
    follow("W1=100h", &counter("CD W1"), &["W1=0FFh DR64=0FFh"]);
    // DR is what LOD would load.
    follow("B1=7Fh", &counter("CU B1"), &["B1=80h O0=0 DR64=-128"]);
}

/// O7 is 1, 0, 1, 0, … from the first cycle on.
const TOGGLE: &str = "LDR -O7 / WR O7 / LDR O7";

#[test]
fn counters_count_rising_edges() {
    let up = format!("{TOGGLE} / LOD CNST.2 / CU W1 / WR O0");
    follow("", &up, &["W1=1 O0=0 DR64=1", "W1=1 O0=0", "W1=2 O0=1 DR64=2", "W1=2 O0=1", "W1=3 O0=0"]);
    follow("B1=255", &format!("{TOGGLE} / LOD CNST.0 / CU B1 / WR O0"), &["B1=0 O0=1"]);
    let down = format!("{TOGGLE} / LOD CNST.0 / CD W1 / WR O0");
    follow("W1=2", &down, &["W1=1 O0=0", "W1=1", "W1=0 O0=1", "W1=0 O0=1", "W1=0FFFFh O0=0 DR64=-1"]);
    follow("", &format!("{TOGGLE} / LOD CNST.-1 / CD B1 / WR O0"), &["B1=0FFh O0=1"]);
    let decimal = format!("{TOGGLE} / LOD CNST.10h / CUBCD W1 / WR O0");
    follow("W1=8", &decimal, &["W1=9 O0=0", "W1=9", "W1=10h O0=1 DR64=10h"]);
    follow("B1=99h", &format!("{TOGGLE} / LOD CNST.0 / CUBCD B1 / WR O0"), &["B1=0 O0=1"]);
}

#[test]
fn time_blocks_run_once_in_their_time() {
    // Not in the first cycle: no time has passed yet.
    for (block, cycles) in [("DFTM01", 5), ("DFTM1", 50), ("DFTM10", 500)] {
        let mut plc = Plc::of(&format!("{block} L / LOD W1 / INR / STO W1 / L:"));
        plc.run(1);
        for times in 0..=3 {
            if times > 0 {
                plc.run(cycles - 1);
                assert_eq!(plc.differences(&format!("W1={}", times - 1)), [""; 0], "{block}");
                plc.run(1);
            }
            assert_eq!(plc.differences(&format!("W1={times}")), [""; 0], "{block}");
        }
    }
}

#[test]
fn a_block_of_100_s() {
    let mut plc = Plc::of("DFTM100 L / LOD W1 / INR / STO W1 / L:");
    plc.run(5000);
    assert_eq!(plc.differences("W1=0"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("W1=1"), [""; 0]);
}

#[test]
fn a_timer_in_a_time_block_counts_its_passes() {
    let mut plc = Plc::of("DFTM01 L / LDR I0 / LOD CNST.2 / TM B1 / WR O0 / L:");
    plc.set("I0=1");
    plc.run(1);
    for expected in ["B1=1 O0=0", "B1=2 O0=0", "B1=2 O0=1"] {
        plc.run(5);
        assert_eq!(plc.differences(expected), [""; 0]);
    }
}
