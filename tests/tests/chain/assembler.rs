//! 80386 instructions in a program (manual 3.1 and 22.3).

use std::fmt::Write as _;

use crate::coverage::with_mutants;
use crate::plc::{Plc, check};

#[test]
fn registers_are_views_of_rlo_dr_and_the_index() {
    const Q: &str = "QWRD.Q1=1122334455667788h";
    check(&[
        (
            Q,
            "LOD QWRD.Q1 / MOV D1,ECX / MOV W1,CX / MOV B1,CL / MOV B2,CH",
            "D1=55667788h W1=7788h B1=88h B2=77h",
        ),
        (
            Q,
            "LOD QWRD.Q1 / MOV D1,EDX / MOV W1,DX / MOV B1,DL / MOV B2,DH",
            "D1=11223344h W1=3344h B1=44h B2=33h",
        ),
        (Q, "LOD QWRD.Q1 / MOV CX,1 / MOV DH,2", "DR64=1122024455660001h"),
        (Q, "LOD QWRD.Q1 / MOV ECX,-1", "DR64=11223344FFFFFFFFh"),
        (Q, "LOD QWRD.Q1 / MOV EDX,0", "DR64=55667788h"),
        ("", "LOD CNST.2.5 / MOV ECX,7", "DR_REAL=2.5 DR32=7"),
        ("", "MOV EAX,12345678h / MOV AL,1 / MOV D1,EAX", "D1=12345601h RLO=1"),
        ("", "MOV EAX,0 / MOV AX,0BFFFh / MOV D1,EAX", "D1=0BFFFh RLO=0"),
        ("IB=1", "MOV EAX,0 / LDR I0 / MOV B1,AH / WR O0", "B1=40h OB=1"),
        ("IB=0", "MOV EAX,-1 / LDR I0 / MOV D1,EAX / WR O0", "D1=0FFFFBFFFh OB=0"),
        ("IB=0", "LDR I0 / OR AH,40h / WR O0", "OB=1"),
        ("IB=1", "LDR I0 / XOR AH,40h / WR O0", "OB=0"),
        ("", "MOV ECX,100 / MOV EAX,ECX / ADD EAX,EAX / MOV ECX,EAX / STO W1", "W1=200"),
        // Writing BX leaves nothing of an older EBX behind in the index.
        ("", "MOV EBX,12345678h / MOV BX,5 / MOV D1,EBX", "BX=5 D1=5"),
        ("", "MOV EBX,12345678h / MOV BL,1 / MOV BH,2", "BX=12340201h"),
    ]);
}

#[test]
fn some_instructions_do_nothing() {
    check(&[
        ("IB=1", "LOD FIVE / LDR I0 / CLI / STI / NOP / STO B1 / WR O0", "B1=5 OB=1 DR64=5"),
        ("", "MOV CX,1 / CMP CX,2 / CLI / STI / NOP / JB L / FL 1,O0 / L:", "OB=0 DR16=1"),
    ]);
}

#[test]
fn moves_between_registers_cells_and_numbers() {
    check(&[
        ("", "MOV W1,-1 / MOV B1,255 / MOV D1,80000000h", "W1=0FFFFh W2=0 B1=0FFh B2=0 D1=80000000h D2=0"),
        ("", "MOV WORD.D1,1234h / MOV BYTE.(D1+3),0FFh", "D1=0FF001234h"),
        ("", "MOV CX,FIVE / MOV W1,CX", "W1=5"),
        ("W1=0FFFEh", "LOD CNST.0 / MOV CX,W1", "DR64=0FFFEh"),
        ("", "MOV BX,4 / MOV BYTE.AREA[BX],7", "QWRD.AREA=0700000000h"),
        ("", "MOV EBX,-1 / MOV BYTE.(AREA[BX]+1),7", "QWRD.AREA=7"),
        ("WORD.(AREA+4)=0AA55h", "MOV EBX,4 / MOV CX,WORD.AREA[BX]", "DR16=0AA55h"),
        ("WORD.(AREA+6)=0AA55h", "LOD CNST.4 / MOV BX,CX / MOV CX,WORD.(AREA[BX]+2)", "DR16=0AA55h"),
        // An index that INR made wider than its element.
        ("WORD.(AREA+4)=77", "LOD CNST.2 / MOV BX,CX / SHL BX,1 / LOD WORD.AREA[BX]", "DR64=77"),
    ]);
}

