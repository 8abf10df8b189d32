//! Moving data (manual 3.10 and 3.15).

use crate::frame;
use crate::plc::{Plc, check};

#[test]
fn loading() {
    check(&[
        ("B1=7Fh", "LOD B1", "DR64=7Fh"),
        ("B1=0FFh", "LOD B1", "DR64=0FFFFFFFFFFFFFFFFh"),
        ("W1=7FFFh", "LOD W1", "DR64=7FFFh"),
        ("W1=8000h", "LOD W1", "DR64=0FFFFFFFFFFFF8000h"),
        ("D1=80000000h", "LOD D1", "DR64=0FFFFFFFF80000000h"),
        (
            "QWRD.Q1=1122334455667788h",
            "LOD QWRD.Q1",
            "DR64=1122334455667788h DR32=55667788h DR16=7788h DR8=88h",
        ),
        ("W1=1234h", "LOD BYTE.W1", "DR64=34h"),
        ("W1=1234h", "LOD HIGH.W1", "DR64=12h"),
        ("W1=9234h", "LOD HIGH.W1", "DR64=0FFFFFFFFFFFFFF92h"),
        ("D1=11228344h", "LOD WORD.D1", "DR64=0FFFFFFFFFFFF8344h"),
        ("D1=11228344h", "LOD WORD.(D1+2)", "DR64=1122h"),
        ("W1=5", "LOD -W1", "DR64=0FFFFFFFFFFFFFFFBh"),
        ("B1=80h", "LOD -B1", "DR64=80h"),
        ("W1=8001h W2=1", "LOD -W1", "DR64=7FFFh"),
        (
            "DWRD.(AREA+4)=180AAh",
            "LOD CNST.4 / MOV BX,CX / LOD WORD.AREA[BX]",
            "DR64=0FFFFFFFFFFFF80AAh BX=4",
        ),
        ("", "LOD CNST.-5", "DR64=0FFFFFFFFFFFFFFFBh"),
        ("", "LOD CNST.0F0h", "DR64=0F0h"),
        ("", "LOD CNST.1011b", "DR64=11"),
        ("", "LOD CNST.10h+1", "DR64=11h"),
        ("", "LOD CNST.'A'", "DR64=41h"),
        ("", "LOD FIVE", "DR64=5"),
        ("REAL.R1=2.5", "LOD REAL.R1", "DR_REAL=2.5 DR64=2"),
        ("REAL.R1=-3.5", "LOD -REAL.R1", "DR_REAL=3.5 DR64=4"),
        ("", "LOD CNST.-4.8", "DR_REAL=-4.8 DR64=-5"),
        ("REAL.R1=1.0e300", "LOD REAL.R1", "DR_REAL=1.0e300 DR64=7FFFFFFFFFFFFFFFh"),
        ("REAL.R1=1.5 W1=7", "LOD REAL.R1 / LOD W1", "DR_REAL=1.5 DR64=7"),
        ("WORD.(AREA+4)=0AAh", "LOD CNST.4 / MOV BX,CX / LOD WORD.AREA[BX]", "DR64=0AAh BX=4"),
        ("IB=1", "LDR I0 / LOD CNST.0 / WR O0", "OB=1 DR64=0"),
    ]);
}

