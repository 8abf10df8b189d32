//! The EtherCAT master (manual 26).

use technol_machine::{EcatSlave, EcatState};

use crate::coverage::with_mutants;
use crate::plc::Plc;

/// A mechanism that executes these lines, waits for their end, and keeps DR in D2.
fn transfer(lines: &str) -> Plc {
    let mut plc = Plc::of(&format!(
        "MECH_BEGIN M / LOD W2 / INR / STO W2 / {lines} / EX0 / STO D2 / FL 1,O0 / MECH_END M"
    ));
    let slave = slave(&mut plc);
    slave.set_object(0x603F, 0, &[0x34, 0x12], true);
    slave.set_object(0x6060, 0, &[1], false);
    slave.set_register(0, 51, &[1, 2, 3, 0x84], false);
    slave.set_register(0, 0x8001, &[7, 7], true);
    slave.set_element(0, 51, 0x08, b"mm");
    plc
}

/// The second slave.
fn slave(plc: &mut Plc) -> &mut EcatSlave {
    plc.control().ethercat_mut().slave_mut(1).expect("there is room")
}

#[test]
fn an_object_arrives_after_some_cycles_and_the_transfer_starts_once() {
    let mut plc = transfer("ECAT_COE_READ 0,1,603Fh,0,Q1,D1");
    plc.set("M=1 D1=4");
    for _ in 0..2 {
        plc.run(1);
        assert_eq!(plc.differences("M=1 D1=4 QWRD.Q1=0 W2=1 RLO=0"), [""; 0]);
    }
    plc.run(1);
    // Two bytes of the four came; DR is 0 and the lines before were executed once.
    assert_eq!(plc.differences("M=0 O0=1 D1=2 D2=0 QWRD.Q1=1234h W2=1"), [""; 0]);
    let mut plc = transfer("ECAT_COE_READ 0,1,603Fh,0,W1,D1");
    plc.control().ethercat_mut().set_answer_cycles(1);
    plc.set("M=1 D1=2 D2=-1");
    plc.run(1);
    assert_eq!(plc.differences("M=1 W1=0"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("M=0 W1=1234h D1=2 D2=0"), [""; 0]);
}

#[test]
fn what_is_written_is_what_stood_there_at_the_start() {
    let mut plc = transfer("ECAT_COE_WRITE 0,1,6060h,0,B1,D1");
    plc.set("M=1 D1=1 B1=8 D2=-1");
    plc.run(1);
    plc.set("B1=3");
    plc.run(1);
    assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[1][..]));
    plc.run(1);
    assert_eq!(plc.differences("M=0 O0=1 D1=1 D2=0"), [""; 0]);
    assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[8][..]));
}

#[test]
fn registers_have_elements() {
    for (lines, flags, wanted, expected) in [
        ("ECAT_SOE_READ 0,1,0,B1,51,Q1,D1", "40h", 4, "QWRD.Q1=84030201h D1=4 D2=0 B1=40h"),
        ("ECAT_SOE_READ 0,1,0,B1,51,Q1,D1", "8", 8, "QWRD.Q1=6D6Dh D1=2 D2=0 B1=8"),
        ("ECAT_SOE_READ 0,1,0,B1,8001h,W1,D1", "40h", 2, "W1=707h D1=2 D2=0"),
    ] {
        with_mutants(|| {
            let mut plc = transfer(lines);
            plc.set(&format!("M=1 B1={flags} B2=9 D1={wanted} D2=-1"));
            plc.run(3);
            assert_eq!(plc.differences(&format!("{expected} B2=9")), [""; 0], "{lines} {flags}");
        });
    }
    let mut plc = transfer("ECAT_SOE_WRITE 0,1,0,B1,51,D2,D1");
    plc.set("M=1 B1=40h D1=4 D2=01020304h");
    plc.run(3);
    assert_eq!(plc.differences("O0=1 D1=4 D2=0"), [""; 0]);
    assert_eq!(slave(&mut plc).register(0, 51), Some(&[4, 3, 2, 1][..]));
}