#[test]
fn sums_and_logic_at_each_width() {
    check(&[
        ("B1=0F0h", "ADD B1,20h", "B1=10h B2=0"),
        ("W1=0FFF0h", "ADD W1,20h", "W1=10h W2=0"),
        ("D1=0FFFFFFF0h", "ADD D1,20h", "D1=10h D2=0"),
        ("B1=10h", "SUB B1,20h", "B1=0F0h B2=0"),
        ("W1=10h", "SUB W1,20h", "W1=0FFF0h W2=0"),
        ("D1=10h", "SUB D1,20h", "D1=0FFFFFFF0h D2=0"),
        ("B1=0CCh", "AND B1,0AAh", "B1=88h"),
        ("W1=0CCCCh", "AND W1,0AAh", "W1=88h"),
        ("D1=0CCCCCCCCh", "AND D1,0AAAAAAAAh", "D1=88888888h"),
        ("B1=0CCh", "OR B1,0AAh", "B1=0EEh"),
        ("W1=0CC00h", "OR W1,0AAh", "W1=0CCAAh"),
        ("D1=0CCCCCCCCh", "OR D1,0AAAAAAAAh", "D1=0EEEEEEEEh"),
        ("B1=0CCh", "XOR B1,0AAh", "B1=66h"),
        ("W1=0CCCCh", "XOR W1,0AAAAh", "W1=6666h"),
        ("D1=0CCCCCCCCh", "XOR D1,0AAAAAAAAh", "D1=66666666h"),
        ("B1=0FFh W1=0FFFFh D1=0FFFFFFFFh", "INC B1 / INC W1 / INC D1", "B1=0 B2=0 W1=0 W2=0 D1=0 D2=0"),
        ("", "DEC B1 / DEC W1 / DEC D1", "B1=0FFh B2=0 W1=0FFFFh W2=0 D1=0FFFFFFFFh D2=0"),
        ("W1=3 W2=4", "MOV CX,W1 / ADD CX,W2 / MOV W1,CX / MOV AX,CX / SUB W2,AX", "W1=7 W2=0FFFDh"),
        ("W1=9", "MOV CX,10 / CMP CX,W1", "DR16=10 W1=9"),
        ("W1=9", "CMP W1,10", "W1=9"),
        ("D1=5", "MOV ECX,3 / ADD D1,ECX", "D1=8 D2=0"),
        ("W1=3 W2=5", "MOV CX,W1 / ADD CX,W2 / MOV W1,CX", "W1=8"),
        ("B1=0FFh", "AND B1,0AAh", "B1=0AAh"),
        ("W1=0FFFFh", "AND W1,0AAh", "W1=0AAh"),
        ("D1=0FFFFFFFFh", "AND D1,0AAh", "D1=0AAh"),
        ("B1=5", "CMP B1,5 / JE L / FL 1,O0 / L:", "B1=5 OB=0"),
        ("B1=5", "CMP B1,6 / JB L / FL 1,O0 / L:", "B1=5 OB=0"),
        ("B1=3", "MOV CL,5 / CMP CL,B1", "DR8=5"),
        ("D1=3", "MOV ECX,5 / CMP ECX,D1", "DR32=5"),
        ("", "MOV AX,5 / CMP AX,5 / JE L / FL 1,O0 / L: / MOV W1,AX", "W1=5 OB=0"),
        ("", "MOV CX,5 / CMP CX,5 / JE L / FL 1,O0 / L:", "DR16=5 OB=0"),
        ("", "MOV AX,2200h / OR AH,12h / MOV W1,AX", "W1=3200h"),
        ("", "MOV AX,1100h / XOR AH,13h / MOV W1,AX", "W1=200h"),
        ("W1=1100h", "OR W1,1300h", "W1=1300h"),
    ]);
}