#[test]
fn storing() {
    const Q: &str = "QWRD.Q1=1122334455667788h";
    check(&[
        (Q, "LOD QWRD.Q1 / STO B1", "B1=88h B2=0 DR64=1122334455667788h"),
        (Q, "LOD QWRD.Q1 / STO W1", "W1=7788h W2=0"),
        (Q, "LOD QWRD.Q1 / STO D1", "D1=55667788h D2=0"),
        (Q, "LOD QWRD.Q1 / STO QWRD.AREA", "QWRD.AREA=1122334455667788h QWRD.(AREA+8)=0"),
        (Q, "LOD QWRD.Q1 / STO HIGH.W1", "W1=8800h"),
        (
            Q,
            "LOD QWRD.Q1 / LDR -I0 / STO1 BYTE.AREA / LDR I0 / STO1 BYTE.LONG",
            "WORD.AREA=88h WORD.LONG=6261h",
        ),
        (Q, "LOD QWRD.Q1 / LDR -I0 / STO1 W1 / LDR I0 / STO1 W2", "W1=7788h W2=0"),
        (Q, "LOD QWRD.Q1 / LDR -I0 / STO1 D1 / LDR I0 / STO1 D2", "D1=55667788h D2=0"),
        (Q, "LOD QWRD.Q1 / LDR -I0 / STO1 DWRD.AREA", "QWRD.AREA=55667788h"),
        (Q, "LOD QWRD.Q1 / LDR -I0 / STO1 HIGH.W1 / LDR I0 / STO1 HIGH.W2", "W1=8800h W2=0"),
        (
            Q,
            "LOD QWRD.Q1 / LDR -I0 / STO1 QWRD.Q2 / LDR I0 / STO1 QWRD.AREA",
            "QWRD.Q2=1122334455667788h QWRD.AREA=0",
        ),
        (
            Q,
            "LOD QWRD.Q1 / LDR I0 / STO0 BYTE.AREA / LDR -I0 / STO0 BYTE.LONG",
            "WORD.AREA=88h WORD.LONG=6261h",
        ),
        (Q, "LOD QWRD.Q1 / LDR I0 / STO0 W1 / LDR -I0 / STO0 W2", "W1=7788h W2=0"),
        (Q, "LOD QWRD.Q1 / LDR I0 / STO0 WORD.AREA / LDR -I0 / STO0 WORD.W2", "QWRD.AREA=7788h W2=0"),
        (Q, "LOD QWRD.Q1 / LDR I0 / STO0 D1 / LDR -I0 / STO0 D2", "D1=55667788h D2=0"),
        (Q, "LOD QWRD.Q1 / LDR I0 / STO0 DWRD.AREA", "QWRD.AREA=55667788h"),
        (Q, "LOD QWRD.Q1 / LDR I0 / STO0 HIGH.W1 / LDR -I0 / STO0 HIGH.W2", "W1=8800h W2=0"),
        (
            Q,
            "LOD QWRD.Q1 / LDR I0 / STO0 QWRD.Q2 / LDR -I0 / STO0 QWRD.AREA",
            "QWRD.Q2=1122334455667788h QWRD.AREA=0",
        ),
        ("", "LOD CNST.0.5 / LDR I0 / STO0 REAL.R1 / LDR -I0 / STO0 REAL.R2", "REAL.R1=0.5 REAL.R2=0.0"),
        ("W1=0FFFFh", "LOD CNST.1 / STO BYTE.W1", "W1=0FF01h"),
        ("", "LOD CNST.2.5 / STO REAL.R1 / STO W1", "REAL.R1=2.5 W1=2"),
        ("IB=1", "LOD FIVE / LDR I0 / STO1 B1 / LDR I0 / STO0 B2", "B1=5 B2=0"),
        ("IB=0", "LOD FIVE / LDR I0 / STO1 B1 / LDR I0 / STO0 B2", "B1=0 B2=5"),
        ("IB=1", "LOD CNST.-2 / LDR I0 / STO1 WORD.AREA", "QWRD.AREA=0FFFEh"),
        ("IB=1", "LOD CNST.0.5 / LDR I0 / STO1 REAL.R1 / LDR I0 / STO0 REAL.R2", "REAL.R1=0.5 REAL.R2=0.0"),
        ("", "LOD CNST.3 / MOV BX,CX / STO BYTE.AREA[BX]", "QWRD.AREA=03000000h"),
        ("", "LOD CNST.0.5 / LDR I0 / STO1 REAL.R1", "REAL.R1=0.0"),
    ]);
}

