//! Mechanisms cycle by cycle (manual chapter 4): where they wait, when they go on, what restarts them.

use crate::coverage::with_mutants;
use crate::plc::{Plc, first_line};

/// Before each cycle what is set, after it what holds.
#[track_caller]
fn follow(lines: &str, cycles: &[(&str, &str)]) {
    with_mutants(|| {
        let mut plc = Plc::of(lines);
        for (cycle, (set, expected)) in cycles.iter().enumerate() {
            plc.set(set);
            plc.run(1);
            assert_eq!(plc.differences(expected), [""; 0], "{lines}, after cycle {cycle}");
        }
        assert_eq!(plc.fault(), None);
    });
}

#[test]
fn ex_goes_on_in_the_next_cycle() {
    let line = first_line() + 2;
    let waits = format!("OB=1 M=1 M_LINE={line}");
    follow(
        "MECH_BEGIN M / FL 1,O0 / EX / FL 1,O1 / MECH_END M",
        // At MECH_END the bit goes off, and the line number.
        &[("", "OB=0 M=0 M_LINE=0"), ("M=1", &waits), ("", "OB=3 M=0 M_LINE=0"), ("OB=0", "OB=0")],
    );
    // An endless mechanism needs an EX in its loop.
    follow(
        "MECH_BEGIN M / L: / LOD W1 / INR / STO W1 / EX / JUM L / MECH_END M",
        &[("M=1", "W1=1"), ("", "W1=2"), ("", "W1=3"), ("M=0", "W1=3"), ("M=1", "W1=4")],
    );
}

#[test]
fn conditional_ex_waits_and_passes_in_the_same_cycle() {
    for (instruction, waiting, passing) in [("EX0", "I0=0", "I0=1"), ("EX1", "I0=1", "I0=0")] {
        let lines = format!("MECH_BEGIN M / LDR I0 / {instruction} / FL 1,O0 / MECH_END M");
        let start = format!("{waiting} M=1");
        follow(&lines, &[(&start, "O0=0 M=1"), ("", "O0=0 M=1"), (passing, "O0=1 M=0")]);
        let start = format!("{passing} M=1");
        follow(&lines, &[(&start, "O0=1 M=0")]);
    }
}

#[test]
fn what_stands_behind_the_last_ex_is_executed_in_every_cycle_that_waits() {
    let count = "LOD W1 / INR / STO W1";
    let again = format!("MECH_BEGIN M / {count} / LDR I0 / EX0 / FL 1,O0 / MECH_END M");
    follow(&again, &[("M=1", "W1=1"), ("", "W1=2"), ("", "W1=3"), ("I0=1", "W1=4 O0=1 M=0")]);
    // BEX moves the continuation without waiting.
    let once = format!("MECH_BEGIN M / {count} / BEX / LDR I0 / EX0 / FL 1,O0 / MECH_END M");
    follow(&once, &[("M=1", "W1=1"), ("", "W1=1"), ("I0=1", "W1=1 O0=1 M=0")]);
    // A pass through an EX1 that does not wait moves it too.
    let passed = format!("MECH_BEGIN M / {count} / LDR I1 / EX1 / LDR I0 / EX0 / FL 1,O0 / MECH_END M");
    follow(&passed, &[("I1=1 M=1", "W1=1"), ("", "W1=2"), ("I1=0", "W1=3"), ("", "W1=3"), ("I0=1", "O0=1")]);
}

#[test]
fn registers_survive_a_pass_that_does_not_wait() {
    follow(
        "MECH_BEGIN M / LOD FIVE / LDR I0 / EX1 / STO B1 / WR O1 / MECH_END M",
        &[("M=1", "B1=5 O1=0 M=0")],
    );
    follow(
        "MECH_BEGIN M / LOD FIVE / LDR -I0 / EX0 / STO B1 / WR O1 / MECH_END M",
        &[("M=1", "B1=5 O1=1 M=0")],
    );
    follow(
        "MECH_BEGIN M / LOD FIVE / LDR -I0 / BEX / STO B1 / WR O1 / MECH_END M",
        &[("M=1", "B1=5 O1=1 M=0")],
    );
}

