//! What the control does around the program: events, keys with commands, start and stop, ports (manual 3.17, 5.3, 8, 9).

use technol_runtime::{Block, Command, PlcState};

use crate::frame;
use crate::plc::Plc;

/// The codes one behind the other, as hexadecimal digits in D1.
const REMEMBER: &str =
    "PROC_BEGIN _ON_EVENT / STO DWRD.D2 / LOD D1 / MULB CNST.16 / AD D2 / STO D1 / PROC_END _ON_EVENT";

#[test]
fn events_come_with_their_codes() {
    let mut plc = Plc::of(REMEMBER);
    plc.run(2);
    assert_eq!(plc.differences("D1=0"), [""; 0]);
    plc.command(Command::StartBlock(Block { motion_ms: 200, ..Block::default() }));
    plc.run(2);
    assert_eq!(plc.differences("D1=54h"), [""; 0], "START_REQ, START");
    let mut plc = Plc::of(&format!(
        "{REMEMBER} / LDR I0 / FL1 1,STOP_REQ / FL1 0,I0 / LDR I1 / FL1 1,STOP_EMERGENCY_REQ / FL1 0,I1"
    ));
    plc.command(Command::StartBlock(Block { motion_ms: 200, ..Block::default() }));
    plc.run(2);
    plc.set("I0=1");
    plc.run(2);
    assert_eq!(plc.differences("D1=5413h"), [""; 0], "STOP_REQ, STOP");
    plc.command(Command::ContinueBlock);
    plc.run(2);
    plc.set("I1=1");
    plc.run(2);
    assert_eq!(plc.differences("D1=54135423h"), [""; 0], "START_REQ, START, STOP_EMERGENCY_REQ, STOP");
}

#[test]
fn the_names_of_the_events_are_their_codes() {
    let names = [
        "PLCEVENT_STOP_REQ",
        "PLCEVENT_STOP_EMERGENCY_REQ",
        "PLCEVENT_STOP",
        "PLCEVENT_START",
        "PLCEVENT_START_REQ",
    ];
    for (code, name) in (1..).zip(names) {
        let mut plc = Plc::of(&format!("LOD CNST.{name}"));
        plc.run(1);
        assert_eq!(plc.differences(&format!("DR64={code}")), [""; 0], "{name}");
    }
}

#[test]
fn a_program_holds_a_start_until_it_is_ready() {
    let lines = "PROC_BEGIN _ON_EVENT / EQ CNST.PLCEVENT_START_REQ / FL1 1,START_SUSPEND / PROC_END _ON_EVENT / \
                 LDR I0 / FL1 0,START_SUSPEND / LDR PO_F / WR O0";
    let mut plc = Plc::of(lines);
    plc.command(Command::StartBlock(Block { motion_ms: 200, ..Block::default() }));
    plc.run(5);
    assert_eq!(plc.differences("O0=0"), [""; 0]);
    plc.set("I0=1");
    plc.run(2);
    assert_eq!(plc.differences("O0=1"), [""; 0]);
}

#[test]
fn a_program_forbids_every_start() {
    let mut plc = Plc::of("LDR I0 / WR START_DISABLE / LDR PO_F / WR O0");
    plc.set("I0=1");
    plc.run(1);
    plc.command(Command::StartBlock(Block { motion_ms: 200, ..Block::default() }));
    plc.run(5);
    assert_eq!(plc.differences("O0=0"), [""; 0]);
    plc.set("I0=0");
    plc.run(2);
    assert_eq!(plc.differences("O0=1"), [""; 0]);
}

#[test]
fn a_key_with_a_command_calls_on_cmd() {
    let mut plc =
        Plc::of("PROC_BEGIN _ON_CMD / WR O0 / STO D1 / LOD D2 / INR DWRD / STO D2 / PROC_END _ON_CMD");
    plc.command(Command::PlcCommand { code: 1234, pressed: true });
    plc.run(1);
    assert_eq!(plc.differences("O0=1 D1=1234 D2=1"), [""; 0]);
    plc.command(Command::PlcCommand { code: 1234, pressed: false });
    plc.run(3);
    assert_eq!(plc.differences("O0=0 D1=1234 D2=2"), [""; 0]);
}

