//! Arithmetic (manual 3.12, 3.13 and 3.16). DR is loaded with all 64 bits, so that it shows which of them change.

use crate::plc::{Plc, check};

#[test]
fn adding_and_subtracting() {
    check(&[
        ("QWRD.Q1=11223344556677FFh B1=1", "LOD QWRD.Q1 / AD B1", "DR64=1122334455667700h"),
        ("QWRD.Q1=112233445566FFFFh W1=1", "LOD QWRD.Q1 / AD W1", "DR64=1122334455660000h"),
        ("QWRD.Q1=11223344FFFFFFFFh D1=1", "LOD QWRD.Q1 / AD D1", "DR64=1122334400000000h"),
        ("QWRD.Q1=0FFFFFFFFh QWRD.Q2=1", "LOD QWRD.Q1 / AD QWRD.Q2", "DR64=100000000h"),
        ("QWRD.Q1=11223344FFFFFFFFh", "LOD QWRD.Q1 / AD CNST.1", "DR64=1122334400000000h"),
        ("QWRD.Q1=1122334455667788h", "LOD QWRD.Q1 / AD FIVE", "DR64=112233445566778Dh"),
        ("B1=0F0h W1=10h", "LOD BYTE.B1 / AD WORD.W1", "DR64=0FFFFFFFFFFFF0000h"),
        ("W1=0300h", "LOD CNST.4 / AD HIGH.W1", "DR64=7"),
        ("REAL.R1=1.0", "LOD CNST.1.5 / AD REAL.R1", "DR_REAL=2.5 DR64=2"),
        ("", "LOD CNST.1.5 / AD CNST.2.25", "DR_REAL=3.75 DR64=4"),
        ("REAL.R1=2.25", "LOD CNST.1.5 / AD REAL.R1", "DR_REAL=3.75 DR64=4"),
        ("B1=1", "LOD CNST.0 / SU B1", "DR64=0FFh"),
        ("W1=1", "LOD CNST.0 / SU W1", "DR64=0FFFFh"),
        ("D1=1", "LOD CNST.0 / SU D1", "DR64=0FFFFFFFFh"),
        ("QWRD.Q1=1", "LOD CNST.0 / SU QWRD.Q1", "DR64=0FFFFFFFFFFFFFFFFh"),
        ("", "LOD CNST.10 / SU CNST.3", "DR64=7"),
        ("W1=1203h", "LOD CNST.15h / SU HIGH.W1", "DR64=3"),
        ("REAL.R1=0.5", "LOD CNST.0.25 / SU REAL.R1", "DR_REAL=-0.25 DR64=0"),
        ("REAL.R1=0.5", "LOD CNST.3.75 / SU REAL.R1", "DR_REAL=3.25 DR64=3"),
        ("QWRD.Q1=1122334400000000h", "LOD QWRD.Q1 / SU CNST.1", "DR64=11223344FFFFFFFFh"),
    ]);
}

#[test]
fn multiplying_and_dividing() {
    check(&[
        ("B1=0FEh", "LOD CNST.100 / MULB B1", "DR64=-200"),
        ("B1=80h", "LOD CNST.-128 / MULB B1", "DR64=4000h"),
        // DR8 is 2, whatever lies above it.
        ("QWRD.Q1=1122334455667702h B1=3", "LOD QWRD.Q1 / MULB B1", "DR64=6"),
        ("W1=0FFFFh", "LOD CNST.1000 / MULB W1", "DR64=-1000"),
        ("W1=7FFFh", "LOD W1 / MULB W1", "DR64=3FFF0001h"),
        ("D1=100000", "LOD D1 / MULB D1", "DR64=10000000000"),
        ("D1=100000", "LOD D1 / MULB CNST.-3", "DR64=-300000"),
        ("W1=0200h", "LOD CNST.9 / MULB HIGH.W1", "DR64=18"),
        ("REAL.R1=-2.0", "LOD CNST.1.5 / MULB REAL.R1", "DR_REAL=-3.0 DR64=-3"),
        ("B1=2", "LOD CNST.7 / DIVB B1", "DR64=3"),
        ("B1=2", "LOD CNST.-7 / DIVB B1", "DR64=-3"),
        ("B1=-2", "LOD CNST.7 / DIVB B1", "DR64=-3"),
        ("B1=-2", "LOD CNST.-7 / DIVB B1", "DR64=3"),
        ("QWRD.Q1=7FFFFFFFh", "LOD QWRD.Q1 / DIVB CNST.-1", "DR64=-2147483647"),
        ("QWRD.Q1=80000000h", "LOD QWRD.Q1 / DIVB CNST.-1", "DR64=-2147483648"),
        // 8000h of 16 bits by a BYTE: the quotient is that of longer numbers.
        ("W1=8000h B1=-1", "LOD W1 / DIVB B1", "DR64=32768"),
        // A BYTE divides DR16, a WORD DR32, a DWORD and constants DR64.
        ("QWRD.Q1=1122334455660064h B1=10", "LOD QWRD.Q1 / DIVB B1", "DR64=10"),
        ("QWRD.Q1=11223344000186A0h W1=7", "LOD QWRD.Q1 / DIVB W1", "DR64=14285"),
        ("QWRD.Q1=10000000000 D1=100000", "LOD QWRD.Q1 / DIVB D1", "DR64=100000"),
        ("QWRD.Q1=10000000000", "LOD QWRD.Q1 / DIVB CNST.-100000", "DR64=-100000"),
        ("REAL.R1=2.0", "LOD CNST.7.0 / DIVB REAL.R1", "DR_REAL=3.5 DR64=4"),
        ("", "LOD CNST.7.0 / DIVB CNST.2.0", "DR_REAL=3.5 DR64=4"),
        ("W1=300 W2=7", "LOD W1 / MULB W2 / DIVB CNST.100 / STO W1", "W1=21"),
    ]);
}

