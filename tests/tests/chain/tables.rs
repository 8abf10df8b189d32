//! PLC tables (manual 17).

use technol_machine::{Column, ControlData, Table, Value, ValueKind};

use crate::coverage::{with_mutants, wrong_rows};
use crate::plc::Plc;

fn text(text: &str) -> Vec<u8> {
    text.as_bytes().to_vec()
}

/// Columns of every type; the second row has only its first two values.
fn data() -> ControlData {
    let columns = [
        ("Name", ValueKind::Text),
        ("Teeth", ValueKind::Int),
        ("Feed", ValueKind::Real),
        ("Blob", ValueKind::Bytes),
    ];
    let columns = columns.map(|(id, kind)| Column { id: text(id), kind }).to_vec();
    let first =
        vec![Value::Text(text("Steel")), Value::Int(-3), Value::Real(120.5), Value::Bytes(vec![1, 2, 3])];
    let second = vec![Value::Text(text("Brass")), Value::Int(18)];
    ControlData { tables: vec![Table { columns, rows: vec![first, second] }], ..ControlData::default() }
}

/// A mechanism of one instruction, waiting for its end; then O0 is 1 when there was no error, D2 has its number.
fn plc(line: &str) -> Plc {
    let mut plc = Plc::of(&format!("MECH_BEGIN M / {line} / EX0 / STO D2 / EQ CNST.0 / WR O0 / MECH_END M"));
    plc.control().set_data(data());
    plc.set("M=1");
    plc
}