#[test]
fn moving() {
    check(&[
        ("B1=12h", "MOVE B2,B1", "B2=12h DR64=0"),
        ("W1=1234h", "MOVE W2,W1", "W2=1234h"),
        ("D1=12345678h", "MOVE D2,D1", "D2=12345678h"),
        ("W1=1234h W2=0FFFFh", "MOVE BYTE.W2,BYTE.(W1+1)", "W2=0FF12h"),
        ("QWRD.Q1=1122334455667788h", "MOVE QWRD.Q2,QWRD.Q1", "QWRD.Q2=1122334455667788h"),
        ("REAL.R1=0.1", "MOVE REAL.R2,REAL.R1", "REAL.R2=0.1 DR_REAL=0.0"),
        ("W1=1234h W2=0FFFFh", "MOVE HIGH.W2,HIGH.W1", "W2=12FFh"),
        ("D1=11223344h", "MOVE WORD.AREA,WORD.D1", "QWRD.AREA=3344h"),
        ("QWRD.Q1=1122334455667788h", "MOVE DWRD.AREA,DWRD.Q1", "QWRD.AREA=55667788h"),
        ("B1=12h W1=7", "LDR -I0 / MOVE1 B2,B1", "B2=12h W1=7"),
        ("D1=11223344h", "LDR -I0 / MOVE1 D2,D1", "D2=11223344h"),
        ("D1=11223344h", "LDR -I0 / MOVE1 BYTE.AREA,BYTE.D1", "QWRD.AREA=44h"),
        ("D1=11223344h", "LDR -I0 / MOVE1 WORD.AREA,WORD.D1", "QWRD.AREA=3344h"),
        ("QWRD.Q1=1122334455667788h", "LDR -I0 / MOVE1 DWRD.AREA,DWRD.Q1", "QWRD.AREA=55667788h"),
        ("W1=1234h W2=0FFFFh", "LDR -I0 / MOVE1 HIGH.W2,HIGH.W1", "W2=12FFh"),
        ("QWRD.Q1=1122334455667788h", "LDR -I0 / MOVE1 QWRD.Q2,QWRD.Q1", "QWRD.Q2=1122334455667788h"),
        ("REAL.R1=0.1", "LDR -I0 / MOVE1 REAL.R2,REAL.R1", "REAL.R2=0.1 DR_REAL=0.0"),
        // MOVE does not ask for RLO, MOVE1 does.
        ("B1=12h B2=34h W1=5566h", "LDR -I0 / MOVE B2,B1", "B2=12h W1=5566h"),
        ("W1=1234h", "LDR -I0 / MOVE W2,W1", "W2=1234h"),
        ("D1=11223344h", "LDR -I0 / MOVE D2,D1", "D2=11223344h"),
        ("QWRD.Q1=1122334455667788h", "LDR -I0 / MOVE QWRD.Q2,QWRD.Q1", "QWRD.Q2=1122334455667788h"),
        ("REAL.R1=0.1", "LDR -I0 / MOVE REAL.R2,REAL.R1", "REAL.R2=0.1"),
        ("B1=12h", "LDR I0 / MOVE1 B2,B1", "B2=0"),
        ("D1=11223344h", "LDR I0 / MOVE1 D2,D1", "D2=0"),
        ("QWRD.Q1=1122334455667788h", "LDR I0 / MOVE1 QWRD.Q2,QWRD.Q1", "QWRD.Q2=0"),
        ("REAL.R1=0.1", "LDR I0 / MOVE1 REAL.R2,REAL.R1", "REAL.R2=0.0"),
        ("IB=1 W1=7", "LDR I0 / MOVE1 W2,W1", "W2=7 RLO=1"),
        ("IB=0 W1=7", "LDR I0 / MOVE1 W2,W1", "W2=0 RLO=0"),
        ("QWRD.Q1=1122334455667788h", "MV Q1,Q2,3", "QWRD.Q2=667788h"),
        // The areas overlap.
        ("QWRD.AREA=04030201h", "MV AREA,AREA+1,4", "QWRD.AREA=0403020101h"),
        ("QWRD.AREA=0504030201h", "MV AREA+1,AREA,4", "QWRD.AREA=0505040302h"),
        ("B2=1 W1=2 W2=3 D1=4 D2=5", "CLEAR W1,D1", "B2=1 W1=0 W2=0 D1=0 D2=5"),
        ("B2=1 AREA.I0=1 R1.I0=1", "CLEAR GLOBAL,ALL", "B2=0 QWRD.AREA=0 QWRD.R1=0"),
    ]);
}