#[test]
fn bytes_of_bits() {
    const Q: &str = "QWRD.Q1=1122334455667788h B1=0Fh W1=0FFFFh D1=0FFFF0000h D2=0F0F0F0Fh \
                     QWRD.Q2=0FF000000000000FFh";
    check(&[
        (Q, "LOD QWRD.Q1 / ORB B1", "DR64=112233445566778Fh"),
        (Q, "LOD QWRD.Q1 / ORB W1", "DR64=112233445566FFFFh"),
        (Q, "LOD QWRD.Q1 / ORB D1", "DR64=11223344FFFF7788h"),
        (Q, "LOD QWRD.Q1 / ORB QWRD.Q2", "DR64=0FF223344556677FFh"),
        (Q, "LOD QWRD.Q1 / ANDB B1", "DR64=1122334455667708h"),
        (Q, "LOD QWRD.Q1 / ANDB D1", "DR64=1122334455660000h"),
        (Q, "LOD QWRD.Q1 / ANDB QWRD.Q2", "DR64=1100000000000088h"),
        (Q, "LOD QWRD.Q1 / ANDB CNST.0FFh", "DR64=1122334400000088h"),
        (Q, "LOD QWRD.Q1 / XORB B1", "DR64=1122334455667787h"),
        (Q, "LOD QWRD.Q1 / XORB W1", "DR64=1122334455668877h"),
        (Q, "LOD QWRD.Q1 / XORB QWRD.Q2", "DR64=0EE22334455667777h"),
        (Q, "LOD QWRD.Q1 / XORB D1", "DR64=11223344AA997788h"),
        (Q, "LOD QWRD.Q1 / ORB CNST.0FFh", "DR64=11223344556677FFh"),
        (Q, "LOD QWRD.Q1 / XORB CNST.0FFh", "DR64=1122334455667777h"),
    ]);
}

