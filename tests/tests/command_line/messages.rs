//! Messages of the program as the operator sees them: the screen, the event log, tests.

use serde_json::{Value, json};

use crate::frame::program;
use crate::ran::{Folder, run};

const DATA: &str = "BITS: DFM LOW,HOT,,,,,,\nVALUE: DS 4\nCYCLES: DS 4\nLAST: DS 2";
const INIT: &str = " EDEF BITS,LOW,67,-,1001b\n EDEF BITS,HOT,12,3,0001b,VALUE";
/// The number goes up; 67 is listed while LOW is 1; 5 comes in cycle 4, 90 in each.
const MAIN: &str = "\
 LOD CYCLES
 INR
 STO CYCLES
 LOD CYCLES
 EQ CNST.5
 ESET1 5,-,-,CYCLES,255
 ESET 90
PROC_BEGIN _ON_ESET
 STO LAST
PROC_END _ON_ESET";
const TEXTS: &str = "<PlcErrors>\
<PlcError No=\"5\" Type=\"Err\" Validity=\"Transient\"><Text>\nToo much: %d of %X\n</Text></PlcError>\
<PlcError No=\"12\" Type=\"Wrn2\" Validity=\"Transient\"><Text>Hot: %d</Text></PlcError>\
<PlcError No=\"67\" Type=\"Wrn1\" Validity=\"Persistent\"><Text>Oil is low</Text></PlcError>\
<PlcError No=\"90\" Type=\"Event\" Validity=\"Transient\"><Text>A cycle</Text></PlcError></PlcErrors>";

fn project(scenario: &str) -> Folder {
    let source = program(DATA, MAIN, INIT);
    Folder::with(&[
        ("technol.toml", b"[project]\nname = \"oil\"\nmain = \"main.plc\"\n".as_slice()),
        ("main.plc", source.as_bytes()),
        ("Plc0.PlcErrors", TEXTS.as_bytes()),
        ("oil.test.toml", scenario.as_bytes()),
    ])
}

fn ran(folder: &Folder, more: &[&str]) -> Value {
    let path = folder.path("");
    let ran = run(&[&["run", &path, "--format", "json", "--cycles", "8"], more].concat());
    assert_eq!(ran.code, Some(0), "{ran:?}");
    ran.json()
}

#[test]
fn a_run_ends_with_what_is_on_the_screen() {
    let folder = project("");
    let screen = &ran(&folder, &["--set", "LOW=1@2", "--set", "HOT=1@6", "--set", "VALUE=-3@3"])["screen"];
    let transient = json!([
        { "number": 5, "subId": null, "cycle": 4, "text": "Too much: 5 of FF" },
        { "number": 12, "subId": 3, "cycle": 6, "text": "Hot: -3" },
    ]);
    assert_eq!(screen["transient"], transient);
    assert_eq!(
        screen["persistent"],
        json!([{ "number": 67, "subId": null, "cycle": 2, "text": "Oil is low" }])
    );
    let screen = &ran(&folder, &["--set", "LOW=1@2", "--set", "LOW=0@5"])["screen"];
    assert_eq!(
        (screen["persistent"].clone(), screen["transient"].as_array().map(Vec::len)),
        (json!([]), Some(1))
    );
    let path = folder.path("");
    let said = run(&["run", &path, "--cycles", "8", "--set", "LOW=1@2"]).ok();
    for line in ["  to confirm    PLC00005  Too much: 5 of FF\n", "  listed        PLC00067  Oil is low\n"] {
        assert!(said.contains(line), "{said}");
    }
}

#[test]
fn the_event_log_has_errors_important_warnings_and_events() {
    let folder = project("");
    let log = folder.path("events.log");
    for _ in 0..2 {
        ran(&folder, &["--log", &log, "--set", "LOW=1@2", "--set", "LOW=0@5", "--set", "HOT=1@6"]);
    }
    let log = std::fs::read_to_string(log).expect("the log");
    assert_eq!(log.matches("Event PLC00090 A cycle\n").count(), 16, "{log}");
    let rest: Vec<&str> = log.lines().filter(|line| !line.contains("PLC00090")).collect();
    let run = [
        "0:00:00.020 PLC Starting",
        "0:00:00.020 PLC Running",
        "0:00:00.060 Wrn1 PLC00067 Oil is low",
        "0:00:00.100 Err PLC00005 Too much: 5 of FF (5, 255)",
        "0:00:00.120 Wrn1 PLC00067 removed",
    ];
    assert_eq!(rest, [run, run].concat(), "a second run is appended; Wrn2 is not logged");
}

#[test]
fn tests_look_at_the_screen_and_acknowledge() {
    let folder = project(
        "[[test]]\nname = 'operator'\nstep = [\n\
         { set = { LOW = 1 }, wait = '2 cycles', screen = false, not-listed = [67], message = 90 },\n\
         { set = { LOW = 0 }, wait = '1 cycle' },\n\
         { set = { LOW = 1, HOT = 1 }, wait = '3 cycles', listed = [67], screen = 12, message = [67, 12, 5], expect = { LAST = 90 } },\n\
         { acknowledge = true, screen = 5 },\n\
         { acknowledge = true, set = { LOW = 0 }, wait = '1 cycle', screen = false, not-listed = true },\n]\n",
    );
    let path = folder.path("");
    let out = run(&["test", &path]);
    assert_eq!(out.code, Some(0), "{out:?}");
    for (step, said) in [
        ("{ wait = '6 cycles', screen = false }", "message to acknowledge: none"),
        ("{ listed = 67 }", "message 67 is listed"),
        ("{ acknowledge = true }", "the screen shows none"),
        (
            "{ wait = '1 cycle' }, { set = { LOW = 1 }, wait = '1 cycle', not-listed = true }",
            "no listed message",
        ),
    ] {
        let folder = project(&format!("[[test]]\nname = 'wrong'\nstep = [ {step} ]\n"));
        let out = run(&["test", &folder.path("")]);
        assert_eq!(out.code, Some(1), "{step}: {out:?}");
        assert!(out.out.contains(said), "{step}: {}", out.out);
    }
}
