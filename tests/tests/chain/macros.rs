//! User instructions and macros (manual 22).

use technol_analysis::project::FileReader;

use crate::frame;
use crate::plc::{Plc, build, check};

#[test]
fn a_call_does_what_its_lines_do() {
    check(&[
        (
            "IB=1",
            "DEF_T_MACRO COPY FROM,TO / LDR TMAC.FROM / WR TMAC.TO / END_T_MACRO T_END / \
             COPY I0,O0 / COPY -I1,O1 / COPY I1,O2",
            "OB=3",
        ),
        // The type is that of the operand.
        (
            "W1=258 D1=0",
            "DEF_T_MACRO TAKE FROM,TO / LOD TMAC.FROM / STO TMAC.TO / END_T_MACRO / TAKE W1,W2 / TAKE W1,D1 / TAKE CNST.7,B1",
            "W2=258 D1=258 B1=7",
        ),
        // Macros in macros, with and without TMAC.
        (
            "IB=1",
            "DEF_T_MACRO COPY FROM,TO / LDR TMAC.FROM / WR TMAC.TO / END_T_MACRO T_END / \
             DEF_T_MACRO TWICE FROM / COPY TMAC.FROM,O1 / COPY FROM,O3 / END_T_MACRO T_END / TWICE I0",
            "OB=0Ah",
        ),
        // Labels and cells of its own for each call.
        (
            "W1=200 W2=50",
            "DEF_T_MACRO LIMITED CELL / T_LOCAL SMALLER,OLD / DATA_LOCAL / OLD: DS 2 / DATA_LOCAL_END / LOD TMAC.CELL / \
             STO OLD / LE CNST.100 / JL1 SMALLER / LOD CNST.100 / STO TMAC.CELL / SMALLER: / END_T_MACRO T_END / \
             LIMITED W1 / LIMITED W2",
            "W1=100 W2=50",
        ),
        // Another word for it.
        (
            "IB=1",
            "DEF_T_MACRO COPY FROM,TO / LDR TMAC.FROM / WR TMAC.TO / END_T_MACRO T_END / \
             APPEND_T_MACRO SHOW,COPY,T_END / SHOW I0,O4",
            "OB=10h",
        ),
        // What opens an equation and what takes it back.
        (
            "IB=0Ch",
            "DEF_T_MACRO BOTH A,B / LDR TMAC.A / LA TMAC.B / END_T_MACRO T_PUSH / DEF_T_MACRO EITHER / LO / \
             END_T_MACRO T_POP / BOTH I0,I1 / BOTH I2,I3 / EITHER / WR O0",
            "OB=1",
        ),
        // An instruction replaced, which its body still means.
        (
            "B1=5",
            "DEF_T_MACRO INR / INR / STO B2 / END_T_MACRO / LOD B1 / INR / STO W1 / CONTROL_T_MACRO PRE / INR",
            "W1=6 B2=7",
        ),
    ]);
}

/// A project of two files.
struct TwoFiles(String);

impl FileReader for TwoFiles {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        match path {
            "plc.plc" => Ok(self.0.clone().into_bytes()),
            "more.inc" => {
                Ok(b"EQUI SEVEN,7\n DEF_T_MACRO COPY FROM,TO\n LOD TMAC.FROM\n STO TMAC.TO\n END_T_MACRO\n"
                    .to_vec())
            }
            _ => Err("no such file".to_owned()),
        }
    }
}

#[test]
fn what_an_included_file_defines_is_used() {
    let main = frame::program("W1: DS 2\nW2: DS 2", " COPY SEVEN,W1\n COPY W1,W2", "");
    let image = build(&TwoFiles(format!("T_INCLUDE more.inc\n{main}")), "plc.plc").image;
    let mut plc = Plc::from_image(image);
    plc.run(1);
    assert_eq!(plc.differences("W1=7 W2=7"), Vec::<String>::new());
}

#[test]
fn each_call_sees_its_own_edges() {
    let mut plc = Plc::of(
        "DEF_T_MACRO COUNTED FROM,CELL / T_LOCAL NO / EDGE_H TMAC.FROM / JL0 NO / LOD TMAC.CELL / INR / STO TMAC.CELL / NO: / \
         END_T_MACRO T_END / COUNTED I0,B1 / COUNTED I1,B2",
    );
    plc.run(1);
    plc.set("IB=1");
    plc.run(2);
    plc.set("IB=3");
    plc.run(2);
    plc.set("IB=2");
    plc.run(1);
    plc.set("IB=3");
    plc.run(1);
    assert_eq!(plc.differences("B1=2 B2=1"), Vec::<String>::new());
}
