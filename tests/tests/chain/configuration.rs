//! Parameters and constants of the configuration (manual 16).

use technol_machine::{ControlData, Value};

use crate::coverage::wrong_rows;
use crate::plc::Plc;

fn data() -> ControlData {
    let named = |(id, value): (&str, Value)| (id.as_bytes().to_vec(), value);
    let parameters = [
        ("Delay", Value::Int(0x1234_5678)),
        ("Minus", Value::Int(-2)),
        ("Zero", Value::Int(0)),
        ("Gain", Value::Real(2.5)),
        ("Loss", Value::Real(-2.5)),
        ("Name", Value::Text(b"xyz".to_vec())),
        ("Long", Value::Text(b"0123456789".to_vec())),
        ("Raw", Value::Bytes(vec![1, 2, 3])),
        ("Rest", Value::Bytes(vec![1, 2, 3, 4, 5, 6])),
    ];
    let constants = [("Offs", 260), ("Code", 0xFFFF_FFFF)];
    ControlData {
        parameters: parameters.map(named).into(),
        constants: constants.map(|(id, value)| (id.as_bytes().to_vec(), value)).into(),
        ..ControlData::default()
    }
}

/// Before, the lines, after one cycle.
#[track_caller]
fn check(rows: &[(&str, &str, &str)]) {
    let wrong = wrong_rows(rows, |(given, lines, then)| {
        let mut plc = Plc::of(lines);
        plc.control().set_data(data());
        plc.set(given);
        plc.run(1);
        plc.differences(then).into_iter().chain(plc.fault()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_parameter_goes_to_the_target_at_its_width_and_rlo_tells_that_it_is_there() {
    check(&[
        ("", "LOD CNST.7 / CNF_GET_INT D1,'Delay'", "D1=12345678h D2=0 RLO=1 DR=7"),
        ("", "CNF_GET_INT W1,'Delay'", "W1=5678h W2=0 RLO=1"),
        ("", "CNF_GET_INT B1,'Minus'", "B1=0FEh B2=0 RLO=1"),
        ("", "CNF_GET_INT LONG,'Minus'", "QWRD.LONG=68676665FFFFFFFEh RLO=1"),
        ("", "STRCPY LONG,'Delay' / CNF_GET_INT D1,LONG", "D1=12345678h RLO=1"),
        ("", "CNF_GET_INT BYTE.AREA,'Delay'", "QWRD.AREA=78h RLO=1"),
        ("", "CNF_GET_INT WORD.AREA,'Delay'", "QWRD.AREA=5678h RLO=1"),
        ("", "CNF_GET_INT DWRD.AREA,'Minus'", "QWRD.AREA=0FFFFFFFEh RLO=1"),
        ("", "STRCPY LONG,'Gain' / CNF_GET_REAL REAL.R1,LONG", "REAL.R1=2.5 RLO=1"),
        ("", "STRCPY MIDDLE,'Name' / CNF_GET_STR LONG,MIDDLE", "QWRD.LONG=68676665007A7978h RLO=1"),
        ("", "STRCPY MIDDLE,'Raw' / CNF_GET_BIN LONG,MIDDLE", "QWRD.LONG=6867666564030201h RLO=1"),
        ("", "STRCPY MIDDLE,'Minus' / CNF_GET_BIT OB.I3,MIDDLE", "OB=8 RLO=1"),
        // Halves go away from zero.
        ("", "CNF_GET_INT W1,'Gain'", "W1=3 RLO=1"),
        ("", "CNF_GET_INT W1,'Loss'", "W1=0FFFDh RLO=1"),
        ("", "CNF_GET_REAL R1,'Gain'", "REAL.R1=2.5 RLO=1"),
        ("", "CNF_GET_REAL R1,'Minus'", "REAL.R1=-2.0 RLO=1"),
        ("", "CNF_GET_STR LONG,'Name'", "QWRD.LONG=68676665007A7978h RLO=1"),
        ("", "CNF_GET_STR SHORT,'Long'", "DWRD.SHORT=00323130h BYTE.BEHIND=77h RLO=1"),
        ("", "CNF_GET_BIN LONG+1,'Raw'", "QWRD.LONG=6867666503020161h RLO=1"),
        // Not past the end of a buffer.
        ("", "CNF_GET_BIN SHORT,'Rest'", "DWRD.SHORT=04030201h BYTE.BEHIND=77h RLO=1"),
        ("", "CNF_GET_INT SHORT+1,'Minus'", "DWRD.SHORT=0FFFFFE63h BYTE.BEHIND=77h RLO=1"),
        ("", "CNF_GET_BIT O1,'Minus'", "OB=2 RLO=1"),
        ("OB=255", "CNF_GET_BIT O1,'Zero'", "OB=253 RLO=1"),
    ]);
}

#[test]
fn without_the_parameter_the_target_gets_the_default_or_stays() {
    check(&[
        ("D1=9", "LDR -I0 / CNF_GET_INT D1,'None'", "D1=9 RLO=0"),
        ("D1=9", "CNF_GET_INT D1,'None',-5", "D1=-5 RLO=0"),
        ("D1=9 W1=44", "CNF_GET_INT D1,'None',W1", "D1=44 RLO=0"),
        ("B1=44", "CNF_GET_INT D1,'None',B1", "D1=44 RLO=0"),
        ("B1=44", "CNF_GET_INT D1,'None',BYTE.B1", "D1=44 RLO=0"),
        ("W1=300", "CNF_GET_INT D1,'None',WORD.W1", "D1=300 RLO=0"),
        ("D2=70000", "CNF_GET_INT D1,'None',D2", "D1=70000 RLO=0"),
        ("D2=70000", "CNF_GET_INT D1,'None',DWRD.D2", "D1=70000 RLO=0"),
        ("", "CNF_GET_INT D1,'None',CNST.70000", "D1=70000 RLO=0"),
        ("REAL.R2=8.5", "CNF_GET_REAL R1,'None',REAL.R2", "REAL.R1=8.5 RLO=0"),
        // Another type or other letters are another parameter.
        ("D1=9", "CNF_GET_INT D1,'Name',1", "D1=1 RLO=0"),
        ("D1=9", "CNF_GET_INT D1,'delay',1", "D1=1 RLO=0"),
        ("", "CNF_GET_REAL R1,'None',0.5", "REAL.R1=0.5 RLO=0"),
        ("REAL.R2=8.5", "CNF_GET_REAL R1,'None',R2", "REAL.R1=8.5 RLO=0"),
        ("", "CNF_GET_STR LONG,'None','pq'", "QWRD.LONG=6867666564007170h RLO=0"),
        ("", "CNF_GET_STR LONG,'None',SHORT", "QWRD.LONG=6867666500656463h RLO=0"),
        ("", "CNF_GET_STR LONG,'Gain'", "QWRD.LONG=6867666564636261h RLO=0"),
        ("", "CNF_GET_BIN LONG,'None','pq'", "QWRD.LONG=6867666564637170h RLO=0"),
        ("", "CNF_GET_BIN LONG,'Name',SHORT", "QWRD.LONG=6867666500656463h RLO=0"),
        ("OB=2", "CNF_GET_BIT O1,'None'", "OB=2 RLO=0"),
        ("", "CNF_GET_BIT O1,'None',1", "OB=2 RLO=0"),
        ("OB=255", "CNF_GET_BIT O1,'None',0", "OB=253 RLO=0"),
    ]);
}

#[test]
fn a_constant_goes_to_its_cell_and_to_dr() {
    check(&[
        ("", "CONST_GET W1,'Offs'", "W1=260 W2=0 DR=260 RLO=1"),
        ("", "CONST_GET B1,'Offs'", "B1=4 B2=0 DR=260 RLO=1"),
        ("W2=9", "CONST_GET W1,'Offs'", "W1=260 W2=9"),
        ("D2=9", "CONST_GET D1,'Offs'", "D1=260 D2=9"),
        ("", "STRCPY LONG,'Offs' / CONST_GET BYTE.AREA,LONG", "QWRD.AREA=4 DR=260 RLO=1"),
        ("", "CONST_GET WORD.AREA,'Offs'", "QWRD.AREA=260 DR=260 RLO=1"),
        ("", "CONST_GET DWRD.AREA,'Code'", "QWRD.AREA=0FFFFFFFFh RLO=1"),
        ("", "CONST_GET D1,'Code'", "D1=0FFFFFFFFh D2=0 RLO=1"),
        ("W1=3", "LOD CNST.8 / CONST_GET W1,'None'", "W1=3 DR=0 RLO=0"),
    ]);
}

#[test]
fn the_configuration_is_there_in_module_init() {
    let mut plc = Plc::with_init("CNF_GET_INT D1,'Delay',50", "");
    assert_eq!(plc.differences("D1=50"), [""; 0]);
    plc.control().set_data(data());
    plc.restart();
    assert_eq!(plc.differences("D1=12345678h"), [""; 0]);
}