#[test]
fn a_prefix_gives_the_width() {
    const ONES: &str = "QWRD.Q1=11223344FFFFFFFFh DWRD.AREA=04030201h D1=04030201h D2=1 W1=0300h";
    const ZEROS: &str = "QWRD.Q1=1122334400000000h DWRD.AREA=04030201h W1=0300h";
    const SUM: &str = "QWRD.Q1=1122334455667788h DWRD.AREA=04030201h";
    const SIGNED: &str = "BYTE.AREA=-2 WORD.(AREA+2)=-3 DWRD.(AREA+4)=25 W1=0300h";
    check(&[
        (SUM, "LOD QWRD.Q1 / AD BYTE.AREA", "DR64=1122334455667789h"),
        (SUM, "LOD QWRD.Q1 / AD DWRD.AREA", "DR64=1122334459697989h"),
        (SUM, "LOD QWRD.Q1 / SU BYTE.AREA", "DR64=1122334455667787h"),
        (SUM, "LOD QWRD.Q1 / SU WORD.AREA", "DR64=1122334455667587h"),
        (SUM, "LOD QWRD.Q1 / SU DWRD.AREA", "DR64=1122334451637587h"),
        (SUM, "LOD QWRD.Q1 / SU 8", "DR64=1122334455667780h"),
        (ZEROS, "LOD QWRD.Q1 / ORB BYTE.AREA", "DR64=1122334400000001h"),
        (ZEROS, "LOD QWRD.Q1 / ORB WORD.AREA", "DR64=1122334400000201h"),
        (ZEROS, "LOD QWRD.Q1 / ORB DWRD.AREA", "DR64=1122334404030201h"),
        (ZEROS, "LOD QWRD.Q1 / ORB HIGH.W1", "DR64=1122334400000003h"),
        (ZEROS, "LOD QWRD.Q1 / ORB CNST.8000000Fh", "DR64=112233448000000Fh"),
        (ZEROS, "LOD QWRD.Q1 / ORB 8", "DR64=1122334400000008h"),
        (ONES, "LOD QWRD.Q1 / XORB BYTE.AREA", "DR64=11223344FFFFFFFEh"),
        (ONES, "LOD QWRD.Q1 / XORB WORD.AREA", "DR64=11223344FFFFFDFEh"),
        (ONES, "LOD QWRD.Q1 / XORB DWRD.AREA", "DR64=11223344FBFCFDFEh"),
        (ONES, "LOD QWRD.Q1 / XORB D1", "DR64=11223344FBFCFDFEh"),
        (ONES, "LOD QWRD.Q1 / XORB HIGH.W1", "DR64=11223344FFFFFFFCh"),
        (ONES, "LOD QWRD.Q1 / XORB CNST.800000F0h", "DR64=112233447FFFFF0Fh"),
        (ONES, "LOD QWRD.Q1 / XORB 8", "DR64=11223344FFFFFFF7h"),
        (ONES, "LOD QWRD.Q1 / ANDB BYTE.AREA", "DR64=11223344FFFFFF01h"),
        (ONES, "LOD QWRD.Q1 / ANDB WORD.AREA", "DR64=11223344FFFF0201h"),
        (ONES, "LOD QWRD.Q1 / ANDB W1", "DR64=11223344FFFF0300h"),
        (ONES, "LOD QWRD.Q1 / ANDB DWRD.AREA", "DR64=1122334404030201h"),
        (ONES, "LOD QWRD.Q1 / ANDB HIGH.W1", "DR64=11223344FFFFFF03h"),
        (ONES, "LOD QWRD.Q1 / ANDB 8", "DR64=1122334400000008h"),
        (SIGNED, "LOD CNST.3 / MULB BYTE.AREA", "DR64=-6"),
        (SIGNED, "LOD CNST.3 / MULB WORD.(AREA+2)", "DR64=-9"),
        (SIGNED, "LOD CNST.3 / MULB DWRD.(AREA+4)", "DR64=75"),
        ("", "LOD CNST.3 / MULB 7", "DR64=21"),
        (SIGNED, "LOD CNST.100 / DIVB BYTE.AREA", "DR64=-50"),
        (SIGNED, "LOD CNST.100 / DIVB WORD.(AREA+2)", "DR64=-33"),
        (SIGNED, "LOD CNST.100 / DIVB DWRD.(AREA+4)", "DR64=4"),
        (SIGNED, "LOD CNST.100 / DIVB HIGH.W1", "DR64=33"),
        ("", "LOD CNST.100 / DIVB 7", "DR64=14"),
    ]);
}