#[test]
fn what_was_there_before_is_replaced() {
    check(&[
        ("B1=0FFh", "MOV B1,5", "B1=5"),
        ("B1=3Ch B2=3Ch", "MOV ECX,1234h / MOV B1,CL / MOV B2,CH", "B1=34h B2=12h"),
        ("B1=3Ch B2=3Ch", "MOV EDX,1234h / MOV B1,DL / MOV B2,DH", "B1=34h B2=12h"),
        ("B1=3Ch", "MOV AX,1234h / MOV B1,AH", "B1=12h"),
        ("D1=3C3C3C3Ch", "MOV ECX,12345678h / MOV D1,ECX", "D1=12345678h"),
        ("D1=3C3C3C3Ch", "MOV EDX,12345678h / MOV D1,EDX", "D1=12345678h"),
        ("D1=3C3C3C3Ch", "MOV EAX,12345678h / MOV D1,EAX", "D1=12345678h"),
        ("D1=3C3C3C3Ch", "MOV EBX,12345678h / MOV D1,EBX", "D1=12345678h"),
        ("", "MOV EAX,3C3C3C3Ch / MOV EAX,12345678h / MOV D1,EAX", "D1=12345678h"),
        ("", "MOV EBX,3C3C3C3Ch / MOV EBX,12345678h / MOV D1,EBX", "D1=12345678h"),
        ("", "MOV ECX,3C3C3C3Ch / MOV ECX,12345678h / MOV D1,ECX", "D1=12345678h"),
        ("", "MOV EDX,3C3C3C3Ch / MOV EDX,12345678h / MOV D1,EDX", "D1=12345678h"),
        ("", "MOV AX,3C3Ch / MOV AX,1234h / MOV W1,AX", "W1=1234h"),
        ("", "MOV CL,3Ch / MOV CL,12h", "DR8=12h"),
        ("", "MOV EBX,0 / MOV BH,3Ch / MOV BH,12h / MOV D1,EBX", "D1=1200h"),
        ("", "MOV EDX,0 / MOV DH,3Ch / MOV DH,12h / MOV D1,EDX", "D1=1200h"),
        ("", "MOV AX,3C3Ch / MOV CX,1234h / MOV AX,CX / MOV W1,AX", "W1=1234h"),
        ("", "MOV EAX,3C3C3C3Ch / MOV ECX,12345678h / MOV EAX,ECX / MOV D1,EAX", "D1=12345678h"),
        ("W1=3C3Ch", "MOV CX,1234h / MOV W1,CX", "W1=1234h"),
        ("W1=3C3Ch", "MOV DX,1234h / MOV W1,DX", "W1=1234h"),
        ("", "MOV DX,3C3Ch / MOV DX,1234h / MOV W1,DX", "W1=1234h"),
        ("W1=1234h W2=5678h", "MOV AX,W1 / MOV W2,AX", "W2=1234h"),
    ]);
}

#[test]
fn shifts_count_to_31_and_keep_the_last_bit_as_carry() {
    check(&[
        ("W1=8001h", "SHL W1,1 / JC L / FL 1,O0 / L:", "W1=2 W2=0 OB=0"),
        ("W1=4001h", "SHL W1,1 / JC L / FL 1,O0 / L:", "W1=8002h OB=1"),
        ("W1=8001h", "SHR W1,1 / JC L / FL 1,O0 / L:", "W1=4000h OB=0"),
        ("W1=8002h", "SHR W1,1 / JC L / FL 1,O0 / L:", "W1=4001h OB=1"),
        ("B1=81h", "SHL B1,7", "B1=80h B2=0"),
        ("B1=81h", "SHR B1,7", "B1=1"),
        ("B1=0FFh", "SHL B1,20", "B1=0 B2=0"),
        ("D1=3", "SHL D1,31", "D1=80000000h D2=0"),
        ("D1=0C0000000h", "SHR D1,31", "D1=1"),
        ("W1=1", "MOV CL,33 / SHL W1,CL", "W1=2"),
        ("D1=8", "MOV CL,2 / SHL D1,CL", "D1=20h"),
        ("W1=8", "MOV CL,0E1h / SHR W1,CL", "W1=4"),
        // By 0, and by 32, nothing happens to the flags either.
        ("W1=1 D1=8", "MOV CL,32 / CMP W1,1 / SHL D1,CL / JE L / FL 1,O0 / L:", "D1=8 OB=0"),
        ("W1=1 D1=8", "CMP W1,1 / SHR D1,0 / JE L / FL 1,O0 / L:", "D1=8 OB=0"),
        // One place to the left overflows when the sign changes, one to the right when there was one.
        ("B1=40h", "SHL B1,1 / JO L / FL 1,O0 / L:", "B1=80h OB=0"),
        ("B1=0C0h", "SHL B1,1 / JO L / FL 1,O0 / L:", "B1=80h OB=1"),
        ("B1=80h", "SHR B1,1 / JO L / FL 1,O0 / L:", "B1=40h OB=0"),
    ]);
}

