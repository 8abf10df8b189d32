//! Source lines and the operations they become.

use technol_image::assembler::{Condition, Function, Operand, Register};
use technol_image::op::{
    Arith, BitRef, Compare, Cond, Count, DrTest, Logic, Op, Place, Raster, Source, Unary, Width,
};
use technol_image::program::{Message, ModuleKind, Timed};
use technol_image::system;

use crate::{built_source, parts};

const DATA: &str = "\
CTL:  DFM A,B,C,,,,,H
BYT:  DS 1
WRD:  DS 2
DWD:  DS 4
BIG:  DS 16
EQUI  K,124
";
const CTL: u32 = 0x8000;
const BYT: u32 = 0x8001;
const WRD: u32 = 0x8002;
const DWD: u32 = 0x8004;
const BIG: u32 = 0x8008;
/// After the data: activation bits and three words of the two block modules; then the automatic counters.
const COUNTERS: u32 = 0x8018 + 1 + 2 * 6;

/// The operations of MODULE_MAIN with these lines, without its end.
fn main_ops(lines: &str) -> Vec<Op> {
    let built = built_source(DATA, lines);
    let (program, _) = parts(&built);
    let main = program.modules.iter().find(|m| m.kind == ModuleKind::Main).expect("every file has one");
    let ops = &program.code[main.start as usize..main.end as usize];
    assert_eq!(ops.last(), Some(&Op::ModuleEnd));
    ops[..ops.len() - 1].to_vec()
}

fn check(rows: &[(&str, &[Op])]) {
    for (source, expected) in rows {
        assert_eq!(main_ops(&(source.replace(" / ", "\n") + "\n")), *expected, "{source}");
    }
}

const fn bit(addr: u32, bit: u8) -> BitRef {
    BitRef { addr, bit, indexed: false }
}

const fn at(addr: u32) -> Place {
    Place { addr, indexed: false }
}

const fn cell(addr: u32) -> Source {
    Source::Mem(at(addr))
}

const fn ldr(bit: BitRef, neg: bool, push: bool) -> Op {
    Op::Ldr { bit, neg, push }
}

const fn lod(src: Source, width: Width) -> Op {
    Op::Load { src, width, neg: false }
}

const A: BitRef = bit(CTL, 0);
const B: BitRef = bit(CTL, 1);
const H: BitRef = bit(CTL, 7);

#[test]
fn bit_logic() {
    let logic = |op, neg| Op::Logic { op, bit: B, neg };
    check(&[
        ("LDR A / LA B / WR C", &[ldr(A, false, false), logic(Logic::And, false), Op::Write(bit(CTL, 2))]),
        ("LDR -A / LO -B / WR H", &[ldr(A, true, false), logic(Logic::Or, true), Op::Write(H)]),
        ("LDR A / LX B / WR H", &[ldr(A, false, false), logic(Logic::Xor, false), Op::Write(H)]),
        (
            "LDR A / LDR -B / LO / CA / WR H",
            &[
                ldr(A, false, false),
                ldr(B, true, true),
                Op::LogicPop(Logic::Or),
                Op::Complement,
                Op::Write(H),
            ],
        ),
        ("LDR A / WR B,H,BIG.A", &[ldr(A, false, false), Op::Write(B), Op::Write(H), Op::Write(bit(BIG, 0))]),
        ("LDR (BIG+3).H / WR $+2.B", &[ldr(bit(BIG + 3, 7), false, false), Op::Write(bit(CTL + 2, 1))]),
        (
            "LDR -(BIG[BX]-2).B / WR A",
            &[ldr(BitRef { addr: BIG - 2, bit: 1, indexed: true }, true, false), Op::Write(A)],
        ),
        ("LDR P2IN.A / WR A", &[ldr(bit(system::IN_PORTS + 1, 0), false, false), Op::Write(A)]),
    ]);
}

