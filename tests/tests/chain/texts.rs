//! Texts and byte strings (manual 3.18). `abc` in memory is 636261h.

use crate::plc::check;

#[test]
fn copying_texts() {
    check(&[
        // The end mark goes along, so the target gets shorter.
        ("", "STRCPY LONG,SHORT", "QWRD.LONG=6867666500656463h BYTE.(LONG+8)=0"),
        ("", "STRCPY LONG,'xy'", "QWRD.LONG=6867666564007978h"),
        ("", "STRCPY LONG,SHORT,0", "QWRD.LONG=6867666564636261h"),
        ("", "STRCPY LONG,SHORT,3", "QWRD.LONG=6867666564656463h"),
        ("", "STRCPY LONG,SHORT,4", "QWRD.LONG=6867666500656463h"),
        // As many characters as were asked for, and no end mark.
        ("", "STRCPY LONG,SHORT,2", "QWRD.LONG=6867666564636463h"),
        ("", "STRCPY LONG,MIDDLE,20", "QWRD.LONG=6867006564636261h"),
        // The target's size is the end; the byte behind its characters stays 0.
        ("", "STRCPY SHORT,LONG", "DWRD.SHORT=00636261h BYTE.(SHORT+4)=77h"),
        ("", "STRCPY SHORT,LONG,7", "DWRD.SHORT=00636261h BYTE.(SHORT+4)=77h"),
        ("", "STRCPY LONG+6,MIDDLE", "QWRD.LONG=6261666564636261h BYTE.(LONG+8)=0"),
        ("", "STRCPY LONG,MIDDLE+3", "QWRD.LONG=6867666564006564h"),
        ("", "LOD CNST.5 / MOV BX,CX / STRCPY LONG[BX],SHORT,2", "QWRD.LONG=6864636564636261h"),
        // Nothing lies behind the end of the target.
        ("", "LOD CNST.9 / MOV BX,CX / STRCPY LONG[BX],SHORT", "QWRD.LONG=6867666564636261h BYTE.(LONG+8)=0"),
    ]);
}

#[test]
fn appending_texts() {
    check(&[
        ("", "STRADD MIDDLE,'xy'", "QWRD.MIDDLE=0079786564636261h"),
        ("", "STRADD MIDDLE,SHORT", "QWRD.MIDDLE=6564636564636261h BYTE.(MIDDLE+8)=0"),
        ("", "STRADD MIDDLE,LONG", "QWRD.MIDDLE=6362616564636261h BYTE.(MIDDLE+8)=0"),
        ("", "STRADD LONG,'x'", "QWRD.LONG=6867666564636261h BYTE.(LONG+8)=0"),
        ("", "STRCPY MIDDLE,'' / STRADD MIDDLE,'q' / STRADD MIDDLE,'r'", "WORD.MIDDLE=7271h"),
    ]);
}

#[test]
fn comparing_texts() {
    check(&[
        ("", "STRCMP LONG+2,SHORT,3", "RLO=1"),
        ("", "STRCMP LONG+2,SHORT", "RLO=0"),
        ("", "STRCMP MIDDLE+2,SHORT", "RLO=1"),
        ("", "STRCMP LONG+2,'cde',3", "RLO=1"),
        ("", "STRCMP MIDDLE,'abcd',20", "RLO=0"),
        ("", "STRCMP LONG,MIDDLE,5", "RLO=1"),
        ("", "STRCMP LONG,MIDDLE,6", "RLO=0"),
        ("IB=1", "LDR I0 / STRCMP LONG,SHORT", "RLO=0"),
    ]);
}

#[test]
fn bytes_know_no_end_mark() {
    check(&[
        ("", "MEMCPY LONG,SHORT,4", "QWRD.LONG=6867666500656463h"),
        ("", "MEMCPY LONG,SHORT,2", "QWRD.LONG=6867666564636463h"),
        // None at all.
        ("", "MEMCPY LONG,SHORT,0", "QWRD.LONG=6867666564636261h"),
        ("", "MEMCPY SHORT,LONG", "DWRD.SHORT=64636261h BYTE.(SHORT+4)=77h"),
        ("", "MEMCPY SHORT,LONG,100", "DWRD.SHORT=64636261h BYTE.(SHORT+4)=77h"),
        ("", "MEMCMP LONG,MIDDLE,5", "RLO=1"),
        ("", "MEMCMP LONG,MIDDLE,6", "RLO=0"),
        ("", "STRCPY MIDDLE,'abcde' / MEMCMP MIDDLE,MIDDLE", "RLO=1"),
        ("", "MEMCMP SHORT,LONG", "RLO=0"),
    ]);
}

#[test]
fn numbers_as_texts() {
    check(&[
        ("W1=1234", "LOD W1 / BINSTR SHORT", "DWRD.SHORT=00343332h"),
        ("W1=42", "LOD W1 / BINSTR MIDDLE", "QWRD.MIDDLE=3234303030303030h BYTE.(MIDDLE+8)=0"),
        ("W1=0FFFFh", "LOD W1 / BINSTR MIDDLE", "QWRD.MIDDLE=3533353536303030h"),
        ("D1=87654321", "LOD D1 / BINSTR MIDDLE,DWRD", "QWRD.MIDDLE=3132333435363738h"),
        ("W1=1234h", "LOD W1 / BCDSTR MIDDLE", "QWRD.MIDDLE=3433323130303030h"),
        ("D1=12345678h", "LOD D1 / BCDSTR MIDDLE,DWRD", "QWRD.MIDDLE=3837363534333231h"),
        ("D1=12345678h", "LOD D1 / BCDSTR SHORT,DWRD", "DWRD.SHORT=00383736h"),
    ]);
}

#[test]
fn a_digit_above_nine_is_a_fault() {
    let mut plc = crate::plc::Plc::of("LOD CNST.1Ah / BCDSTR SHORT");
    plc.run(1);
    assert!(plc.fault().is_some_and(|fault| fault.contains("BCD")), "{:?}", plc.fault());
}