#[test]
fn flags_of_the_other_instructions() {
    check(&[
        // INC and DEC leave the carry of the sum before.
        ("B1=0FFh", "ADD B1,1 / INC B2 / JC L / FL 1,O0 / L:", "B2=1 OB=0"),
        ("", "ADD B1,1 / DEC B2 / JC L / FL 1,O0 / L:", "B2=0FFh OB=1"),
        ("W1=0FFFFh", "ADD W1,1 / INC W2 / JC L / FL 1,O0 / L:", "W2=1 OB=0"),
        ("", "ADD W1,1 / DEC W2 / JC L / FL 1,O0 / L:", "W2=0FFFFh OB=1"),
        ("D1=0FFFFFFFFh", "ADD D1,1 / INC D2 / JC L / FL 1,O0 / L:", "D2=1 OB=0"),
        ("", "ADD D1,1 / DEC D2 / JC L / FL 1,O0 / L:", "D2=0FFFFFFFFh OB=1"),
        ("", "MOV CX,0 / ADD W1,1 / DEC CX / JC L / FL 1,O0 / L:", "DR16=0FFFFh OB=1"),
        ("B1=0FFh", "INC B1 / JNC L / FL 1,O0 / L:", "B1=0 OB=0"),
        ("B1=0FFh", "INC B1 / JZ L / FL 1,O0 / L:", "OB=0"),
        ("B1=7Fh", "INC B1 / JO L / FL 1,O0 / L:", "B1=80h OB=0"),
        ("B1=80h", "DEC B1 / JO L / FL 1,O0 / L:", "B1=7Fh OB=0"),
        ("W1=1", "DEC W1 / JNZ L / FL 1,O0 / L:", "W1=0 OB=1"),
        // Logic clears carry and overflow.
        ("B1=0FFh", "ADD B1,1 / AND B2,0 / JC L / FL 1,O0 / L: / JNZ M / FL 1,O1 / M:", "OB=3"),
        ("B1=7Fh B2=80h", "ADD B1,1 / OR B2,1 / JO L / FL 1,O0 / L: / JNS M / FL 1,O1 / M:", "OB=3"),
        ("B2=3", "XOR B2,0 / JP L / FL 1,O0 / L:", "OB=0"),
        ("W2=301h", "XOR W2,0 / JP L / FL 1,O0 / L:", "OB=1"),
        // MOV and instructions of TECHNOL leave all flags.
        ("W1=3", "CMP W1,3 / MOV W1,9 / LOD W1 / AD CNST.1 / LDR I0 / WR O1 / JE L / FL 1,O0 / L:", "OB=0"),
    ]);
}

#[test]
fn jumps_and_loops() {
    check(&[
        ("", "JMP L / FL 1,O0 / L: / FL 1,O1", "OB=2"),
        ("", "MOV CX,5 / MOV W1,0 / AGAIN: / ADD W1,CX / DEC CX / JNZ AGAIN", "W1=15 DR16=0"),
        ("", "MOV ECX,10000h / JCXZ L / FL 1,O0 / L: / JECXZ M / FL 1,O1 / M:", "OB=2"),
        ("", "MOV ECX,0 / JECXZ L / FL 1,O0 / L: / FL 1,O1", "OB=2"),
        ("", "MOV ECX,1 / JCXZ L / FL 1,O0 / L: / FL 1,O1", "OB=3"),
        // In a macro, with a label of each call.
        (
            "W1=200 W2=50",
            "DEF_T_MACRO CLIPPED CELL,MOST / T_LOCAL FITS / MOV AX,CELL / CMP AX,MOST / JBE FITS / MOV CELL,MOST / FITS: / \
             END_T_MACRO / CLIPPED W1,100 / CLIPPED W2,100",
            "W1=100 W2=50",
        ),
    ]);
}

