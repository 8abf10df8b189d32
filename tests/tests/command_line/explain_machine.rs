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

const DATA: &str = "IN1: DFM PUMP_ON,DOOR_OPEN,,,,,,STOP_KEY\nOUT0: DFM PUMP,OPEN,CLOSE,,,,,\nOUT2: DFM LAMP,,HORN\nBITS: DFM B0,B1,B2,B3,B4\nX: DS 1";
const MAIN: &str = " LOD P1IN\n STO IN1\n LOD OUT0\n STO P0OUT\n LOD OUT2\n STO P2OUT\n\
                    LDR P3IN.B4\n WR P4OUT.B1\n LOD P10IN\n STO X\n LOD P8IN\n STO X";

fn folder() -> Folder {
    Folder::with(&[
        ("technol.toml", b"[project]\nname = 'all'\nmain = 'plc.plc'\n[machine]\nfile = 'machine.toml'\n"),
        ("plc.plc", program(DATA, MAIN, "").as_bytes()),
        ("machine.toml", MACHINE.as_bytes()),
    ])
}

#[test]
fn every_element_is_told_in_words() {
    let out = run(&["run", &folder().path(""), "--explain-machine"]).ok();
    insta::assert_snapshot!(out, @r#"
    Everything

    What the outputs drive
      P0OUT.0 PUMP   contact "pump": P1IN.0 on after 50 ms, off after 0 ms
      P0OUT.0 PUMP   encoder: turns it: a pulse every 24 ms
      P0OUT.1 OPEN   limit "door": moves it to the end in 900 ms: then P1IN.1
      P0OUT.2 CLOSE  limit "door": moves it to the start in 900 ms
      P0OUT.3        limit: moves it to the end in 10 ms; off: a spring brings it back in 20 ms: then P1IN.2
      P0OUT.4        turret "disc": turns it to the next station, 480 ms each, 8 stations
      P0OUT.5        latch: sets it: P1IN.3 on
      P0OUT.6        latch: resets it: P1IN.3 off
      P0OUT.7        ramp "oil": raises it to 80 at 2.5/s; off: it falls to 20 at 2.5/s
      P1OUT.0        slide "loader": moves it forward at 50 mm/s, stroke 300.5 mm
      P1OUT.1        slide "loader": moves it backward at 50 mm/s, stroke 300.5 mm

    What drives the inputs
      P1IN.0 PUMP_ON    contact "pump": on 50 ms after P0OUT.0 goes on, off 0 ms after it goes off
      P1IN.1 DOOR_OPEN  limit "door": on at the end, where P0OUT.1 brings it in 900 ms
      P1IN.2            limit: on at the start, where a spring brings it in 20 ms
      P1IN.3            latch: on from P0OUT.5 until P0OUT.6 or P1IN.1
      P1IN.4            counter "parts": on from pulse 12 of P1IN.1 until the next
      P1IN.5            ramp "oil": on from 60, off below 55
      P1IN.6            slide "loader": on from 10 mm to 12.5 mm
      P1IN.7 STOP_KEY   key "stop": off while pressed
      P2IN.0            turret "disc": its station in BCD, bit 0
      P2IN.1            turret "disc": its station in BCD, bit 1
      P2IN.2            turret "disc": its station in BCD, bit 2
      P2IN.3            turret "disc": its station in BCD, bit 3
      P2IN.4            turret "disc": on for 120 ms while a station is in place
      P5IN.0            encoder: a pulse every 24 ms while P0OUT.0 is on
      P6IN              encoder: its count in binary, byte 0
      P7IN              encoder: its count in binary, byte 1
      P8IN              ramp "oil": its value in binary

    What inputs drive besides the program
      P1IN.1 DOOR_OPEN  counter "parts": is counted up to 12, then P1IN.4
      P1IN.1 DOOR_OPEN  latch: resets it: P1IN.3 off
      P9IN.0            block: starts block 3
      P9IN.0            control: starts again what was stopped

    Keys
      light  tells _ON_CMD 7
      stop   P1IN.7 off while pressed

    Faults
      welded  "pump" stays on
      stiff   "loader" takes 3 times as long, from the start
      short   P0OUT.0 has a short circuit
      wire    the wire of P1IN.0 is broken: it stays off

    Blocks
      "N10" in cycle 5, moves for 100 ms
      block 2 after the block before it
      block 3 when P9IN.0 goes on

    Used by the program, connected to nothing
      P3IN.4
      P2OUT.0  LAMP
      P2OUT.2  HORN
      P4OUT.1
      P10IN    the whole port
    "#);
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
    insta::assert_snapshot!(unconnected.join("\n"), @r"
    P0OUT.2 SP_BRAKE
    P3OUT.0 COOL_PUMP
    P3OUT.2 L_READY
    P3OUT.3 L_ERROR
    P3OUT.4 L_COOL
    ");
    let first = &out["driven"][0];
    let expected = serde_json::json!({
        "signal": "P1IN.0",
        "name": "K_CW",
        "element": "contact \"spindle contactor clockwise\"",
        "text": "on 120 ms after P0OUT.0 goes on, off 80 ms after it goes off",
    });
    assert_eq!(first, &expected);
}

#[test]
fn without_a_machine_there_is_nothing_to_tell() {
    let folder = Folder::lone(&program("", "", ""));
    run(&["run", &folder.path("plc.plc"), "--explain-machine"])
        .failed(2, &["no machine is described", "technol.toml"]);
    run(&["run", &folder.path("plc.plc")]).failed(2, &["--cycles"]);
}