/// Master 0, slave 1, drive 0, the number of an object or register behind them, subindex or flags.
const CELLS: &str = "W1=1 BYTE.AREA=0 BYTE.(AREA+1)=0 WORD.(AREA+2)=1";

#[test]
fn numbers_come_from_cells_of_their_type() {
    let rows = [
        ("ECAT_COE_READ B2,W1,603Fh,B2,Q1,D1", "", "QWRD.Q1=1234h D1=2"),
        ("ECAT_COE_READ 0,1,W1,0,Q1,D1", "W1=603Fh", "QWRD.Q1=1234h D1=2"),
        (
            "ECAT_COE_READ BYTE.AREA,WORD.(AREA+2),WORD.(AREA+4),BYTE.(AREA+1),Q1,DWRD.D1",
            "WORD.(AREA+4)=603Fh",
            "QWRD.Q1=1234h D1=2",
        ),
        ("ECAT_SOE_READ B2,W1,B2,B1,51,Q1,D1", "B1=40h", "QWRD.Q1=84030201h D1=4"),
        ("ECAT_SOE_READ 0,1,0,B1,W1,Q1,D1", "W1=51 B1=40h", "QWRD.Q1=84030201h D1=4"),
        (
            "ECAT_SOE_READ BYTE.AREA,WORD.(AREA+2),BYTE.(AREA+1),BYTE.(AREA+6),WORD.(AREA+4),Q1,DWRD.D1",
            "WORD.(AREA+4)=51 BYTE.(AREA+6)=40h",
            "QWRD.Q1=84030201h D1=4",
        ),
    ];
    for (lines, given, expected) in rows {
        with_mutants(|| {
            let mut plc = transfer(lines);
            plc.set(&format!("M=1 {CELLS} {given} D1=4 D2=-1"));
            plc.run(3);
            assert_eq!(plc.differences(&format!("D2=0 {expected}")), [""; 0], "{lines}");
        });
    }
    let rows = [
        ("ECAT_COE_WRITE B2,W1,6060h,B2,Q1,D1", "D1=1"),
        ("ECAT_COE_WRITE 0,1,W1,0,Q1,D1", "D1=1 W1=6060h"),
        (
            "ECAT_COE_WRITE BYTE.AREA,WORD.(AREA+2),WORD.(AREA+4),BYTE.(AREA+1),Q1,DWRD.D1",
            "D1=1 WORD.(AREA+4)=6060h",
        ),
        ("ECAT_SOE_WRITE B2,W1,B2,B1,51,Q1,D1", "D1=4 B1=40h"),
        ("ECAT_SOE_WRITE 0,1,0,B1,W1,Q1,D1", "D1=4 W1=51 B1=40h"),
        (
            "ECAT_SOE_WRITE BYTE.AREA,WORD.(AREA+2),BYTE.(AREA+1),BYTE.(AREA+6),WORD.(AREA+4),Q1,DWRD.D1",
            "D1=4 WORD.(AREA+4)=51 BYTE.(AREA+6)=40h",
        ),
    ];
    for (lines, given) in rows {
        with_mutants(|| {
            let mut plc = transfer(lines);
            plc.set(&format!("M=1 {CELLS} {given} DWRD.Q1=0A0B0C0Dh D2=-1"));
            plc.run(3);
            assert_eq!(plc.differences("M=0 D2=0"), [""; 0], "{lines}");
            if lines.contains("COE") {
                assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[0x0D][..]), "{lines}");
            } else {
                assert_eq!(slave(&mut plc).register(0, 51), Some(&[0x0D, 0x0C, 0x0B, 0x0A][..]), "{lines}");
            }
        });
    }
}

