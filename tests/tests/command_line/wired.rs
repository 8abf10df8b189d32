//! A program between the configuration files of its control and the machine behind it.

use serde_json::json;

use crate::frame::program;
use crate::ran::{Folder, run};

const DATA: &str = "BITS: DFM SEEN,,,,,,,\nGAUGE: DS 8";
const INIT: &str = "\
 MAP_IN AT_END,'inEnd'
 MAP_OUT PUSH,'outPush'
 MAP_AIN PRESSURE,'Pressure'
 MAP_AOUT DEMAND,'Demand',30.0
 DEF_IN READY,'Ready',TYPE_BIT";
const MAIN: &str = " FL 1,PUSH\n LDR AT_END\n WR SEEN\n LOD REAL.PRESSURE\n STO REAL.GAUGE";
const CHANNEL: &str = "<C><Plc>
<Input ID=\"inEnd\" Port=\"2\" Bit=\"4\" Invert=\"1\" Connected=\"1\"/>
<Output ID=\"outPush\" Port=\"1\" Bit=\"6\" Connected=\"1\"/>
<AnalogInput ID=\"Pressure\" PhysNo=\"4\" Scale=\"2\" Offset=\"-1\" MinVal=\"0\" MaxVal=\"16\" Connected=\"1\"/>
<AnalogOutput ID=\"Demand\" PhysNo=\"5\" Scale=\"0.1\" Connected=\"1\"/>
</Plc><Connections>
<Connection Source=\"ECAT.Rack.Inputs.Status.Bit[3]\" Destination=\"PLC.Input.Ready\" Connected=\"1\"/>
</Connections></C>";
const MACHINE: &str = "\
[machine]
name = 'Press'
[licences]
key = true
features = [2]
[[serial]]
channel = 1
[[can-unit]]
can = 2
group = 1
board = 3
[[can-drive]]
axis = 2
object = [{ index = 0x6060, type = 'byte' }]
[ethercat-master]
start-by-program = false
[[ethercat]]
name = 'Rack'
inputs = [{ name = 'Status', type = 'word' }]
[[ethercat]]
name = 'Z'
drive = true
servo = 2
[[contact]]
name = 'cylinder'
output = 'P1OUT.6'
input = 'P3IN.4'
on-delay-ms = 40
invert = true
[[contact]]
output = 'P1OUT.6'
input = 'ECAT.Rack.Inputs.Status.Bit[3]'
[[ramp]]
name = 'pump'
source = 'ANALOG_OUTPUT_PHYSICAL[5]'
source-per-volt = 20
high = 100
rise-per-s = 1000
value = 'ANALOG_INPUT_PHYSICAL[4]'
value-per-volt = 12
[[input]]
id = 'Gap'
value = 1.5
[[output]]
id = 'Beacon'
port = 'P0OUT.2'
invert = true
[[link]]
source = 'PLC.Output.Speed'
destination = 'PLC.Input.SpeedAct'
scale = 0.5
[[fault]]
name = 'cable'
slave = 'Z'
cut = true
[[fault]]
name = 'hot'
slave = 'Z'
error = 0x4310
[[fault]]
name = 'trip'
can-drive = 2
lost = true
[[fault]]
name = 'bus'
can = 2
cut = true
";

fn project(channel: &str) -> Folder {
    Folder::with(&[
        ("technol.toml", b"[project]\nname = 'wired'\nmain = 'main.plc'\n[machine]\nfile = 'machine.toml'\n"),
        ("main.plc", program(DATA, MAIN, INIT).as_bytes()),
        ("machine.toml", MACHINE.as_bytes()),
        ("wired.ChannelConfig", channel.as_bytes()),
    ])
}