#[test]
fn one_operand() {
    check(&[
        ("QWRD.Q1=112233445566FFFFh", "LOD QWRD.Q1 / INR", "DR64=1122334455660000h"),
        ("QWRD.Q1=11223344FFFFFFFFh", "LOD QWRD.Q1 / INR DWRD", "DR64=1122334400000000h"),
        ("QWRD.Q1=0FFFFFFFFh", "LOD QWRD.Q1 / INR QWRD", "DR64=100000000h"),
        ("", "LOD CNST.1.5 / INR REAL", "DR_REAL=2.5 DR64=2"),
        ("QWRD.Q1=1122334455660000h", "LOD QWRD.Q1 / DCR", "DR64=112233445566FFFFh"),
        ("QWRD.Q1=1122334400000000h", "LOD QWRD.Q1 / DCR DWRD", "DR64=11223344FFFFFFFFh"),
        ("", "LOD CNST.0 / DCR QWRD", "DR64=-1"),
        ("", "LOD CNST.0.5 / DCR REAL", "DR_REAL=-0.5 DR64=0"),
        ("", "LOD CNST.5.25 / INR REAL", "DR_REAL=6.25 DR64=6"),
        ("", "LOD CNST.5.25 / DCR REAL", "DR_REAL=4.25 DR64=4"),
        ("QWRD.Q1=100000000h", "LOD QWRD.Q1 / DCR QWRD", "DR64=0FFFFFFFFh"),
        ("QWRD.Q1=1122334455660001h", "LOD QWRD.Q1 / INV", "DR64=112233445566FFFFh"),
        ("QWRD.Q1=1122334400000001h", "LOD QWRD.Q1 / INV DWRD", "DR64=11223344FFFFFFFFh"),
        ("QWRD.Q1=1", "LOD QWRD.Q1 / INV QWRD", "DR64=-1"),
        ("W1=8000h", "LOD W1 / INV", "DR16=8000h"),
        ("", "LOD CNST.2.5 / INV REAL", "DR_REAL=-2.5 DR64=-2"),
        ("QWRD.Q1=112233445566FFFEh", "LOD QWRD.Q1 / ABS", "DR64=1122334455660002h"),
        ("QWRD.Q1=11223344FFFFFFFEh", "LOD QWRD.Q1 / ABS DWRD", "DR64=1122334400000002h"),
        ("", "LOD CNST.-9 / ABS QWRD", "DR64=9"),
        ("", "LOD CNST.-1.5 / ABS REAL", "DR_REAL=1.5 DR64=2"),
        ("W1=5", "LOD W1 / ABS", "DR64=5"),
        ("QWRD.Q1=1122334400000005h", "LOD QWRD.Q1 / ABS DWRD", "DR64=1122334400000005h"),
        ("", "LOD CNST.9 / ABS QWRD", "DR64=9"),
        ("", "LOD CNST.2.5 / ABS REAL", "DR_REAL=2.5 DR64=2"),
        // The most negative number has no opposite.
        ("W1=8000h", "LOD W1 / ABS", "DR64=0FFFFFFFFFFFF8000h"),
        ("W1=0FFFEh", "LOD W1 / REAL", "DR_REAL=-2.0 DR64=-2"),
        ("QWRD.Q1=1122334455660003h", "LOD QWRD.Q1 / REAL", "DR_REAL=3.0 DR64=3"),
        ("D1=0FFFFFFF6h", "LOD D1 / REAL DWRD", "DR_REAL=-10.0 DR64=-10"),
        ("QWRD.Q1=10000000000", "LOD QWRD.Q1 / REAL QWRD", "DR_REAL=10000000000.0 DR64=10000000000"),
        ("QWRD.Q1=1122334455668003h", "LOD QWRD.Q1 / REAL", "DR_REAL=-32765.0 DR64=-32765"),
        ("QWRD.Q1=1122334487654321h", "LOD QWRD.Q1 / REAL DWRD", "DR_REAL=-2023406815.0 DR64=-2023406815"),
    ]);
}

#[test]
fn decimal_numbers() {
    check(&[
        ("QWRD.Q1=1122334455660199h", "LOD QWRD.Q1 / INRBCD", "DR64=1122334455660200h"),
        ("W1=9999h", "LOD W1 / INRBCD", "DR16=0"),
        ("QWRD.Q1=1122334455661234h", "LOD QWRD.Q1 / BIN", "DR64=11223344556604D2h"),
        ("QWRD.Q1=1122334412345678h", "LOD QWRD.Q1 / BIN DWRD", "DR64=1122334400BC614Eh"),
        ("QWRD.Q1=1122334480000012h", "LOD QWRD.Q1 / BIN DWRD", "DR64=11223344FFFFFFF4h"),
        ("QWRD.Q1=11223344556604D2h", "LOD QWRD.Q1 / BCD", "DR64=1122334455661234h"),
        ("QWRD.Q1=1122334400BC614Eh", "LOD QWRD.Q1 / BCD DWRD", "DR64=1122334412345678h"),
        // The largest.
        ("W1=9999h", "LOD W1 / BIN", "DR16=9999"),
        ("W1=9999", "LOD W1 / BCD", "DR16=9999h"),
        ("D1=79999999h", "LOD D1 / BIN DWRD", "DR32=79999999"),
        ("D1=0F9999999h", "LOD D1 / BIN DWRD", "DR32=-79999999"),
        ("D1=99999999", "LOD D1 / BCD DWRD", "DR32=99999999h"),
    ]);
}