/// A jump and whether it jumps after `CMP a,b`; `difference` has the width of the operands, sign-extended.
type Jump = (&'static str, fn(a: i64, b: i64, mask: i64, difference: i64) -> bool);

const JUMPS: [Jump; 30] = [
    ("JE", |a, b, _, _| a == b),
    ("JZ", |a, b, _, _| a == b),
    ("JNE", |a, b, _, _| a != b),
    ("JNZ", |a, b, _, _| a != b),
    ("JB", |a, b, mask, _| a & mask < b & mask),
    ("JC", |a, b, mask, _| a & mask < b & mask),
    ("JNAE", |a, b, mask, _| a & mask < b & mask),
    ("JAE", |a, b, mask, _| a & mask >= b & mask),
    ("JNB", |a, b, mask, _| a & mask >= b & mask),
    ("JNC", |a, b, mask, _| a & mask >= b & mask),
    ("JBE", |a, b, mask, _| a & mask <= b & mask),
    ("JNA", |a, b, mask, _| a & mask <= b & mask),
    ("JA", |a, b, mask, _| a & mask > b & mask),
    ("JNBE", |a, b, mask, _| a & mask > b & mask),
    ("JL", |a, b, _, _| a < b),
    ("JNGE", |a, b, _, _| a < b),
    ("JGE", |a, b, _, _| a >= b),
    ("JNL", |a, b, _, _| a >= b),
    ("JLE", |a, b, _, _| a <= b),
    ("JNG", |a, b, _, _| a <= b),
    ("JG", |a, b, _, _| a > b),
    ("JNLE", |a, b, _, _| a > b),
    ("JS", |_, _, _, difference| difference < 0),
    ("JNS", |_, _, _, difference| difference >= 0),
    ("JO", |a, b, _, difference| a - b != difference),
    ("JNO", |a, b, _, difference| a - b == difference),
    ("JP", |_, _, _, difference| (difference as u8).count_ones().is_multiple_of(2)),
    ("JPE", |_, _, _, difference| (difference as u8).count_ones().is_multiple_of(2)),
    ("JNP", |_, _, _, difference| (difference as u8).count_ones() % 2 == 1),
    ("JPO", |_, _, _, difference| (difference as u8).count_ones() % 2 == 1),
];

#[test]
fn every_conditional_jump_at_every_width() {
    for (cells, register, bits) in [("B", "CL", 8), ("W", "CX", 16), ("D", "ECX", 32)] {
        with_mutants(|| {
            // Bit n of Q1: jump n did not jump.
            let mut lines = String::from("MOV DWRD.Q1,0");
            for (n, (jump, _)) in JUMPS.iter().enumerate() {
                let _ = write!(
                    lines,
                    " / MOV {register},{cells}1 / CMP {register},{cells}2 / {jump} L{n} / OR DWRD.Q1,0{:X}h / L{n}:",
                    1_u32 << n
                );
            }
            let mut plc = Plc::of(&lines);
            let extend = |value: i64| value << (64 - bits) >> (64 - bits);
            let mask = (1_i64 << bits) - 1;
            let half = 1_i64 << (bits - 1);
            let values = [0, 1, 2, 3, half - 1, half, half + 1, mask - 1, mask];
            for (a, b) in values.iter().flat_map(|a| values.map(|b| (*a, b))) {
                plc.set(&format!("{cells}1=0{a:X}h {cells}2=0{b:X}h"));
                plc.run(1);
                let (signed_a, signed_b) = (extend(a), extend(b));
                let difference = extend(a.wrapping_sub(b));
                let stayed: u32 = (0..)
                    .zip(JUMPS)
                    .filter(|(_, (_, jumps))| !jumps(signed_a, signed_b, mask, difference))
                    .map(|(n, _): (u32, _)| 1_u32 << n)
                    .sum();
                assert_eq!(
                    plc.differences(&format!("DWRD.Q1=0{stayed:X}h")),
                    [""; 0],
                    "{bits}: {a:X}h, {b:X}h"
                );
            }
        });
    }
}

#[test]
fn an_address_outside_memory_is_a_fault_that_changes_nothing() {
    for (lines, len) in [
        ("MOV EBX,7FFFFFF0h / MOV CL,BYTE.AREA[BX]", 1),
        ("MOV EBX,7FFFFFF0h / INC WORD.AREA[BX]", 2),
        ("MOV EBX,80000000h / ADD DWRD.AREA[BX],ECX", 4),
        ("MOV EBX,80000000h / CMP BYTE.(AREA[BX]+1),1", 1),
    ] {
        let mut plc = Plc::of(&format!("LOD FIVE / {lines} / FL 1,O0"));
        plc.run(1);
        let fault = plc.fault().expect(lines);
        let place = format!("indexed access of {len} bytes at address ");
        assert!(fault.starts_with(&place) && fault.ends_with("is outside PLC memory"), "{lines}: {fault}");
        assert_eq!(plc.differences("DR64=5 OB=0"), [""; 0], "{lines}");
    }
}

#[test]
fn an_endless_loop_of_them_is_stopped() {
    let mut plc = Plc::of("MOV ECX,1 / AGAIN: / CMP ECX,1 / JE AGAIN");
    plc.run(1);
    assert_eq!(plc.fault().as_deref(), Some("endless loop: the module does not end"));
}