#[test]
fn masks_force_inputs_and_outputs() {
    let lines = "LOD CNST.3 / STO BYTE.SETH_P5IN / STO BYTE.SETH_P7OUT / LOD CNST.5 / STO BYTE.SETL_P5IN / STO BYTE.SETL_P7OUT / \
                 LOD P5IN / STO B1 / LOD CNST.0Ch / STO BYTE.P7OUT";
    let mut plc = Plc::of(lines);
    plc.inputs()[4] = 0b1100;
    plc.run(2);
    assert_eq!(plc.differences("B1=1010b"), [""; 0], "0 wins over 1");
    assert_eq!(plc.runtime().outputs()[7], 0b1010);
}

#[test]
fn a_short_circuit_is_told_and_confirmed() {
    // The bit of the port that the program's own byte names, as in the manual's example.
    let lines =
        "LDR I0 / WR O1 / LOD OB / STO P4OUT / LDR ERRLI_P4OUT.O1 / WR O7 / LDR I1 / FL1 0,ERRLI_P4OUT.O1";
    let mut plc = Plc::of(lines);
    plc.set("I0=1");
    let mut shorted = [0; 96];
    shorted[4] = 0b10;
    plc.runtime().set_shorted(&shorted);
    plc.run(2);
    assert_eq!((plc.differences("O7=1"), plc.runtime().outputs()[4] & 0b10), (vec![], 0));
    plc.runtime().set_shorted(&[0; 96]);
    plc.run(2);
    assert_eq!((plc.differences("O7=1"), plc.runtime().outputs()[4] & 0b10), (vec![], 0));
    plc.set("I1=1");
    plc.run(2);
    assert_eq!((plc.differences("O7=0"), plc.runtime().outputs()[4] & 0b10), (vec![], 0b10));
}

/// MODULE_MAIN with these lines, and the modules around the life of the PLC.
fn life(main: &str) -> Plc {
    let source =
        frame::program("IB: DFM I0,I1\nOB: DFM O0,O1\nN: DS 4", main, " LDR I1\n LOD CNST.1\n STO N");
    let source = source.replace(" MODULE_INIT_FINISHED\n", "");
    Plc::from_source(source.replace("STOP\n", "MODULE_DONE\n LOD CNST.2\n STO N\nMODULE_DONE_END\nSTOP\n"))
}

#[test]
fn the_plc_runs_once_the_program_has_said_so() {
    let mut plc = life(" LDR I0\n JL0 L\n\tMODULE_INIT_FINISHED\nL:");
    plc.run(3);
    assert_eq!((plc.runtime().state(), plc.differences("N=1")), (PlcState::Starting, vec![]));
    plc.set("I0=1");
    plc.run(1);
    assert_eq!(plc.runtime().state(), PlcState::Running);
    let mut plc = life("");
    plc.run(1);
    assert_eq!(plc.runtime().state(), PlcState::Running, "without the instruction at once");
}

#[test]
fn the_plc_stops_once_the_program_has_said_so() {
    let mut plc = life(" LDR I0\n JL0 L\n MODULE_DONE_FINISHED\nL:");
    plc.run(2);
    plc.command(Command::StopPlc { power_off: false });
    plc.run(3);
    assert_eq!((plc.runtime().state(), plc.differences("N=2")), (PlcState::Stopping, vec![]));
    plc.set("I0=1");
    plc.run(1);
    assert_eq!(plc.runtime().state(), PlcState::Stopped);
    let mut plc = life("");
    plc.run(1);
    plc.command(Command::StopPlc { power_off: false });
    plc.run(1);
    assert_eq!(plc.runtime().state(), PlcState::Stopped, "without the instruction at once");
}

#[test]
fn the_interface_has_its_values_at_power_on() {
    let lines = "LDR MPXPI / LA VAZBA_X / LA EN_AUTMAN / WR O0 / LDR START_DISABLE / WR O1 / LOD SPEED_OVR_MULTIPLIER";
    let mut plc = Plc::of(lines);
    plc.run(1);
    assert_eq!(plc.differences("O0=1 O1=0 DR64=1000"), [""; 0]);
}