#[test]
fn flags_moves_and_jumps() {
    let flag = |value, bit, cond| Op::Flag { value, bit, cond };
    let moved = |neg, cond| Op::MoveBit { dst: A, src: B, neg, cond };
    check(&[
        ("FL 1,A,H", &[flag(true, A, Cond::Always), flag(true, H, Cond::Always)]),
        ("LDR A / FL1 0,B", &[ldr(A, false, false), flag(false, B, Cond::IfRlo)]),
        ("MOVR A,B", &[moved(false, Cond::Always)]),
        ("LDR H / MOVR1 A,B", &[ldr(H, false, false), moved(false, Cond::IfRlo)]),
        (
            "LDR A / JL0 X / NOP / X: / CLI",
            &[ldr(A, false, false), Op::Jump { target: 3, cond: Cond::IfNotRlo }, Op::Nop, Op::Nop],
        ),
        ("L: LDR A / JL1 L", &[ldr(A, false, false), Op::Jump { target: 0, cond: Cond::IfRlo }]),
        // A label at the end of a module stands before the end of the module.
        ("JUM E / STI / E:", &[Op::Jump { target: 2, cond: Cond::Always }, Op::Nop]),
    ]);
}

#[test]
fn edges_have_a_hidden_byte_for_each_occurrence() {
    let built = built_source(DATA, "EDGE_H A\nWR B\nEDGE_L A\nWR B\n");
    let (program, _) = parts(&built);
    let hidden = program.region(technol_image::program::RegionKind::Hidden).unwrap();
    assert_eq!((hidden.start, hidden.len), (COUNTERS, 2));
    assert_eq!(program.code[0], Op::Edge { rising: true, bit: A, state: hidden.start });
    assert_eq!(program.code[2], Op::Edge { rising: false, bit: A, state: hidden.start + 1 });
}

#[test]
fn loads_and_stores_at_every_width() {
    let store = |addr, width, cond| Op::Store { dst: at(addr), width, cond };
    let word = Width::Word;
    check(&[
        ("LOD BYT / STO WRD", &[lod(cell(BYT), Width::Byte), store(WRD, word, Cond::Always)]),
        ("LOD WORD.BIG / STO HIGH.WRD", &[lod(cell(BIG), word), store(WRD + 1, Width::Byte, Cond::Always)]),
        (
            "LOD DWRD.(BIG+4) / STO DWD",
            &[lod(cell(BIG + 4), Width::DWord), store(DWD, Width::DWord, Cond::Always)],
        ),
        ("LOD QWRD.BIG", &[lod(cell(BIG), Width::QWord)]),
        (
            "LOD REAL.BIG / STO REAL.(BIG+8)",
            &[lod(cell(BIG), Width::Real), store(BIG + 8, Width::Real, Cond::Always)],
        ),
        ("LOD -WRD", &[Op::Load { src: cell(WRD), width: word, neg: true }]),
        ("LOD CNST.0F8h", &[lod(Source::Int(248), Width::DWord)]),
        ("LOD CNST.-5", &[lod(Source::Int(-5), Width::DWord)]),
        ("LOD K", &[lod(Source::Int(124), Width::DWord)]),
        ("LOD CNST.-4.5", &[lod(Source::Real(-4.5), Width::Real)]),
        ("LOD BYTE.BIG[BX]", &[lod(Source::Mem(Place { addr: BIG, indexed: true }), Width::Byte)]),
        ("LDR A / STO1 BYT", &[ldr(A, false, false), store(BYT, Width::Byte, Cond::IfRlo)]),
        ("LDR A / STO0 WRD", &[ldr(A, false, false), store(WRD, word, Cond::IfNotRlo)]),
        ("MOVE WORD.BIG,WRD", &[Op::Move { dst: at(BIG), src: at(WRD), width: word, cond: Cond::Always }]),
        (
            "LDR A / MOVE1 BYT,HIGH.WRD",
            &[
                ldr(A, false, false),
                Op::Move { dst: at(BYT), src: at(WRD + 1), width: Width::Byte, cond: Cond::IfRlo },
            ],
        ),
    ]);
}