#[test]
fn each_command_leads_to_its_state() {
    use EcatState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};
    let states = [
        ("INIT", Init),
        ("PREOPERATIONAL", PreOperational),
        ("BOOTSTRAP", Bootstrap),
        ("SAFEOPERATIONAL", SafeOperational),
        ("OPERATIONAL", Operational),
    ];
    for (name, state) in states {
        // From above and from below.
        for first in ["INIT", "OPERATIONAL"] {
            for (who, address) in
                [("SLAVE", "0,1"), ("SLAVE", "B2,W1"), ("MASTER", "B2,W1"), ("MASTER", "BYTE.B2,WORD.W1")]
            {
                with_mutants(|| {
                    let mut plc = Plc::of(&format!(
                        "MECH_BEGIN M / ECAT_COMMAND {address},ECATCMD_{who}_{first} / EX0 / EX / \
                         ECAT_COMMAND {address},ECATCMD_{who}_{name} / EX0 / STO D2 / FL 1,O0 / MECH_END M"
                    ));
                    slave(&mut plc);
                    plc.set("M=1 W1=1 D2=-1");
                    plc.run(20);
                    assert_eq!(plc.differences("O0=1 D2=0"), [""; 0], "{who} {first} {name}");
                    assert_eq!(slave(&mut plc).state(), state, "{who} {first} {name}");
                    let master = if who == "MASTER" { state } else { Operational };
                    assert_eq!(plc.control().ethercat_mut().state(), master, "{who} {first} {name}");
                });
            }
        }
    }
}

