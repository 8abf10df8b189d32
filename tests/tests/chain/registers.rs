//! What an instruction leaves alone: RLO, DR and DR_REAL, as far as it does not write them itself.

use technol_machine::{Column, ControlData, Table, ValueKind};

use crate::coverage::wrong_rows;
use crate::plc::Plc;

/// What is in the registers before.
const BEFORE: &str = "LOD CNST.1.5 / LOD CNST.77 / LDR -I7 / WR O7";
/// The rest of the registers when an instruction writes none of them, RLO, DR, or both.
const NONE: &str = "RLO=1 DR64=77 DR_REAL=1.5";
const RLO: &str = "DR64=77 DR_REAL=1.5";
const DR: &str = "RLO=1 DR_REAL=1.5";
const BOTH: &str = "DR_REAL=1.5";
/// A real goes to DR, too.
const REALS: &str = "RLO=1";

/// Declarations, which stand in MODULE_INIT.
const DECLARED: &str = "AX_SPI 9 / DEF_IN ASKED,'Asked',TYPE_INT_32,-,ONDEMAND";

#[track_caller]
fn check(rows: &[(&str, &str)]) {
    let wrong = wrong_rows(rows, |(line, rest)| {
        let mut plc = Plc::with_init(DECLARED, &format!("{BEFORE} / {line}"));
        plc.run(1);
        plc.differences(rest).into_iter().chain(plc.fault()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn of_bits_and_jumps() {
    check(&[
        ("LDR I0", RLO),
        ("LDR -I0", RLO),
        ("LDR I0 / LA I1", RLO),
        ("LDR I0 / LO I1", RLO),
        ("LDR I0 / LX I1", RLO),
        ("LDR I0 / LDR I1 / LA", RLO),
        ("LDR I0 / LDR I1 / LO", RLO),
        ("LDR I0 / LDR I1 / LX", RLO),
        ("LDR I0 / CA", RLO),
        ("EDGE_H I0", RLO),
        ("EDGE_L I0", RLO),
        ("WR O0", NONE),
        ("FL 1,O0", NONE),
        ("FL 0,O0", NONE),
        ("FL1 1,O0", NONE),
        ("MOVR O0,O1", NONE),
        ("MOVR1 O0,O1", NONE),
        ("JUM L / L:", NONE),
        ("LDR I7 / WR O6 / JL1 L / L:", "RLO=0 DR64=77 DR_REAL=1.5"),
        ("JL0 L / L:", NONE),
        ("PROC_CALL P / PROC_BEGIN P / FL 1,O0 / PROC_END P", NONE),
        ("NOP / CLI / STI", NONE),
    ]);
}

#[test]
fn of_data() {
    check(&[
        ("LOD W1", DR),
        ("LOD CNST.2.5", REALS),
        ("STO W1", NONE),
        ("STO REAL.R1", NONE),
        ("STO1 W1", NONE),
        ("STO1 REAL.R1", NONE),
        ("STO0 W1", NONE),
        ("STO0 REAL.R1", NONE),
        ("MOVE W1,W2", NONE),
        ("MOVE REAL.R1,REAL.R2", NONE),
        ("MOVE1 W1,W2", NONE),
        ("MOVE1 REAL.R1,REAL.R2", NONE),
        ("MV Q1,Q2,3", NONE),
        ("CLEAR W1,D1", NONE),
        ("AD W1", DR),
        ("SU W1", DR),
        ("MULB W1", DR),
        ("DIVB CNST.3", DR),
        ("ORB W1", DR),
        ("ANDB W1", DR),
        ("XORB W1", DR),
        ("AD REAL.R1", REALS),
        ("SU REAL.R1", REALS),
        ("MULB REAL.R1", REALS),
        ("DIVB CNST.0.5", REALS),
        ("INR", DR),
        ("DCR", DR),
        ("INV", DR),
        ("ABS", DR),
        ("INR REAL", REALS),
        ("DCR REAL", REALS),
        ("INV REAL", REALS),
        ("ABS REAL", REALS),
        ("LOD CNST.77h / INRBCD", DR),
        ("LOD CNST.77h / BIN", DR),
        ("BCD", DR),
        ("RL CNST.1", DR),
        ("RR CNST.1", DR),
        ("CONDR", RLO),
        ("CONRD", DR),
        ("REAL", REALS),
        ("EQ W1", RLO),
        ("LT W1", RLO),
        ("GT W1", RLO),
        ("LE W1", RLO),
        ("GE W1", RLO),
        ("EQ1 W1", RLO),
        ("EQ REAL.R1", RLO),
        ("LT REAL.R1", RLO),
        ("GT REAL.R1", RLO),
        ("LE REAL.R1", RLO),
        ("GE REAL.R1", RLO),
        ("EQ1 REAL.R1", RLO),
        ("TM B1", RLO),
        ("CU B1", BOTH),
        ("CD B1", BOTH),
        ("CUBCD B1", BOTH),
    ]);
}

#[test]
fn of_texts_messages_and_configuration() {
    check(&[
        ("STRCPY LONG,SHORT", NONE),
        ("STRADD LONG,SHORT", NONE),
        ("BINSTR LONG", NONE),
        ("LOD CNST.77h / BCDSTR LONG", "RLO=1 DR64=77h DR_REAL=1.5"),
        ("STRCMP LONG,SHORT", RLO),
        ("MEMCPY LONG,SHORT", NONE),
        ("MEMCMP LONG,SHORT", RLO),
        ("ESET 1", NONE),
        ("ESET1 1", NONE),
        ("CNF_GET_INT D1,'None',1", RLO),
        ("CNF_GET_REAL R1,'None',0.5", RLO),
        ("CNF_GET_STR LONG,'None','pq'", RLO),
        ("CNF_GET_BIN LONG,'None','pq'", RLO),
        ("CNF_GET_BIT O1,'None',1", RLO),
        ("CONST_GET W1,'None'", BOTH),
        ("LDR_LIC FeaturePlc0", RLO),
        ("UPDATE_IN ASKED", NONE),
    ]);
}

#[test]
fn of_declarations() {
    let rows = [
        ("EDEF -,I0,FIVE,-,0001b", "O0=1"),
        ("MAP_IN DOOR,'Door'", "O0=1"),
        ("MAP_OUT LAMP,'Lamp'", "O0=1"),
        ("MAP_AIN AIR,'Air'", "O0=1"),
        ("MAP_AOUT BELT,'Belt'", "O0=1"),
        ("DEF_IN ASKED,'Asked',TYPE_INT_32", "O0=1"),
        ("DEF_OUT SENT,'Sent',TYPE_INT_32", "O0=1"),
        // These tell by RLO whether the name is free.
        ("SHARE_VAR D1,'A',TYPE_DWORD", "O0=1"),
        ("SHARE_BIT OB,'B',O1", "O0=1"),
        ("SHARE_VAR D1,PACKET,TYPE_DWORD", "O0=0"),
        ("SHARE_BIT OB,PACKET,O1", "O0=0"),
    ];
    let wrong = wrong_rows(&rows, |(line, bit)| {
        let plc = Plc::with_init(&format!("{BEFORE} / {line} / STO QWRD.Q1 / STO REAL.R1 / WR O0"), "");
        let mut found = plc.differences("QWRD.Q1=77 REAL.R1=1.5");
        found.extend(plc.differences(bit));
        found.extend(plc.fault());
        found
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn of_buses_and_ports() {
    check(&[
        ("CAN_SEND 2,PACKET", DR),
        ("CAN_RECV 2,PACKET", DR),
        ("CAN_RECV_REQ 2,580h,-,33,-,P,PACKET / PROC_BEGIN P / FL 1,O0 / PROC_END P", BOTH),
        ("CAN_RECV_END D1", RLO),
        ("CAN_RECV_DEL D1", RLO),
        ("CAN_SYSIO_READ 1,1,1,IN0", RLO), // there is no such unit
        ("CAN_SYSIO_WRITE 1,1,1,IN0", RLO),
        ("CAN_AX_SEND 2", NONE),
        ("COM_SEND 1,B1", RLO),
        ("COM_SEND_STR 1,LONG,3", RLO),
        ("COM_RECV 1", RLO),
        ("COM_CONTROL 1,STATE", DR),
        ("COM_CONTROL 1,RECEIVED", DR),
        ("COM_CONTROL 1,CLEAR", NONE),
    ]);
}

#[test]
fn of_axes_and_outputs() {
    check(&[
        ("ANALOG_PORT 5", NONE),
        ("ANALOG", NONE),
        ("ANALOG_SPI 7,5", NONE),
        ("AX_SPI 4", NONE),
        ("SPI_AX -,-,-,-,9", NONE),
        ("SPI_MAIN 9", NONE),
        ("RAMP W1,30", DR),
        ("REGUL_X 2", NONE),
        ("REGUL_Y 2", NONE),
        ("REGUL_Z 2", NONE),
        ("REGUL_4 2", NONE),
        ("REGUL_5 2", NONE),
        ("REGUL_6 2", NONE),
        ("POS_INIT 1", NONE),
        ("POS_MODE B1,D1,W1,1", NONE),
        ("POS_CONTROL D2,D1,-,1", NONE),
        ("POS_RESET 1", NONE),
    ]);
}

#[test]
fn of_the_older_positioning() {
    let lines: Vec<String> = ["X", "Y", "Z", "4", "5", "6"]
        .into_iter()
        .flat_map(|axis| {
            [
                format!("POS_INIT_{axis}"),
                format!("POS_MODE_{axis} B1,D1,W1,W2"),
                format!("POS_CONTROL_{axis} Q1,D2,I7"),
                format!("POS_RESET_{axis}"),
            ]
        })
        .collect();
    let rows: Vec<(&str, &str)> = lines.iter().map(|line| (line.as_str(), NONE)).collect();
    check(&rows);
}

#[test]
fn of_time_blocks() {
    let rows = [("DFTM01", 6), ("DFTM1", 51), ("DFTM10", 501), ("DFTM100", 5001)];
    let wrong = wrong_rows(&rows, |(block, cycles)| {
        let mut plc = Plc::of(&format!("{BEFORE} / {block} L / STO QWRD.Q1 / STO REAL.R1 / WR O0 / L:"));
        plc.run(*cycles);
        plc.differences("O0=1 QWRD.Q1=77 REAL.R1=1.5").into_iter().chain(plc.fault()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn of_mechanisms() {
    let rows = [
        "BEX",
        "EX0",
        "LDR I7 / EX1 / LDR -I7 / WR O7",
        "TIM -,0",
        "TEX0 -,5,E / E:",
        "LDR I7 / TEX1 -,5,E / E: / LDR -I7 / WR O7",
        "MECH_INIT M",
    ];
    let wrong = wrong_rows(&rows, |line| {
        let mut plc = Plc::of(&format!(
            "MECH_BEGIN M / {BEFORE} / {line} / STO QWRD.Q1 / STO REAL.R1 / WR O0 / MECH_END M"
        ));
        plc.set("M=1");
        plc.run(1);
        plc.differences("O0=1 QWRD.Q1=77 REAL.R1=1.5").into_iter().chain(plc.fault()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // The pass that does not wait leaves RLO as it is.
    let rows = [("EX1", "I6"), ("TEX1 -,5,E / E:", "I6")];
    let wrong = wrong_rows(&rows, |(line, bit)| {
        let mut plc = Plc::of(&format!("MECH_BEGIN M / LDR {bit} / {line} / WR O0 / FL 1,O1 / MECH_END M"));
        plc.set("M=1 O0=1");
        plc.run(1);
        plc.differences("O0=0 O1=1").into_iter().chain(plc.fault()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// DR_REAL while they wait and when they are through.
#[test]
fn of_transfers() {
    let rows = [
        "SA_READ 0,0,4,D1",
        "SA_WRITE 0,0,4,D1",
        "PLCT_COL_INDEX 0,'A',W1",
        "PLCT_COL_ID 0,LONG",
        "PLCT_COL_TYPE 0,0,B1",
        "PLCT_GET_SELLINE 0,W1",
        "PLCT_SET_SELLINE 0,0",
        "PLCT_CHANGED 0,W1",
        "PLCT_GET_LINESCOUNT 0,W1",
        "PLCT_GET_INT 0,0,0,D1",
        "PLCT_GET_REAL 0,0,0,R1",
        "PLCT_GET_STR 0,0,0,LONG",
        "PLCT_GET_BIN 0,0,0,AREA",
        "PLCT_SET_INT 0,0,0,D1",
        "PLCT_SET_REAL 0,0,0,R1",
        "PLCT_SET_STR 0,0,0,LONG",
        "PLCT_SET_BIN 0,0,0,AREA",
        "ECAT_COE_READ 0,1,603Fh,0,W1,D1",
        "ECAT_COE_WRITE 0,1,603Fh,0,W1,D1",
        "ECAT_SOE_READ 0,1,0,B1,51,W1,D1",
        "ECAT_SOE_WRITE 0,1,0,B1,51,W1,D1",
        "ECAT_COMMAND 0,1,ECATCMD_SLAVE_INIT",
    ];
    let wrong = wrong_rows(&rows, |line| {
        let mut plc =
            Plc::of(&format!("{BEFORE} / MECH_BEGIN M / {line} / STO REAL.R2 / EX0 / FL 1,O0 / MECH_END M"));
        let columns = vec![Column { id: b"A".to_vec(), kind: ValueKind::Int }];
        let tables = vec![Table { columns, rows: vec![Vec::new()] }];
        plc.control().set_data(ControlData { tables, ..ControlData::default() });
        plc.control().ethercat_mut().slave_mut(1).expect("there is room");
        plc.set("M=1");
        plc.run(1);
        let mut found = plc.differences("REAL.R2=1.5");
        plc.run(1);
        found.extend(plc.differences("REAL.R2=1.5"));
        found.extend(plc.fault());
        found
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