#[test]
fn arithmetic_and_comparison() {
    let arith = |op, src, width| Op::Arith { op, src, width };
    let compare = |op, src, width| Op::Compare { op, src, width, if_rlo: false };
    let unary = |op, width| Op::Unary { op, width };
    let seven = Source::Int(7);
    check(&[
        (
            "AD BYT / SU WRD",
            &[arith(Arith::Add, cell(BYT), Width::Byte), arith(Arith::Sub, cell(WRD), Width::Word)],
        ),
        ("LOD DWD / MULB CNST.7", &[lod(cell(DWD), Width::DWord), arith(Arith::Mul, seven, Width::DWord)]),
        ("LOD DWD / DIVB WRD", &[lod(cell(DWD), Width::DWord), arith(Arith::Div, cell(WRD), Width::Word)]),
        ("MULB REAL.BIG", &[arith(Arith::Mul, cell(BIG), Width::Real)]),
        (
            "ORB BYT / ANDB WRD / XORB QWRD.BIG",
            &[
                arith(Arith::Or, cell(BYT), Width::Byte),
                arith(Arith::And, cell(WRD), Width::Word),
                arith(Arith::Xor, cell(BIG), Width::QWord),
            ],
        ),
        ("EQ CNST.7 / WR A", &[compare(Compare::Eq, seven, Width::DWord), Op::Write(A)]),
        ("LT BYT / WR A", &[compare(Compare::Lt, cell(BYT), Width::Byte), Op::Write(A)]),
        ("GE REAL.BIG / WR A", &[compare(Compare::Ge, cell(BIG), Width::Real), Op::Write(A)]),
        (
            "LDR A / EQ1 WRD / WR A",
            &[
                ldr(A, false, false),
                Op::Compare { op: Compare::Eq, src: cell(WRD), width: Width::Word, if_rlo: true },
                Op::Write(A),
            ],
        ),
        (
            "INR / DCR DWRD / INV QWRD / ABS REAL",
            &[
                unary(Unary::Increment, Width::Word),
                unary(Unary::Decrement, Width::DWord),
                unary(Unary::Negate, Width::QWord),
                unary(Unary::Absolute, Width::Real),
            ],
        ),
        (
            "INRBCD / BIN / BCD DWRD",
            &[Op::IncrementBcd, Op::BcdToBin(Width::Word), Op::BinToBcd(Width::DWord)],
        ),
        (
            "RL CNST.3 / RR BYT,QWRD",
            &[
                Op::Shift { left: true, count: Source::Int(3), width: Width::Word },
                Op::Shift { left: false, count: cell(BYT), width: Width::QWord },
            ],
        ),
        (
            "CONDR / WR A / CONDR DWRD / WR A / CONDR 31 / WR A",
            &[
                Op::DrToRlo(DrTest::NonZero(Width::Word)),
                Op::Write(A),
                Op::DrToRlo(DrTest::NonZero(Width::DWord)),
                Op::Write(A),
                Op::DrToRlo(DrTest::Bit(31)),
                Op::Write(A),
            ],
        ),
        (
            "LDR A / CONRD DWRD / REAL DWRD",
            &[ldr(A, false, false), Op::RloToDr(Width::DWord), Op::IntToReal(Width::DWord)],
        ),
        ("MOV BX,CX", &[Op::IndexFromDr]),
    ]);
}