#[test]
fn a_program_reaches_the_machine_through_its_configuration() {
    let path = project(CHANNEL);
    let names = "SEEN,REAL.GAUGE,REAL.ANALOG_OUTPUT_PHYSICAL+40,READY";
    let ran = run(&["run", &path.path(""), "--cycles", "20", "--format", "json", "--print", names]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    // 30.0 are 3 V and 60 of the pump, which are 5 V: (5 - 1) · 2.
    let expected =
        json!({ "SEEN": true, "REAL.GAUGE": 8.0, "REAL.ANALOG_OUTPUT_PHYSICAL+40": 3.0, "READY": true });
    assert_eq!(ran.json()["values"], expected);
}

#[test]
fn what_is_wrong_in_the_configuration_is_told_before_the_run() {
    let path = project(&CHANNEL.replace("Port=\"1\"", "Port=\"96\""));
    for command in [&["run", "--cycles", "1"][..], &["check"]] {
        let (name, more) = command.split_first().expect("a command");
        let ran = run(&[&[name, path.path("").as_str()], more].concat());
        let told = format!("{}{}", ran.out, ran.err);
        assert!(told.contains("wired.ChannelConfig:3:"), "{told}");
        assert!(told.contains("would be P96OUT"), "{told}");
    }
}

#[test]
fn identifiers_and_buses_are_told_in_words() {
    let path = project(CHANNEL);
    let out = run(&["run", &path.path(""), "--explain-machine"]).ok();
    insta::assert_snapshot!(out, @r#"
    Press

    What the outputs drive
      P1OUT.6  contact: ECAT.Rack.Inputs.Status.Bit[3] on after 0 ms, off after 0 ms
      P1OUT.6  contact "cylinder": P3IN.4 off after 40 ms, on after 0 ms

    What drives the inputs
      P3IN.4                          contact "cylinder": off 40 ms after P1OUT.6 goes on, on 0 ms after it goes off
      ECAT.Rack.Inputs.Status.Bit[3]  contact: on 0 ms after P1OUT.6 goes on, off 0 ms after it goes off

    Analogue inputs and outputs
      ANALOG_OUTPUT_PHYSICAL[5]  ramp "pump": is its target; it rises at 1000/s and falls at 1000/s, 20 for a volt
      ANALOG_INPUT_PHYSICAL[4]   ramp "pump": its value, 12 for a volt

    Identifiers
      input Gap                            always 1.5
      output Beacon                        P0OUT.2, inverted
      link PLC.Output.Speed                to PLC.Input.SpeedAct, times 0.5
      input inEnd                          P3IN.4, inverted, by the configuration
      output outPush                       P1OUT.6, by the configuration
      input Pressure                       ANALOG_INPUT_PHYSICAL[4], by the configuration
      output Demand                        ANALOG_OUTPUT_PHYSICAL[5], by the configuration
      link ECAT.Rack.Inputs.Status.Bit[3]  to PLC.Input.Ready, by the configuration

    Buses and licences
      hardware key       licences 2
      serial 1           9600 bit/s
      can-unit 2/1/3     INOUT08
      can-drive 2        CAN drive, NODE-ID 2, 1 object
      ethercat 0 "Rack"  slave; gives Status
      ethercat 1 "Z"     drive of servo loop 2; gives Status word, Position actual value, Error code; takes Control word, Target position, Target velocity

    Faults
      cable  the cable is cut in front of "Z"
      hot    "Z" is in error 4310h
      trip   nobody reaches the CAN drive of axis 2
      bus    the cable of CAN channel 2 is cut
    "#);
}

#[test]
fn an_identifier_that_is_the_name_of_a_symbol_is_a_mistake() {
    let path = project(CHANNEL);
    for (wrong, expected) in [
        (
            "[[link]]\nsource = 'M03PI'\ndestination = 'X'",
            "link[1].source: `M03PI` is a symbol, and no identifier",
        ),
        (
            "[[link]]\nsource = 'PLC.Output.Push'\ndestination = 'Ready'",
            "link[1].source: `PLC.Output.Push` is the cell of 'outPush'; write outPush",
        ),
        ("[[input]]\nid = 'PRESSURE.Bit[2]'\nvalue = 1", ""),
    ] {
        path.write("machine.toml", format!("{MACHINE}{wrong}\n").as_bytes());
        for command in [&["run", "--cycles", "1"][..], &["check"]] {
            let (name, more) = command.split_first().expect("a command");
            let ran = run(&[&[name, path.path("").as_str()], more].concat());
            let said = format!("{}{}", ran.out, ran.err);
            assert_eq!(ran.code == Some(0), expected.is_empty(), "{command:?} {wrong}: {said}");
            assert!(said.contains(expected), "{command:?}: {said}");
        }
    }
}

#[test]
fn gears_of_the_configuration_make_the_spindle_value_and_those_of_the_machine_win() {
    let gears = "<Spindle No=\"1\" GearCount=\"2\" SpeedLimit=\"1500\">\
                 <Gear No=\"1\" MaxSpeed=\"1600\"/><Gear No=\"0\" MaxSpeed=\"800\" MaxOutput=\"26869\"/>\
                 <Gear No=\"2\" MaxSpeed=\"9\"/></Spindle>";
    let channel = CHANNEL.replace("<C>", &format!("<C>{gears}"));
    let block = "[[block]]\nat-cycle = 1\nm = [41]\nspeed = 630.0\n";
    for (own, expected) in [("", 21_159), ("[[spindle]]\ngear = [{ max-speed = 1260 }]\n", 16_384)] {
        let path = project(&channel);
        path.write("machine.toml", format!("{MACHINE}{block}{own}").as_bytes());
        let ran = run(&["run", &path.path(""), "--cycles", "4", "--format", "json", "--print", "WORD.PB11"]);
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
        assert_eq!(ran.json()["values"], json!({ "WORD.PB11": expected }), "{own}");
    }
}