#[test]
fn local_cells_and_structures() {
    let local = "DATA_LOCAL / KEPT: DS 2 / DATA_LOCAL_END";
    // INTERNAL is what DATA_LOCAL declares.
    let lines = format!(
        "{local} / LOD KEPT / STO W1 / LOD CNST.300 / STO KEPT / LDR I0 / JL0 L / CLEAR INTERNAL,ALL / L:"
    );
    let mut plc = Plc::of(&lines);
    plc.run(2);
    assert_eq!(plc.differences("W1=300"), [""; 0]);
    plc.set("I0=1");
    plc.run(2);
    assert_eq!(plc.differences("W1=0 W2=0 I0=1"), [""; 0]);
    // Offsets 0, 1, 3 and 7; the last array ends at 31.
    let structure = "PART STRUC\nKIND DB ?\nCOUNT DW ?\nPLACE DD ?\nSUMS DQ 3 DUP (?)\nPART ENDS\n";
    let main = " LOD AREA.KIND\n STO D1\n LOD AREA.COUNT\n STO D2\n LOD AREA.PLACE\n STO QWRD.Q1\n LOD QWRD.AREA.SUMS\n STO QWRD.Q2\n \
                LOD CNST.77\n STO QWRD.(AREA+SUMS+8)\n LOD CNST.-1\n STO AREA.COUNT";
    let data = format!("{structure}AREA: DS 40\nD1: DS 4\nD2: DS 4\nQ1: DS 8\nQ2: DS 8");
    let mut plc = Plc::from_source(&frame::program(&data, main, ""));
    plc.set("QWRD.AREA=8877665544332281h QWRD.(AREA+8)=1011121314151617h");
    plc.run(1);
    assert_eq!(
        plc.differences("D1=0FFFFFF81h D2=3322h QWRD.Q1=77665544h QWRD.Q2=1112131415161788h QWRD.(AREA+15)=77 DWRD.AREA=44FFFF81h"),
        [""; 0]
    );
}

#[test]
fn between_the_bit_and_the_data_register() {
    const Q: &str = "QWRD.Q1=1122334455667788h";
    check(&[
        ("W1=0", "LOD W1 / CONDR / WR O0", "OB=0"),
        ("W1=8000h", "LOD W1 / CONDR / WR O0", "OB=1"),
        ("D1=10000h", "LOD D1 / CONDR / WR O0", "OB=0"),
        ("D1=10000h", "LOD D1 / CONDR DWRD / WR O0", "OB=1"),
        ("QWRD.Q1=100000000h", "LOD QWRD.Q1 / CONDR DWRD / WR O0", "OB=0"),
        ("W1=8", "LOD W1 / CONDR 3 / WR O0 / CONDR 2 / WR O1", "OB=1"),
        ("D1=80000000h", "LOD D1 / CONDR 31 / WR O0", "OB=1"),
        (Q, "LOD QWRD.Q1 / LDR -I0 / CONRD", "DR64=112233445566FFFFh RLO=1"),
        (Q, "LOD QWRD.Q1 / LDR I0 / CONRD", "DR64=1122334455660000h"),
        (Q, "LOD QWRD.Q1 / LDR -I0 / CONRD DWRD", "DR64=11223344FFFFFFFFh"),
        (Q, "LOD QWRD.Q1 / LDR I0 / CONRD DWRD", "DR64=1122334400000000h"),
    ]);
}