#[test]
fn processor_instructions() {
    let register = |name| Operand::Register(Register::named(name).expect("a register"));
    let op = |function, width, to, from| Op::Assembler { function, width, to, from };
    let table = Operand::Cell(Place { addr: BIG + 2, indexed: true });
    check(&[
        ("MOV WRD,cx", &[op(Function::Move, Width::Word, Operand::Cell(at(WRD)), register("CX"))]),
        ("MOV BX,AX", &[op(Function::Move, Width::Word, register("BX"), register("AX"))]),
        ("ADD BYTE.(BIG[BX]+2),K", &[op(Function::Add, Width::Byte, table, Operand::Number(124))]),
        ("SUB EDX,-1", &[op(Function::Sub, Width::DWord, register("EDX"), Operand::Number(u32::MAX))]),
        ("AND CL,BYTE.DWD+1", &[op(Function::And, Width::Byte, register("CL"), Operand::Cell(at(DWD + 1)))]),
        ("INC DWD", &[op(Function::Increment, Width::DWord, Operand::Cell(at(DWD)), Operand::Number(1))]),
        ("SHR WRD,CL", &[op(Function::ShiftRight, Width::Word, Operand::Cell(at(WRD)), register("CL"))]),
        (
            "X: CMP AH,40h / JNA X / JMP E / E:",
            &[
                op(Function::Compare, Width::Byte, register("AH"), Operand::Number(0x40)),
                Op::AssemblerJump { condition: Condition::BelowOrEqual, target: 0 },
                Op::Jump { target: 3, cond: Cond::Always },
            ],
        ),
    ]);
}

#[test]
fn memory_blocks() {
    check(&[
        ("MV BIG,BIG+8,8", &[Op::Copy { src: at(BIG), dst: at(BIG + 8), len: 8 }]),
        // The last variable is cleared to its end, whatever its length.
        ("CLEAR BYT,BIG", &[Op::Clear { addr: BYT, len: BIG + 16 - BYT }]),
        ("CLEAR WRD,WRD", &[Op::Clear { addr: WRD, len: 2 }]),
        ("CLEAR BIG,BIG+3", &[Op::Clear { addr: BIG, len: 4 }]),
        ("CLEAR GLOBAL,ALL", &[Op::Clear { addr: CTL, len: COUNTERS - CTL }]),
        ("CLEAR INTERNAL,ALL", &[Op::Clear { addr: COUNTERS, len: 0 }]),
    ]);
}

#[test]
fn timers_and_counters() {
    check(&[
        (
            "DFTM1 E / LDR A / LOD CNST.5 / TM - / FL1 1,B / E:",
            &[
                Op::Raster { rate: Raster::Second, end: 5 },
                ldr(A, false, false),
                lod(Source::Int(5), Width::DWord),
                Op::Timer { count: at(COUNTERS), width: Width::Word },
                Op::Flag { value: true, bit: B, cond: Cond::IfRlo },
            ],
        ),
        (
            "DFTM01 E / LDR A / TM BYT / WR B / E:",
            &[
                Op::Raster { rate: Raster::Tenth, end: 4 },
                ldr(A, false, false),
                Op::Timer { count: at(BYT), width: Width::Byte },
                Op::Write(B),
            ],
        ),
        (
            "LDR A / LOD BYT / CU WRD / JL0 E / E:",
            &[
                ldr(A, false, false),
                lod(cell(BYT), Width::Byte),
                Op::Counter { op: Count::Up, count: at(WRD), width: Width::Word, state: COUNTERS },
                Op::Jump { target: 4, cond: Cond::IfNotRlo },
            ],
        ),
    ]);
}

#[test]
fn messages() {
    let built = built_source(DATA, "ESET\nLDR A\nESET1 WRD,7,0,DWD,-,K\n");
    let (program, _) = parts(&built);
    assert_eq!(program.code[0], Op::Message { index: 0, cond: Cond::Always });
    assert_eq!(program.code[2], Op::Message { index: 1, cond: Cond::IfRlo });
    let none = Message { number: None, sub_id: None, set: true, parameters: [None; 3] };
    let full = Message {
        number: Some((cell(WRD), Width::Word)),
        sub_id: Some((Source::Int(7), Width::DWord)),
        set: false,
        parameters: [Some((cell(DWD), Width::DWord)), None, Some((Source::Int(124), Width::DWord))],
    };
    assert_eq!(program.messages, vec![none, full]);
}

#[test]
fn the_prefix_of_a_counter_covers_the_time() {
    let built = built_source(DATA, "MECH_BEGIN M\nTIM BYTE.WRD,(WRD)\nMECH_END M\n");
    let (program, _) = parts(&built);
    let timed = &program.timed[0];
    assert_eq!((timed.width, timed.time), (Width::Byte, Source::Mem(timed.count)));
}

