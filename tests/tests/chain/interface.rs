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
    let machine = "[[fault]]\nname = 'short'\noutput = 'P4OUT.1'\nshorted = true\nactive = true";
    let mut plc = Plc::before(machine, lines);
    plc.set("I0=1");
    let driven = |plc: &mut Plc| plc.runtime().outputs()[4] & 0b10;
    plc.run(2);
    assert_eq!((plc.differences("O7=1"), driven(&mut plc)), (vec![], 0));
    plc.fault_of_machine("short", false);
    plc.run(2);
    assert_eq!((plc.differences("O7=1"), driven(&mut plc)), (vec![], 0));
    plc.set("I1=1");
    plc.run(2);
    assert_eq!((plc.differences("O7=0"), driven(&mut plc)), (vec![], 0b10));
}

#[test]
fn keys_of_the_panel_and_of_the_control_reach_the_program() {
    let machine = "[control]\nstart = 'P2IN.0'\nstop = 'P2IN.1'\n[[m-function]]\nnumber = 91\ngroup = 10\n\
                   [[spindle]]\nport = 1\ngear = [{ max-speed = 400 }, { max-speed = 800 }]\n\
                   [[key]]\nname = 'light'\ncommand = 12\n[[key]]\nname = 'start'\ninput = 'P2IN.0'\n\
                   [[key]]\nname = 'stop'\ninput = 'P2IN.1'\n\
                   [[block]]\nat-cycle = 2\nm = [91, 40]\nspeed = 630\nrapid = true\nintegers = [7, 8]\naxes = [[2, 150.5]]\n\
                   flags = ['rev-feed']\n[[block]]\nm = [3]";
    let lines = "PROC_BEGIN _ON_CMD / WR O0 / STO D1 / PROC_END _ON_CMD / LOD PB03 / STO B1 / LDR M42PI / WR O1 / \
                 LDR PO_STOP / WR O2 / LDR BLK[0].FirstBlock / LA -BLK[0].LastBlock / LA BLK[1].LastBlock / WR O3 / \
                 LOD BLK[0].IPlcParams[1] / STO D2 / LOD BLK[0].REAL.AxNC[2] / STO REAL.R1 / LDR BLK[0].RevFeed / WR O4 / \
                 LDR SF_RUN / WR O5";
    let mut plc = Plc::before(machine, lines);
    plc.press("light", true);
    plc.run(1);
    assert_eq!(plc.differences("O0=1 D1=12"), [""; 0]);
    plc.press("light", false);
    plc.run(3);
    assert_eq!(plc.differences("O0=0 B1=91h O1=1 O2=0 O3=1 D2=8 REAL.R1=150.5 O4=1 O5=1"), [""; 0]);
    plc.press("stop", true);
    plc.run(3);
    assert_eq!(plc.differences("O2=1 O5=0"), [""; 0]);
    plc.press("start", true);
    plc.run(2);
    assert_eq!(plc.differences("O2=0 O5=1"), [""; 0]);
}

/// Twelve blocks, more than the control hands over at once; each counts W1 in MODULE_MAIN while it moves.
fn long_program(first: &str) -> String {
    let more = "[[block]]\nmotion-ms = 20\n".repeat(11);
    format!(
        "[[block]]\non = 'P1IN.0'\n{first}\nmotion-ms = 20\n{more}[control]\nstart = 'P1IN.1'\nstop = 'P1IN.2'"
    )
}

/// Counts the blocks by their starts; D1 has the codes of events.
const COUNT_BLOCKS: &str = "EDGE_H PO_F / JL0 L / LOD W1 / INR / STO W1 / L:";

#[test]
fn a_long_program_runs_to_its_end() {
    let mut plc = Plc::before(&long_program(""), COUNT_BLOCKS);
    plc.run(1);
    plc.inputs()[0] = 1;
    plc.run(60);
    assert_eq!(plc.differences("W1=12"), [""; 0]);
}

#[test]
fn m00_holds_a_long_program_and_start_goes_on_with_all_of_it() {
    let mut plc = Plc::before(&long_program("m = [0]"), COUNT_BLOCKS);
    plc.run(1);
    plc.inputs()[0] = 1;
    plc.run(30);
    assert_eq!(plc.differences("W1=1"), [""; 0]);
    plc.inputs()[0] = 3;
    plc.run(60);
    assert_eq!(plc.differences("W1=12"), [""; 0]);
}

#[test]
fn a_stop_holds_a_long_program_and_ends_one_whose_start_is_held() {
    for (hold, blocks) in [("LDR I0 / FL1 1,START_SUSPEND", 0), ("LDR I0", 12)] {
        let suspend =
            format!("PROC_BEGIN _ON_EVENT / {hold} / FL1 0,O0 / PROC_END _ON_EVENT / {COUNT_BLOCKS}");
        let mut plc = Plc::before(&long_program(""), &suspend);
        plc.set("I0=1");
        plc.run(1);
        plc.inputs()[0] = 1;
        plc.run(2);
        plc.inputs()[0] = 5; // the second block has begun when the stop is taken
        plc.run(4);
        plc.set("I0=0");
        plc.inputs()[0] = 2;
        plc.run(60);
        assert_eq!(plc.differences(&format!("W1={blocks}")), [""; 0], "{hold}");
        // The next program runs as a whole.
        plc.inputs()[0] = 1;
        plc.run(60);
        assert_eq!(plc.differences(&format!("W1={}", blocks + 12)), [""; 0], "{hold}");
    }
}

/// MODULE_MAIN with these lines, and the modules around the life of the PLC.
fn life(main: &str) -> Plc {
    let source =
        frame::program("IB: DFM I0,I1\nOB: DFM O0,O1\nN: DS 4", main, " LDR I1\n LOD CNST.1\n STO N");
    let source = source.replace(" MODULE_INIT_FINISHED\n", "");
    Plc::from_source(&source.replace("STOP\n", "MODULE_DONE\n LOD CNST.2\n STO N\nMODULE_DONE_END\nSTOP\n"))
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