/// What is in memory before, the instruction, what is there at the end.
#[track_caller]
fn check(rows: &[(&str, &str, &str)]) {
    let wrong = wrong_rows(rows, |(given, line, then)| {
        let mut plc = plc(line);
        plc.set(given);
        plc.run(1);
        // The transfer takes a cycle.
        let mut found = plc.differences("M=1 RLO=0 DR=0");
        plc.run(1);
        found.extend(plc.differences(&format!("M=0 {then}")));
        found.extend(plc.fault());
        found
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn columns_lines_and_counts() {
    // `Feed` as a text.
    const FEED: &str = "DWRD.LONG=64656546h BYTE.(LONG+4)=0";
    check(&[
        ("", "PLCT_COL_INDEX 0,'Feed',W1", "W1=2 OB=1 D2=0"),
        ("W1=9", "PLCT_COL_INDEX 0,'feed',W1", "W1=9 OB=0 D2=3"),
        ("W1=9", "PLCT_COL_INDEX 1,'Feed',W1", "W1=9 OB=0 D2=1"),
        ("DWRD.LONG=1", "PLCT_COL_ID 0,LONG", "QWRD.LONG=6867006874656554h OB=1"),
        ("DWRD.SHORT=1", "PLCT_COL_ID 0,SHORT", "DWRD.SHORT=00656554h BYTE.BEHIND=77h OB=1"),
        ("DWRD.LONG=4", "PLCT_COL_ID 0,LONG", "DWRD.LONG=4 OB=0 D2=3"),
        ("", "PLCT_COL_TYPE 0,0,B1", "B1=3 OB=1"),
        ("", "PLCT_COL_TYPE 0,1,B1", "B1=1 OB=1"),
        ("", "PLCT_COL_TYPE 0,2,B1", "B1=2 OB=1"),
        ("W1=3", "PLCT_COL_TYPE 0,W1,B1", "B1=4 OB=1"),
        ("W1=0FFFFh", "PLCT_COL_TYPE 0,W1,B1", "B1=0 OB=0 D2=3"),
        ("W1=9", "PLCT_GET_SELLINE 0,W1", "W1=0 OB=1"),
        ("", "PLCT_GET_LINESCOUNT 0,W1", "W1=2 OB=1"),
        ("", "PLCT_SET_SELLINE 0,2", "OB=0 D2=2"),
        // The cell beside it is not looked at, and not written to.
        ("W1=1", "PLCT_COL_INDEX B2,'Feed',B1", "B1=2 W1=1 OB=1"),
        ("W1=1 DWRD.LONG=1", "PLCT_COL_ID B2,LONG", "QWRD.LONG=6867006874656554h OB=1"),
        ("B2=9", "PLCT_COL_INDEX 0,'Feed',B1", "B1=2 B2=9 OB=1"),
        ("W1=-1 W2=9", "PLCT_COL_INDEX 0,'Feed',W1", "W1=2 W2=9 OB=1"),
        ("QWRD.AREA=-1", "PLCT_COL_INDEX 0,'Feed',DWRD.AREA", "DWRD.AREA=2 DWRD.(AREA+4)=-1 OB=1"),
        ("QWRD.AREA=-1", "PLCT_COL_TYPE 0,2,DWRD.AREA", "DWRD.AREA=2 DWRD.(AREA+4)=-1 OB=1"),
        // A number of 16 bits is not one of 8.
        ("W1=102h", "PLCT_COL_TYPE 0,W1,B1", "B1=0 OB=0 D2=3"),
        ("W1=101h", "PLCT_SET_SELLINE 0,W1", "OB=0 D2=2"),
        ("D1=10001h", "PLCT_SET_SELLINE 0,D1", "OB=0 D2=2"),
        (FEED, "PLCT_COL_INDEX B2,LONG,B1", "B1=2 B2=0 OB=1 D2=0"),
        ("", "PLCT_COL_INDEX BYTE.B2,'Feed',BYTE.AREA", "QWRD.AREA=2 OB=1"),
        ("", "PLCT_COL_INDEX 0,'Feed',WORD.AREA", "QWRD.AREA=2 OB=1"),
        ("D1=99", "PLCT_COL_INDEX 0,'Feed',D1", "D1=2 OB=1"),
        ("DWRD.AREA=99", "PLCT_COL_INDEX 0,'Feed',DWRD.AREA", "QWRD.AREA=2 OB=1"),
        ("DWRD.LONG=1", "PLCT_COL_ID B2,LONG", "QWRD.LONG=6867006874656554h OB=1"),
        ("DWRD.LONG=1", "PLCT_COL_ID BYTE.B2,LONG", "QWRD.LONG=6867006874656554h OB=1"),
        ("W1=3 D1=-1", "PLCT_COL_TYPE B2,WORD.W1,D1", "D1=4 OB=1"),
        ("DWRD.AREA=-1", "PLCT_COL_TYPE BYTE.B2,1,BYTE.AREA", "DWRD.AREA=0FFFFFF01h OB=1"),
        ("DWRD.AREA=-1", "PLCT_COL_TYPE 0,1,DWRD.AREA", "DWRD.AREA=1 OB=1"),
        ("W1=-1", "PLCT_COL_TYPE 0,2,W1", "W1=2 W2=0 OB=1"),
        ("DWRD.AREA=-1", "PLCT_COL_TYPE 0,2,WORD.AREA", "DWRD.AREA=0FFFF0002h OB=1"),
        ("B1=-1", "PLCT_GET_SELLINE B2,B1", "B1=0 B2=0 OB=1"),
        ("DWRD.AREA=-1", "PLCT_GET_SELLINE BYTE.B2,BYTE.AREA", "DWRD.AREA=0FFFFFF00h OB=1"),
        ("D1=-1", "PLCT_GET_SELLINE 0,D1", "D1=0 OB=1"),
        ("QWRD.AREA=-1", "PLCT_GET_SELLINE 0,DWRD.AREA", "DWRD.AREA=0 DWRD.(AREA+4)=-1 OB=1"),
        ("DWRD.AREA=-1", "PLCT_GET_SELLINE 0,WORD.AREA", "DWRD.AREA=0FFFF0000h OB=1"),
        ("B1=-1", "PLCT_GET_LINESCOUNT B2,B1", "B1=2 B2=0 OB=1"),
        ("DWRD.AREA=-1", "PLCT_GET_LINESCOUNT BYTE.B2,BYTE.AREA", "DWRD.AREA=0FFFFFF02h OB=1"),
        ("D1=-1", "PLCT_GET_LINESCOUNT 0,D1", "D1=2 OB=1"),
        ("QWRD.AREA=-1", "PLCT_GET_LINESCOUNT 0,DWRD.AREA", "DWRD.AREA=2 DWRD.(AREA+4)=-1 OB=1"),
        ("DWRD.AREA=-1", "PLCT_GET_LINESCOUNT 0,WORD.AREA", "DWRD.AREA=0FFFF0002h OB=1"),
        ("W1=-1", "PLCT_CHANGED B2,W1", "W1=0 W2=0 OB=1"),
        ("DWRD.AREA=-1", "PLCT_CHANGED BYTE.B2,BYTE.AREA", "DWRD.AREA=0FFFFFF00h OB=1"),
        ("D1=-1", "PLCT_CHANGED 0,D1", "D1=0 OB=1"),
        ("QWRD.AREA=-1", "PLCT_CHANGED 0,DWRD.AREA", "DWRD.AREA=0 DWRD.(AREA+4)=-1 OB=1"),
        ("DWRD.AREA=-1", "PLCT_CHANGED 0,WORD.AREA", "DWRD.AREA=0FFFF0000h OB=1"),
        ("B2=1", "PLCT_CHANGED B2,B1", "OB=0 D2=1"),
        ("B2=1", "PLCT_COL_TYPE B2,0,B1", "OB=0 D2=1"),
        ("B2=1", "PLCT_GET_SELLINE B2,B1", "OB=0 D2=1"),
        ("B2=1", "PLCT_GET_LINESCOUNT B2,B1", "OB=0 D2=1"),
        ("B2=1", "PLCT_SET_SELLINE B2,0", "OB=0 D2=1"),
    ]);
}

#[test]
fn values_are_read_at_the_width_of_their_target() {
    check(&[
        ("", "PLCT_GET_INT 0,0,1,D1", "D1=-3 D2=0 OB=1"),
        ("", "PLCT_GET_INT 0,0,1,B1", "B1=0FDh B2=0 OB=1"),
        ("", "PLCT_GET_INT 0,1,1,LONG+2", "QWRD.LONG=6867000000126261h OB=1"),
        ("", "PLCT_GET_REAL 0,0,2,R1", "REAL.R1=120.5 OB=1"),
        ("REAL.R1=1.0", "PLCT_GET_REAL 0,1,2,R1", "REAL.R1=0.0 OB=1"),
        ("W1=1", "PLCT_GET_STR 0,W1,0,LONG", "QWRD.LONG=6867007373617242h OB=1"),
        ("", "PLCT_GET_STR 0,0,0,SHORT", "DWRD.SHORT=00657453h BYTE.BEHIND=77h OB=1"),
        ("", "PLCT_GET_BIN 0,0,3,AREA+1", "QWRD.AREA=03020100h OB=1"),
        ("", "PLCT_GET_BIN 0,0,3,W1", "W1=0201h W2=0 OB=1"),
        ("W2=1", "PLCT_GET_INT B2,W1,W2,W1", "W1=0FFFDh W2=1 OB=1"),
        ("W2=1", "PLCT_GET_INT BYTE.B2,WORD.W1,WORD.W2,WORD.AREA", "QWRD.AREA=0FFFDh OB=1"),
        ("", "PLCT_GET_INT 0,0,1,DWRD.AREA", "QWRD.AREA=0FFFFFFFDh OB=1"),
        ("", "PLCT_GET_INT 0,0,1,BYTE.AREA", "QWRD.AREA=0FDh OB=1"),
        ("W2=2", "PLCT_GET_REAL B2,W1,W2,QWRD.R1", "REAL.R1=120.5 OB=1"),
        ("W2=2", "PLCT_GET_REAL BYTE.B2,WORD.W1,WORD.W2,REAL.R1", "REAL.R1=120.5 OB=1"),
        ("W1=1", "PLCT_GET_STR B2,W1,W2,LONG", "QWRD.LONG=6867007373617242h OB=1"),
        ("W1=1", "PLCT_GET_STR BYTE.B2,WORD.W1,WORD.W2,LONG", "QWRD.LONG=6867007373617242h OB=1"),
        ("W2=3", "PLCT_GET_BIN B2,W1,W2,AREA", "QWRD.AREA=030201h OB=1"),
        ("W2=3", "PLCT_GET_BIN BYTE.B2,WORD.W1,WORD.W2,AREA", "QWRD.AREA=030201h OB=1"),
        ("W1=100h", "PLCT_GET_INT 0,W1,1,D1", "OB=0 D2=2"),
        ("W2=101h", "PLCT_GET_INT 0,0,W2,D1", "OB=0 D2=3"),
        ("W1=100h", "PLCT_GET_REAL 0,W1,2,R1", "OB=0 D2=2"),
        ("W2=102h", "PLCT_GET_REAL 0,0,W2,R1", "OB=0 D2=3"),
        ("W1=100h", "PLCT_GET_STR 0,W1,0,LONG", "OB=0 D2=2"),
        ("W2=100h", "PLCT_GET_STR 0,0,W2,LONG", "OB=0 D2=3"),
        ("W1=100h", "PLCT_GET_BIN 0,W1,3,AREA", "OB=0 D2=2"),
        ("W2=103h", "PLCT_GET_BIN 0,0,W2,AREA", "OB=0 D2=3"),
        ("W1=100h", "PLCT_SET_INT 0,W1,1,D1", "OB=0 D2=2"),
        ("W2=101h", "PLCT_SET_INT 0,0,W2,D1", "OB=0 D2=3"),
        ("W1=100h", "PLCT_SET_REAL 0,W1,2,R1", "OB=0 D2=2"),
        ("W2=102h", "PLCT_SET_REAL 0,0,W2,R1", "OB=0 D2=3"),
        ("W1=100h", "PLCT_SET_STR 0,W1,0,LONG", "OB=0 D2=2"),
        ("W2=100h", "PLCT_SET_STR 0,0,W2,LONG", "OB=0 D2=3"),
        ("W1=100h", "PLCT_SET_BIN 0,W1,3,AREA", "OB=0 D2=2"),
        ("W2=103h", "PLCT_SET_BIN 0,0,W2,AREA", "OB=0 D2=3"),
        ("W1=1 D1=3", "PLCT_GET_STR B2,W1,W2,LONG", "QWRD.LONG=6867007373617242h OB=1"),
        ("B2=0 W1=1 W2=1", "PLCT_GET_INT B2,W1,W2,D1", "D1=18 OB=1"),
        ("B2=0 W1=1 W2=2", "PLCT_GET_REAL B2,0,W2,R1", "REAL.R1=120.5 OB=1"),
        ("B2=0 W1=1 W2=3", "PLCT_GET_BIN B2,0,W2,AREA", "QWRD.AREA=030201h OB=1"),
        ("", "PLCT_GET_INT 0,0,1,SHORT+1", "DWRD.SHORT=0FFFFFD63h BYTE.BEHIND=77h OB=1"),
        ("", "PLCT_GET_REAL 0,0,2,SHORT", "DWRD.SHORT=0 BYTE.BEHIND=77h OB=1"),
        ("", "PLCT_GET_REAL 0,0,1,R1", "REAL.R1=0.0 OB=0 D2=4"),
        ("", "PLCT_GET_REAL 0,2,2,R1", "REAL.R1=0.0 OB=0 D2=2"),
        ("", "PLCT_GET_STR 0,0,1,LONG", "QWRD.LONG=6867666564636261h OB=0 D2=4"),
        ("", "PLCT_GET_BIN 0,0,0,AREA", "QWRD.AREA=0 OB=0 D2=4"),
        ("", "PLCT_GET_BIN 0,0,4,AREA", "QWRD.AREA=0 OB=0 D2=3"),
        ("", "PLCT_SET_REAL 0,2,2,R1", "OB=0 D2=2"),
        ("", "PLCT_SET_STR 0,0,4,LONG", "OB=0 D2=3"),
        ("", "PLCT_SET_BIN 1,0,3,LONG", "OB=0 D2=1"),
        ("", "PLCT_GET_INT 0,2,1,D1", "D1=0 OB=0 D2=2"),
        ("", "PLCT_GET_INT 0,0,4,D1", "D1=0 OB=0 D2=3"),
        ("", "PLCT_GET_INT 0,0,2,D1", "D1=0 OB=0 D2=4"),
        ("", "PLCT_GET_STR 1,0,0,LONG", "QWRD.LONG=6867666564636261h OB=0 D2=1"),
    ]);
}

#[test]
fn values_are_written() {
    let rows = [
        ("B1=0FEh", "PLCT_SET_INT 0,0,1,B1", 0, 1, Value::Int(-2)),
        ("D1=80000000h", "PLCT_SET_INT 0,1,1,D1", 1, 1, Value::Int(-0x8000_0000)),
        ("", "PLCT_SET_INT 0,1,1,LONG", 1, 1, Value::Int(0x6463_6261)),
        ("REAL.R1=-0.25", "PLCT_SET_REAL 0,1,2,R1", 1, 2, Value::Real(-0.25)),
        ("", "PLCT_SET_STR 0,1,0,SHORT", 1, 0, Value::Text(text("cde"))),
        ("W1=1 W2=1 D1=0FFFFFFFEh", "PLCT_SET_INT B2,W1,W2,D1", 1, 1, Value::Int(-2)),
        ("W1=1 W2=1 D1=-7", "PLCT_SET_INT BYTE.B2,WORD.W1,WORD.W2,DWRD.D1", 1, 1, Value::Int(-7)),
        ("D1=1FEh", "PLCT_SET_INT 0,1,1,BYTE.D1", 1, 1, Value::Int(-2)),
        ("D1=1FFFEh", "PLCT_SET_INT 0,1,1,WORD.D1", 1, 1, Value::Int(-2)),
        ("W1=0FFFDh", "PLCT_SET_INT 0,1,1,W1", 1, 1, Value::Int(-3)),
        ("W1=0304h", "PLCT_SET_INT 0,1,1,W1", 1, 1, Value::Int(0x0304)),
        ("W1=1 D1=1", "PLCT_SET_STR B2,W1,W2,SHORT", 1, 0, Value::Text(text("cde"))),
        ("W1=1 W2=2 REAL.R1=2.5", "PLCT_SET_REAL B2,W1,W2,QWRD.R1", 1, 2, Value::Real(2.5)),
        ("W1=1 W2=2 REAL.R1=2.5", "PLCT_SET_REAL BYTE.B2,WORD.W1,WORD.W2,REAL.R1", 1, 2, Value::Real(2.5)),
        ("W1=1", "PLCT_SET_STR B2,W1,W2,SHORT", 1, 0, Value::Text(text("cde"))),
        ("W1=1", "PLCT_SET_STR BYTE.B2,WORD.W1,WORD.W2,SHORT", 1, 0, Value::Text(text("cde"))),
        ("W1=1 W2=3", "PLCT_SET_BIN B2,W1,W2,SHORT+1", 1, 3, Value::Bytes(vec![b'd', b'e', 0])),
        (
            "W1=1 W2=3",
            "PLCT_SET_BIN BYTE.B2,WORD.W1,WORD.W2,SHORT+1",
            1,
            3,
            Value::Bytes(vec![b'd', b'e', 0]),
        ),
        ("", "PLCT_SET_BIN 0,1,3,SHORT+1", 1, 3, Value::Bytes(vec![b'd', b'e', 0])),
    ];
    for (given, line, row, column, value) in rows {
        with_mutants(|| {
            let mut plc = plc(line);
            plc.set(given);
            plc.run(1);
            // Operands are read when the transfer begins.
            plc.set("B1=1 D1=1 REAL.R1=1.0 BYTE.SHORT=41h BYTE.(SHORT+1)=41h");
            let before = plc.control().data().tables[0].clone();
            assert_eq!(before, data().tables[0], "{line}");
            plc.run(1);
            assert_eq!(plc.differences("M=0 OB=1 D2=0"), [""; 0], "{line}");
            assert_eq!(plc.control().data().tables[0].value(row, column), Some(value.clone()), "{line}");
            let mut expected = before;
            assert!(expected.set(row, column, value.clone()));
            assert_eq!(plc.control().data().tables[0], expected, "{line}");
        });
    }
    let mut plc = plc("PLCT_SET_INT 0,0,2,D1");
    plc.run(2);
    assert_eq!(plc.differences("M=0 OB=0 D2=4"), [""; 0]);
    assert_eq!(plc.control().data(), &data());
}

#[test]
fn the_program_is_told_what_the_operator_changed() {
    let mut plc = plc("PLCT_CHANGED 0,B1");
    let ask = |plc: &mut Plc, expected: &str| {
        plc.set("M=1");
        plc.run(2);
        assert_eq!(plc.differences(expected), [""; 0]);
    };
    ask(&mut plc, "B1=0 M=0");
    assert!(plc.control().select_row(0, 1));
    assert!(plc.control().edit_table(0, 0, 1, Value::Int(5)));
    assert!(!plc.control().edit_table(0, 0, 1, Value::Real(5.0)));
    assert!(!plc.control().select_row(0, 2));
    // The item comes first.
    ask(&mut plc, "B1=1 M=0");
    ask(&mut plc, "B1=2 M=0");
    ask(&mut plc, "B1=0 M=0");
}

#[test]
fn a_line_is_selected_by_a_value_of_any_type() {
    for operands in ["0,B1", "B2,BYTE.B1", "BYTE.B2,CNST.1", "0,D1", "0,DWRD.D1", "0,WORD.W1"] {
        let mut plc = Plc::of(&format!(
            "MECH_BEGIN M / PLCT_SET_SELLINE {operands} / EX0 / PLCT_GET_SELLINE 0,W2 / EX0 / MECH_END M"
        ));
        plc.control().set_data(data());
        plc.set("M=1 B1=1 W1=1 D1=1 W2=9");
        plc.run(3);
        assert_eq!(plc.differences("W2=1 M=0"), [""; 0], "{operands}");
    }
}

#[test]
fn a_selected_line_stays_selected() {
    let lines = "MECH_BEGIN M / PLCT_SET_SELLINE 0,W1 / EX0 / PLCT_GET_SELLINE 0,W2 / EX0 / PLCT_CHANGED 0,B1 / EX0 / \
                 MECH_END M";
    let mut plc = Plc::of(lines);
    plc.control().set_data(data());
    plc.set("M=1 W1=1 B1=9");
    plc.run(4);
    // Three transfers, one cycle each; the next begins in the cycle in which the one before ends.
    assert_eq!(plc.differences("W2=1 B1=0 M=0"), [""; 0]);
    assert_eq!(plc.fault(), None);
}

#[test]
fn a_table_without_lines_and_one_without_columns() {
    let columns = vec![Column { id: text("Name"), kind: ValueKind::Text }];
    let tables = vec![Table { columns, rows: Vec::new() }, Table::default()];
    let rows = [
        ("PLCT_GET_LINESCOUNT 0,W1", "W1=0 OB=1 D2=0"),
        ("PLCT_GET_SELLINE 0,W1", "W1=7 OB=0 D2=2"),
        ("PLCT_SET_SELLINE 0,0", "W1=7 OB=0 D2=2"),
        ("PLCT_CHANGED 0,W1", "W1=0 OB=1 D2=0"),
        ("PLCT_COL_INDEX 0,'Name',W1", "W1=0 OB=1 D2=0"),
        ("PLCT_GET_STR 0,0,0,LONG", "W1=7 OB=0 D2=2"),
        ("PLCT_SET_STR 0,0,0,LONG", "W1=7 OB=0 D2=2"),
        ("PLCT_GET_STR 0,0,1,LONG", "W1=7 OB=0 D2=3"),
        ("PLCT_GET_LINESCOUNT 1,W1", "W1=0 OB=1 D2=0"),
        ("PLCT_COL_INDEX 1,'Name',W1", "W1=7 OB=0 D2=3"),
        ("PLCT_COL_TYPE 1,0,W1", "W1=7 OB=0 D2=3"),
        ("PLCT_GET_STR 1,0,0,LONG", "W1=7 OB=0 D2=3"),
        ("PLCT_GET_LINESCOUNT 2,W1", "W1=7 OB=0 D2=1"),
    ];
    let wrong = wrong_rows(&rows, |(line, then)| {
        let mut plc = plc(line);
        plc.control().set_data(ControlData { tables: tables.clone(), ..ControlData::default() });
        plc.set("W1=7");
        plc.run(2);
        plc.differences(&format!("M=0 QWRD.LONG=6867666564636261h {then}"))
            .into_iter()
            .chain(plc.fault())
            .collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