#[test]
fn tim_waits_its_cycles_and_restarts() {
    follow(
        "MECH_BEGIN M / TIM B1,3 / FL 1,O0 / MECH_END M",
        &[
            ("M=1", "B1=1 O0=0"),
            ("", "B1=2 O0=0"),
            ("", "B1=3 O0=0"),
            ("", "B1=0 O0=1 M=0"),
            ("M=1 O0=0", "B1=1 O0=0 M=1"),
        ],
    );
}

#[test]
fn a_time_of_nothing_passes_at_once_and_a_counter_is_as_wide_as_its_cell() {
    for time in ["0", "W2", "CNST.0"] {
        follow(&format!("MECH_BEGIN M / TIM W1,{time} / FL 1,O0 / MECH_END M"), &[("M=1", "O0=1 M=0 W1=0")]);
        for (instruction, condition) in [("TEX0", "I0"), ("TEX1", "-I0")] {
            let lines = format!(
                "MECH_BEGIN M / LDR {condition} / {instruction} W1,{time},E / JUM F / E: / FL 1,O1 / F: / MECH_END M"
            );
            follow(&lines, &[("M=1", "O1=1 M=0 W1=0")]);
        }
    }
    for (wait, given) in [("TIM", ""), ("LDR I0 / TEX0", ",E"), ("LDR -I0 / TEX1", ",E")] {
        let byte = format!("MECH_BEGIN M / {wait} B1,3{given} / E: / MECH_END M");
        follow(&byte, &[("M=1 B2=7", "B1=1 B2=7"), ("", "B1=2 B2=7")]);
        // More than 255 cycles.
        with_mutants(|| {
            let mut plc = Plc::of(&format!("MECH_BEGIN M / {wait} W1,300{given} / E: / MECH_END M"));
            plc.set("M=1");
            plc.run(300);
            assert_eq!(plc.differences("M=1 W1=300"), [""; 0], "{wait}");
            plc.run(1);
            assert_eq!(plc.differences("M=0 W1=0"), [""; 0], "{wait}");
        });
    }
}

#[test]
fn the_line_is_that_of_the_instruction_it_waits_at() {
    let line = first_line() + 2;
    for wait in ["EX0", "EX1", "TIM -,2", "TEX0 -,2,E", "TEX1 -,2,E"] {
        let condition = if wait.contains('1') { "LDR -I0" } else { "LDR I0" };
        let lines = format!("MECH_BEGIN M / {condition} / {wait} / E: / MECH_END M");
        follow(
            &lines,
            &[
                ("M=1", &format!("M=1 M_LINE={line}")),
                ("I0=1", &format!("M_LINE={}", if wait.starts_with("TIM") { line } else { 0 })),
            ],
        );
    }
}

#[test]
fn counters_and_times_of_every_kind() {
    let given = "M=1 B2=2 W2=2";
    for operands in ["NIL,2", "-,2", "B1,2", "W1,2", "W1,FIVE-3", "-,B2", "NIL,W2"] {
        let lines = format!("MECH_BEGIN M / TIM {operands} / FL 1,O0 / MECH_END M");
        follow(&lines, &[(given, "O0=0 M=1"), ("", "O0=0 M=1"), ("", "O0=1 M=0")]);
        for (instruction, condition) in [("TEX0", "I0"), ("TEX1", "-I0")] {
            let lines = format!(
                "MECH_BEGIN M / LDR {condition} / {instruction} {operands},E / JUM F / E: / FL 1,O1 / F: / MECH_END M"
            );
            follow(&lines, &[(given, "O1=0 M=1"), ("", "O1=0 M=1"), ("", "O1=1 M=0")]);
        }
    }
}