#[test]
fn errors_are_told_in_dr_and_nothing_is_transferred() {
    let mut wrong = Vec::new();
    for (lines, wanted, code) in [
        ("ECAT_COE_READ 1,1,603Fh,0,W1,D1", 2, "1"),
        ("ECAT_COE_READ 0,2,603Fh,0,W1,D1", 2, "2"),
        ("ECAT_COE_READ 0,1,603Fh,0,W1,D1", 0, "5"),
        ("ECAT_COE_READ 0,1,603Fh,0,W1,D1", 3, "5"),
        ("ECAT_COE_READ 0,1,603Fh,0,W1,D1", -1, "5"),
        ("ECAT_COE_READ 0,1,603Fh,0,W1,D1", 1, "5"),
        ("ECAT_COE_READ 0,1,603Eh,0,W1,D1", 2, "06020000h"),
        ("ECAT_COE_READ 0,1,603Fh,1,W1,D1", 2, "06090011h"),
        ("ECAT_COE_WRITE 0,1,603Fh,0,W1,D1", 2, "06010002h"),
        ("ECAT_COE_WRITE 0,1,6060h,0,W1,D1", 2, "06070012h"),
        ("ECAT_SOE_READ 0,1,0,B1,52,W1,D1", 2, "1001h"),
        ("ECAT_SOE_READ 0,1,1,B1,51,W1,D1", 2, "1001h"),
        ("ECAT_SOE_READ 0,1,0,B2,51,W1,D1", 2, "1009h"),
        ("ECAT_SOE_READ 0,1,0,BYTE.AREA,51,W1,D1", 2, "7"),
        ("ECAT_SOE_WRITE 0,1,0,B1,51,W1,D1", 2, "7002h"),
        ("ECAT_SOE_WRITE 0,1,0,B1,51,Q1,D1", 8, "7003h"),
        ("ECAT_SOE_WRITE 0,1,0,B1,8001h,W1,D1", 2, "7004h"),
        ("ECAT_COMMAND 0,1,ECATCMD_SLAVE_STATE,W1,D1", 3, "5"),
        ("ECAT_COMMAND 0,7,ECATCMD_SLAVE_INIT", 3, "2"),
        ("ECAT_COMMAND 1,1,ECATCMD_SLAVE_STATE,D1,D1", 4, "1"),
        // Numbers of 16 bits and lengths of 32.
        ("ECAT_COE_READ 0,WORD.(AREA+2),603Fh,0,W1,D1", 2, "2"),
        ("ECAT_COE_WRITE 0,WORD.(AREA+2),6060h,0,W1,D1", 1, "2"),
        ("ECAT_SOE_READ 0,WORD.(AREA+2),0,B1,51,W1,D1", 2, "2"),
        ("ECAT_SOE_WRITE 0,WORD.(AREA+2),0,B1,51,Q1,D1", 4, "2"),
        ("ECAT_COMMAND 0,WORD.(AREA+2),ECATCMD_SLAVE_INIT", 3, "2"),
        ("ECAT_SOE_READ 0,1,0,B1,WORD.(AREA+4),Q1,D1", 4, "1001h"),
        ("ECAT_SOE_WRITE 0,1,0,B1,WORD.(AREA+4),Q1,D1", 4, "1001h"),
        ("ECAT_COE_READ 0,1,603Fh,0,W1,D1", 0x10002, "5"),
        ("ECAT_SOE_READ 0,1,0,B1,51,W1,D1", 0x10002, "5"),
        ("ECAT_SOE_READ 0,1,0,B1,51,W1,D1", 3, "5"),
        ("ECAT_SOE_READ 0,1,0,B1,51,Q1,D1", 0x10004, "5"),
        ("ECAT_SOE_READ 0,1,0,B1,51,SHORT+1,D1", 4, "5"),
        ("ECAT_COE_WRITE 0,1,6060h,0,W1,D1", 0x10001, "5"),
        ("ECAT_SOE_WRITE 0,1,0,B1,51,Q1,D1", 0x10004, "5"),
        ("ECAT_COMMAND 0,1,ECATCMD_SLAVE_STATE,Q1,D1", 0x10004, "5"),
    ] {
        let mut plc = transfer(lines);
        plc.set(&format!(
            "M=1 D1={wanted} B1=40h B2=4 BYTE.AREA=41h WORD.(AREA+2)=101h WORD.(AREA+4)=133h W1=7777h D2=-1"
        ));
        plc.run(3);
        let length = if lines.contains("SLAVE_INIT") { wanted } else { 0 };
        let found = plc.differences(&format!("M=0 O0=1 D2={code} D1={length} W1=7777h"));
        if !found.is_empty() {
            wrong.push(format!("{lines} {wanted}: {}", found.join(", ")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_line_that_was_not_executed_in_the_cycle_before_starts_anew() {
    let mut plc = transfer("ECAT_COE_WRITE 0,1,6060h,0,B1,D1");
    plc.set("M=1 D1=1 B1=8");
    plc.run(1);
    plc.set("M=0 B1=3");
    plc.run(3);
    // The slave has what was sent; nobody asked for the result.
    assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[8][..]));
    plc.set("M=1");
    plc.run(2);
    assert_eq!(plc.differences("M=1 O0=0"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("M=0 O0=1"), [""; 0]);
    assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[3][..]));
}

#[test]
fn a_start_forgets_transfers() {
    let mut plc = transfer("ECAT_COE_WRITE 0,1,6060h,0,B1,D1");
    plc.set("M=1 D1=1 B1=8");
    plc.run(1);
    plc.restart();
    plc.set("M=0");
    plc.run(5);
    assert_eq!(slave(&mut plc).object(0x6060, 0), Some(&[1][..]));
}

#[test]
fn the_master_leads_all_slaves_and_a_slave_without_mailbox_is_refused() {
    let mut plc = Plc::of(
        "MECH_BEGIN M / ECAT_COMMAND 0,0,ECATCMD_MASTER_INIT / EX0 / STO W1 / FL 1,O0 / EX / \
         LOD CNST.1 / STO D1 / ECAT_COE_READ 0,1,6060h,0,B1,D1 / EX0 / STO D2 / FL 1,O1 / EX / \
         ECAT_COMMAND 0,1,ECATCMD_SLAVE_OPERATIONAL / EX0 / STO W2 / FL 1,O2 / MECH_END M",
    );
    slave(&mut plc).set_object(0x6060, 0, &[1], false);
    plc.set("M=1 W1=-1 W2=-1");
    plc.run(1);
    assert_eq!(plc.differences("OB=0"), [""; 0]);
    plc.run(1);
    // Down at once.
    assert_eq!(plc.differences("OB=1 W1=0"), [""; 0]);
    assert_eq!(plc.control().ethercat_mut().state(), EcatState::Init);
    assert_eq!(slave(&mut plc).state(), EcatState::Init);
    plc.run(3);
    assert_eq!(plc.differences("OB=3 D2=4"), [""; 0]);
    plc.run(3);
    assert_eq!(plc.differences("OB=3"), [""; 0]);
    assert_eq!(slave(&mut plc).state(), EcatState::SafeOperational);
    plc.run(1);
    // Up state by state, and only that slave.
    assert_eq!(plc.differences("OB=7 W2=0"), [""; 0]);
    assert_eq!(slave(&mut plc).state(), EcatState::Operational);
    assert_eq!(plc.control().ethercat_mut().state(), EcatState::Init);
}

#[test]
fn states_are_asked_for() {
    let commands = [
        ("0,0,ECATCMD_MASTER_STATE,D2,D1", 8),
        ("0,1,ECATCMD_SLAVE_STATE,D2,D1", 1),
        ("0,1,21,D2,DWRD.D1", 1),
        ("0,1,CNST.20,D2,D1", 8),
    ];
    for (command, expected) in commands {
        with_mutants(|| {
            let mut plc = Plc::of(&format!(
                "MECH_BEGIN M / ECAT_COMMAND 0,1,ECATCMD_SLAVE_INIT / EX0 / LOD CNST.4 / STO D1 / \
                 ECAT_COMMAND {command} / EX0 / FL 1,O0 / MECH_END M"
            ));
            slave(&mut plc);
            plc.set("M=1 D2=-1");
            plc.run(10);
            assert_eq!(plc.differences(&format!("O0=1 D1=4 D2={expected}")), [""; 0], "{command}");
        });
    }
}

#[test]
fn a_silent_slave_is_given_up_after_a_second() {
    for lines in ["ECAT_COE_READ 0,1,603Fh,0,W1,D1", "ECAT_COMMAND 0,1,ECATCMD_SLAVE_INIT"] {
        with_mutants(|| {
            let mut plc = transfer(lines);
            slave(&mut plc).set_silent(true);
            plc.set("M=1 D1=2 D2=-1");
            plc.run(50);
            assert_eq!(plc.differences("M=1 O0=0"), [""; 0], "{lines}");
            plc.run(1);
            assert_eq!(plc.differences("M=0 O0=1 D2=3"), [""; 0], "{lines}");
        });
    }
}

#[test]
fn the_machine_description_connects_buses_and_licences() {
    let machine = "
        licences = { key = true, features = [3] }
        [[serial]]
        channel = 1
        [[can-unit]]
        can = 2
        group = 1
        board = 3
        [[can-drive]]
        axis = 2
        node = 34
        object = [{ index = 0x6060, type = 'byte', value = 7 }]
        [[ethercat]]
        [[ethercat]]
        object = [{ index = 0x6041, subindex = 1, type = 'word', value = 0x1234, read-only = true }]
        register = [{ idn = 51, type = 'dword', value = -2 }]
    ";
    let lines = "LDR_LIC FeaturePlc3 / WR O0 / COM_SEND 1,B1 / WR O1 / COM_SEND 2,B1 / WR O2 / \
                 CAN_SYSIO_READ 2,1,3,PRESENT / STO B2 / CAN_AX_SEND 2 / LOD WORD.CAN_AX_SEND_PACKET / STO W2 / \
                 MECH_BEGIN M / LOD CNST.2 / STO D1 / ECAT_COE_READ 0,1,6041h,1,W1,D1 / EX0 / MECH_END M";
    let mut plc = Plc::on(Some(machine), "", lines);
    plc.set("M=1");
    plc.run(3);
    assert_eq!(plc.differences("OB=101b B2=1 W1=1234h W2=622h"), [""; 0]);
    assert_eq!(plc.control().can_drive_mut(2).object(0x6060, 0), Some(&[7][..]));
    assert_eq!(slave(&mut plc).register(0, 51), Some(&[0xFE, 0xFF, 0xFF, 0xFF][..]));
}