#[test]
fn ex_type_instructions_are_numbered_in_their_sequence() {
    let main = "\
MECH_BEGIN ONE
EX
LDR A
EX0
LDR -A
TEX1 -,50,ERR,K
TIM BYT,10
BEX
ERR:
MECH_END ONE
MECH_BEGIN TWO
LDR A
TEX0 WRD,WRD,OUT
OUT: EX1
MECH_END TWO
FL 1,ONE,TWO
LOD ONE_LINE
MECH_INIT TWO
";
    let built = built_source(DATA, main);
    let (program, _) = parts(&built);
    let line = |n: u16| n + 9;
    let one = &program.sequences[0];
    let expected = [
        Op::SeqBegin(0),
        Op::Ex { point: 1, line: line(2) },
        ldr(A, false, false),
        Op::ExIf { wait_when: false, point: 2, line: line(4) },
        ldr(A, true, false),
        Op::Timed(0),
        Op::Timed(1),
        Op::Bex { point: 5, line: line(8) },
        Op::SeqEnd(0),
        Op::SeqBegin(1),
        ldr(A, false, false),
        Op::Timed(2),
        Op::ExIf { wait_when: true, point: 2, line: line(14) },
        Op::SeqEnd(1),
    ];
    assert_eq!(program.code[..14], expected);
    assert_eq!((one.start, one.end, one.line, one.resume.as_slice()), (0, 8, line(1), &[2, 4, 6, 7, 8][..]));
    let two = &program.sequences[1];
    assert_eq!((two.start, two.end, two.line, two.resume.as_slice()), (9, 13, line(11), &[12, 13][..]));
    // Four sequences: two mechanisms and the block modules, which stand behind them.
    let counters = 0x8018 + 1 + 4 * 6;
    let timed = |wait_when, count, width, time| Timed {
        wait_when,
        count: at(count),
        width,
        time,
        error: None,
        code: None,
        point: 3,
        line: line(6),
    };
    let tex1 = Timed {
        error: Some(8),
        code: Some((Source::Int(124), Width::DWord)),
        ..timed(Some(true), counters, Width::Word, Source::Int(50))
    };
    let tim = Timed { point: 4, line: line(7), ..timed(None, BYT, Width::Byte, Source::Int(10)) };
    let tex0 = Timed {
        error: Some(12),
        point: 1,
        line: line(13),
        ..timed(Some(false), WRD, Width::Word, cell(WRD))
    };
    assert_eq!(program.timed, vec![tex1, tim, tex0]);
    assert_eq!(program.code[14], Op::Flag { value: true, bit: bit(0x8018, 0), cond: Cond::Always });
    assert_eq!(program.code[15], Op::Flag { value: true, bit: bit(0x8018, 1), cond: Cond::Always });
    assert_eq!(program.code[16], lod(cell(one.line_cell), Width::Word));
    assert_eq!(program.code[17], Op::SeqInit(1));
}

#[test]
fn procedures_are_passed_over() {
    let built = built_source(DATA, "PROC_CALL Late\nPROC_BEGIN Late\nLDR A\nWR B\nPROC_END Late\nNOP\n");
    let (program, debug) = parts(&built);
    let expected = [
        Op::Call(0),
        Op::Jump { target: 5, cond: Cond::Always },
        ldr(A, false, false),
        Op::Write(B),
        Op::Return,
        Op::Nop,
        Op::ModuleEnd,
    ];
    assert_eq!(program.code[..7], expected);
    let late = &program.procedures[0];
    assert_eq!((late.name.as_str(), late.start, late.end), ("LATE", 2, 5));
    // The jump around it and the end of the module are no statements; PROC_END is one.
    assert_eq!(program.statements[..5], [0, 2, 3, 4, 5]);
    assert_eq!(debug.position(4), Some(("main.plc", 14)));
}