#[test]
fn the_code_of_an_error_is_loaded_as_lod_would() {
    let codes = [
        ("", "6"),
        (",CNST.-77", "-77"),
        (",77", "77"),
        (",B2", "0FFFFFFF3h"),
        (",BYTE.AREA", "45h"),
        (",W2", "0FFFF8765h"),
        (",WORD.AREA", "2345h"),
        (",D2", "98765432h"),
        (",DWRD.AREA", "12345h"),
    ];
    for (code, expected) in codes {
        for (instruction, condition) in [("TEX0", "I0"), ("TEX1", "-I0")] {
            let lines = format!(
                "MECH_BEGIN M / LOD CNST.6 / LDR {condition} / {instruction} -,1,E{code} / JUM F / E: / STO D1 / F: / \
                 MECH_END M"
            );
            let given = "M=1 B2=0F3h W2=8765h D2=98765432h DWRD.AREA=12345h";
            follow(&lines, &[(given, "D1=0 M=1"), ("", &format!("D1={expected} M=0"))]);
        }
    }
}

#[test]
fn tex_waits_for_its_condition_or_jumps_when_the_time_is_over() {
    for (instruction, waiting, passing) in [("TEX0", "I0=0", "I0=1"), ("TEX1", "I0=1", "I0=0")] {
        let lines = format!(
            "MECH_BEGIN M / LDR I0 / {instruction} B1,3,E,77 / FL 1,O0 / JUM F / E: / STO W1 / FL 1,O1 / F: / MECH_END M"
        );
        let start = format!("{waiting} M=1");
        follow(
            &lines,
            &[
                (&start, "OB=0 M=1 B1=1"),
                ("", "OB=0 M=1 B1=2"),
                ("", "OB=0 M=1 B1=3"),
                ("", "OB=2 M=0 W1=77"),
                // The time runs anew.
                ("OB=0 M=1", "OB=0 M=1 B1=1"),
                (passing, "OB=1 M=0"),
            ],
        );
        let start = format!("{passing} M=1");
        follow(&lines, &[(&start, "OB=1 M=0 W1=0")]);
    }
}

#[test]
fn a_mechanism_is_paused_by_its_bit_and_rewound_by_mech_init() {
    let mechanism = "MECH_BEGIN M / LOD W1 / INR / STO W1 / BEX / TIM B1,3 / FL 1,O0 / MECH_END M";
    follow(
        mechanism,
        &[
            ("M=1", "W1=1 B1=1"),
            ("M=0", "W1=1 B1=1 M=0"),
            ("", "W1=1 B1=1"),
            ("M=1", "W1=1 B1=2"),
            ("", "W1=1 B1=3"),
            ("", "W1=1 O0=1 M=0"),
        ],
    );
    follow(
        &format!("LDR I1 / JL0 L / MECH_INIT M / L: / {mechanism}"),
        &[
            ("M=1", "W1=1 B1=1"),
            ("", "W1=1 B1=2"),
            ("I1=1", "W1=1 M=0 O0=0"),
            ("I1=0", "W1=1 M=0"),
            ("M=1", "W1=2 B1=1"),
            ("", "W1=2 B1=2"),
            ("", "W1=2 B1=3"),
            ("", "W1=2 O0=1 M=0"),
        ],
    );
}

#[test]
fn one_mechanism_starts_another_and_waits_for_it() {
    let line = first_line() + 4;
    let waits = format!("OB=1 FIRST=1 SECOND=1 FIRST_LINE={line}");
    follow(
        "MECH_BEGIN FIRST / FL 1,O0,SECOND / EX / LDR SECOND / EX1 / FL 1,O2 / MECH_END FIRST / \
         MECH_BEGIN SECOND / TIM -,2 / FL 1,O1 / MECH_END SECOND",
        &[
            ("FIRST=1", "OB=1 FIRST=1 SECOND=1"),
            ("", &waits),
            // SECOND stands behind FIRST, which sees its end one cycle later.
            ("", "OB=3 FIRST=1 SECOND=0"),
            ("", "OB=7 FIRST=0 SECOND=0 FIRST_LINE=0"),
        ],
    );
}