#[test]
fn shifting() {
    const Q: &str = "QWRD.Q1=1122334455668011h B1=4 W1=0800h";
    check(&[
        (Q, "LOD QWRD.Q1 / RL CNST.1", "DR64=1122334455660022h"),
        (Q, "LOD QWRD.Q1 / RL B1", "DR64=1122334455660110h"),
        (Q, "LOD QWRD.Q1 / RL HIGH.W1", "DR64=1122334455661100h"),
        (Q, "LOD QWRD.Q1 / RL CNST.4,DWRD", "DR64=1122334456680110h"),
        (Q, "LOD QWRD.Q1 / RL CNST.8,QWRD", "DR64=2233445566801100h"),
        (Q, "LOD QWRD.Q1 / RR CNST.1", "DR64=1122334455664008h"),
        (Q, "LOD QWRD.Q1 / RL BYTE.B1", "DR64=1122334455660110h"),
        (Q, "LOD QWRD.Q1 / RL 2", "DR64=1122334455660044h"),
        (Q, "LOD QWRD.Q1 / RR BYTE.B1", "DR64=1122334455660801h"),
        (Q, "LOD QWRD.Q1 / RR HIGH.W1", "DR64=1122334455660080h"),
        (Q, "LOD QWRD.Q1 / RR 2", "DR64=1122334455662004h"),
        (Q, "LOD QWRD.Q1 / RR B1,DWRD", "DR64=1122334405566801h"),
        (Q, "LOD QWRD.Q1 / RR CNST.32,QWRD", "DR64=11223344h"),
        (Q, "LOD QWRD.Q1 / RR B1,QWRD", "DR64=0112233445566801h"),
        // By nothing, by all but one bit, by the whole width.
        (Q, "LOD QWRD.Q1 / RL CNST.0 / RR CNST.0,DWRD", "DR64=1122334455668011h"),
        (Q, "LOD QWRD.Q1 / RR CNST.15", "DR64=1122334455660001h"),
        (Q, "LOD QWRD.Q1 / RR CNST.4,DWRD", "DR64=1122334405566801h"),
        (Q, "LOD QWRD.Q1 / RR CNST.16", "DR64=1122334455660000h"),
        (Q, "LOD QWRD.Q1 / RL CNST.15", "DR64=1122334455668000h"),
        (Q, "LOD QWRD.Q1 / RL CNST.31,DWRD", "DR64=1122334480000000h"),
        (Q, "LOD QWRD.Q1 / RL CNST.32,DWRD", "DR64=1122334400000000h"),
        (Q, "LOD QWRD.Q1 / RR CNST.64,QWRD", "DR64=0"),
        ("", "LOD CNST.-1 / RR CNST.60,QWRD", "DR64=0Fh"),
        ("B1=16", "LOD CNST.-1 / RL B1", "DR64=0FFFFFFFFFFFF0000h"),
        ("B1=255", "LOD CNST.-1 / RR B1,QWRD", "DR64=0"),
    ]);
}

#[test]
fn what_has_no_result_stops_the_program() {
    for (given, lines, why) in [
        ("", "LOD FIVE / DIVB W1", "division by zero"),
        ("", "LOD FIVE / DIVB B1", "division by zero"),
        ("", "LOD FIVE / DIVB D1", "division by zero"),
        ("", "LOD CNST.0.0 / DIVB REAL.R1", "division by zero"),
        ("REAL.R1=-0.0", "LOD CNST.1.5 / DIVB REAL.R1", "division by zero"),
        ("QWRD.Q1=100000000h", "LOD QWRD.Q1 / DIVB CNST.1", "quotient"),
        ("QWRD.Q1=80000000h", "LOD QWRD.Q1 / DIVB CNST.1", "quotient"),
        ("QWRD.Q1=80000000h W1=-1", "LOD QWRD.Q1 / DIVB W1", "quotient"),
        ("QWRD.Q1=8000000000000000h D1=-1", "LOD QWRD.Q1 / DIVB D1", "quotient"),
        ("D1=1A000000h", "LOD D1 / BIN DWRD", "BCD"),
        ("D1=100000000", "LOD D1 / BCD DWRD", "BCD"),
        ("W1=-1", "LOD W1 / BCD", "BCD"),
        ("D1=-1", "LOD D1 / BCD DWRD", "BCD"),
        ("W1=0A000h", "LOD W1 / INRBCD", "BCD"),
        ("B1=9Ah", "LDR -I0 / CUBCD B1", "BCD"),
        ("W1=0A00h", "LDR -I0 / CUBCD W1", "BCD"),
        ("W1=0Ah", "LOD W1 / BCDSTR LONG", "BCD"),
        ("W1=12A4h", "LOD W1 / BIN", "BCD"),
        ("W1=10000", "LOD W1 / BCD", "BCD"),
        ("W1=009Ah", "LOD W1 / INRBCD", "BCD"),
    ] {
        let mut plc = Plc::of(&format!("{lines} / FL 1,O0"));
        plc.set(given);
        plc.run(1);
        let fault = plc.fault().unwrap_or_else(|| panic!("{lines} goes on"));
        assert!(fault.contains(why), "{lines}: {fault}");
        assert_eq!(plc.differences("O0=0"), [""; 0], "nothing is executed after it");
    }
}
