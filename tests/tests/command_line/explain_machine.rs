//! `technol run --explain-machine`.

use serde_json::Value;

use crate::frame::program;
use crate::lathe::Lathe;
use crate::ran::{Folder, run};

const MACHINE: &str = "\
[machine]
name = 'Everything'
[control]
start = 'P9IN.0'
[[contact]]
name = 'pump'
output = 'P0OUT.0'
input = 'P1IN.0'
on-delay-ms = 50
[[limit]]
name = 'door'
output-forward = 'P0OUT.1'
output-backward = 'P0OUT.2'
travel-ms = 900
input-at-end = 'P1IN.1'
[[limit]]
output-forward = 'P0OUT.3'
travel-ms = 10
return-ms = 20
input-at-start = 'P1IN.2'
[[encoder]]
output = 'P0OUT.0'
input = 'P5IN.0'
period-ms = 24
position = ['P6IN', 'P7IN']
[[turret]]
name = 'disc'
stations = 8
motor = 'P0OUT.4'
station-ms = 480
code = ['P2IN.0', 'P2IN.1', 'P2IN.2', 'P2IN.3']
strobe = 'P2IN.4'
[[latch]]
set = 'P0OUT.5'
reset = ['P0OUT.6', 'P1IN.1']
input = 'P1IN.3'
[[counter]]
name = 'parts'
pulses = 'P1IN.1'
count = 12
input = 'P1IN.4'
[[ramp]]
name = 'oil'
output = 'P0OUT.7'
low = 20
high = 80
rise-per-s = 2.5
value = ['P8IN']
thresholds = [{ at = 60, hysteresis = 5, input = 'P1IN.5' }]
[[slide]]
name = 'loader'
forward = 'P1OUT.0'
backward = 'P1OUT.1'
speed-mm-s = 50
stroke-mm = 300.5
switches = [{ at = 10, width = 2.5, input = 'P1IN.6' }]
[[key]]
name = 'light'
command = 7
[[key]]
name = 'stop'
input = 'P1IN.7'
invert = true
[[fault]]
name = 'welded'
element = 'pump'
stuck = true
[[fault]]
name = 'stiff'
element = 'loader'
slow = 3
active = true
[[fault]]
name = 'short'
output = 'P0OUT.0'
shorted = true
[[fault]]
name = 'wire'
input = 'P1IN.0'
broken = true
[[block]]
name = 'N10'
at-cycle = 5
motion-ms = 100
[[block]]
[[block]]
on = 'P9IN.0'
";

const DATA: &str =
    "IN1: DFM PUMP_ON,DOOR_OPEN,,,,,,STOP_KEY\nOUT0: DFM PUMP,OPEN,CLOSE,,,,,\nOUT2: DFM LAMP,,HORN\nX: DS 1";
const MAIN: &str = " LOD P1IN\n STO IN1\n LOD OUT0\n STO P0OUT\n LOD OUT2\n STO P2OUT\n\
                    LDR P3IN.B4\n WR P4OUT.B1\n LOD P10IN\n STO X\n LOD P8IN\n STO X";

fn folder() -> Folder {
    Folder::with(&[
        ("technol.toml", b"[project]\nname = 'all'\nfiles = ['plc.plc']\n[machine]\nfile = 'machine.toml'\n"),
        ("plc.plc", program(DATA, MAIN, "").as_bytes()),
        ("machine.toml", MACHINE.as_bytes()),
    ])
}

#[test]
fn every_element_is_told_in_words() {
    let out = run(&["run", &folder().path(""), "--explain-machine"]).ok();
    insta::assert_snapshot!(out, @"");
}

#[test]
fn the_lathe_has_nothing_unconnected_but_its_lamps() {
    let lathe = Lathe::copy();
    let out = run(&["run", &lathe.path(""), "--explain-machine", "--format", "json"]).ok();
    let out: Value = serde_json::from_str(&out).expect("JSON");
    let unconnected: Vec<String> = out["unconnected"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|use_of| format!("{} {}", use_of["signal"].as_str().unwrap(), use_of["name"].as_str().unwrap()))
        .collect();
    insta::assert_snapshot!(unconnected.join("\n"), @"");
    let first = &out["drives"][0];
    assert_eq!((&first["signal"], &first["name"]), (&"P0OUT.0".into(), &"OUT_SP_CW".into()), "{first}");
}

#[test]
fn without_a_machine_there_is_nothing_to_tell() {
    let folder = Folder::lone(&program("", "", ""));
    run(&["run", &folder.path("plc.plc"), "--explain-machine"])
        .failed(2, &["no machine is described", "technol.toml"]);
    run(&["run", &folder.path("plc.plc")]).failed(2, &["--cycles"]);
}
