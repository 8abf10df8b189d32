//! A small program with debug information, put together by hand: what the tests of this crate debug.
//!
//! ```text
//! main.plc                                       turret.plc
//! 10 MODULE_MAIN                                  3 MODULE_MAIN
//! 11   LDR P1IN.0                                 4   MECH_BEGIN TURRET
//! 12   WR  KSMP                                   5   EX
//! 13   LDR P1IN.1                                 6   MECH_END TURRET
//! 14   WR  KSMM                                   7 MODULE_MAIN_END
//! 15   LDR SMP
//! 16   WR  P0OUT.4
//! 17   PROC_CALL STEP
//! 18   MECH_BEGIN SPINDLE
//! 19   FL  1,SMP
//! 20   LDR KSMP
//! 21   EX0
//! 23   FL  0,SMP
//! 24   EX
//! 25   MECH_END SPINDLE
//! 26 MODULE_MAIN_END
//! 28 MODULE_FAST
//! 29   LDR KSMP
//! 30 MODULE_FAST_END
//! 33 PROC_BEGIN STEP
//! 34   LOD COUNT
//! 35   INR
//! 36 PROC_END
//! 40 MODULE_CONT
//! 41   LDR KSMM
//! 42 MODULE_CONT_END
//! ```

use technol_image::Image;
use technol_image::container::content_hash;
use technol_image::debug_info::{DebugInfo, Line, Mechanism, Scope, SourceFile, State, Symbol, SymbolKind};
use technol_image::op::{Addr, BitRef, Cond, Op, Place, Source, Unary, Width};
use technol_image::program::{
    Module, ModuleKind, Procedure, Program, Region, RegionKind, Sequence, SequenceKind,
};
use technol_image::system;

/// First byte of DATA.
pub(crate) const DATA: Addr = system::LEN;
pub(crate) const INPUTS: Addr = DATA;
pub(crate) const OUTPUTS: Addr = DATA + 1;
pub(crate) const COUNT: Addr = DATA + 2;
pub(crate) const SPEED: Addr = DATA + 4;
pub(crate) const TITLE: Addr = DATA + 8;
pub(crate) const TABLE: Addr = DATA + 20;
pub(crate) const RATIO: Addr = DATA + 40;
pub(crate) const LONELY: Addr = DATA + 48;
const CELLS: Addr = DATA + 50;
pub(crate) const STEP_NO: Addr = DATA + 100;
/// Length of PLC memory.
pub(crate) const MEMORY: u32 = DATA + 128;

fn bit(addr: Addr, bit: u8) -> BitRef {
    BitRef { addr, bit, indexed: false }
}

fn ldr(addr: Addr, n: u8) -> Op {
    Op::Ldr { bit: bit(addr, n), neg: false, push: false }
}

/// Operation, its file and its line.
fn code() -> Vec<(Op, u16, u32)> {
    let flag = |value| Op::Flag { value, bit: bit(OUTPUTS, 4), cond: Cond::Always };
    let count = Source::Mem(Place { addr: COUNT, indexed: false });
    vec![
        (ldr(system::IN_PORTS, 0), 0, 11),
        (Op::Write(bit(INPUTS, 0)), 0, 12),
        (ldr(system::IN_PORTS, 1), 0, 13),
        (Op::Write(bit(INPUTS, 1)), 0, 14),
        (ldr(OUTPUTS, 4), 0, 15),
        (Op::Write(bit(system::OUT_PORTS, 4)), 0, 16),
        (Op::Call(0), 0, 17),
        (Op::SeqBegin(0), 0, 18),
        (flag(true), 0, 19),
        (ldr(INPUTS, 0), 0, 20),
        (Op::ExIf { wait_when: false, point: 1, line: 21 }, 0, 21),
        (flag(false), 0, 23),
        (Op::Ex { point: 2, line: 24 }, 0, 24),
        (Op::SeqEnd(0), 0, 25),
        (Op::ModuleEnd, 0, 26),
        (Op::SeqBegin(1), 1, 4),
        (Op::Ex { point: 1, line: 5 }, 1, 5),
        (Op::SeqEnd(1), 1, 6),
        (Op::ModuleEnd, 1, 7),
        (ldr(INPUTS, 0), 0, 29),
        (Op::ModuleEnd, 0, 30),
        (Op::Load { src: count, width: Width::Word, neg: false }, 0, 34),
        (Op::Unary { op: Unary::Increment, width: Width::Word }, 0, 35),
        (Op::Return, 0, 36),
        (ldr(INPUTS, 1), 0, 41),
        (Op::ModuleEnd, 0, 42),
    ]
}

/// The operation at a line of `main.plc`.
pub(crate) fn pc(line: u32) -> u32 {
    code().iter().position(|(_, file, at)| (*file, *at) == (0, line)).expect("a line with code") as u32
}

fn sequence(n: u32, start: u32, end: u32, line: u16, resume: Vec<u32>) -> Sequence {
    let cells = CELLS + n * 8;
    Sequence {
        kind: SequenceKind::Mechanism,
        active_addr: cells,
        active_bit: 0,
        resume_cell: cells + 2,
        wait_cell: cells + 4,
        line_cell: cells + 6,
        start,
        end,
        line,
        resume,
    }
}

fn program() -> Program {
    let code = code();
    let module = |kind, file, start, end| Module { kind, file, start, end };
    Program {
        name: "sample".into(),
        regions: vec![
            Region { kind: RegionKind::System, start: 0, len: system::LEN },
            Region { kind: RegionKind::Global, start: DATA, len: MEMORY - DATA },
        ],
        statements: (0..code.len() as u32).collect(),
        modules: vec![
            module(ModuleKind::Main, 0, 0, 15),
            module(ModuleKind::Main, 1, 15, 19),
            module(ModuleKind::Fast, 0, 19, 21),
            module(ModuleKind::Cont, 0, 24, 26),
        ],
        code: code.into_iter().map(|(op, ..)| op).collect(),
        sequences: vec![sequence(0, 7, 13, 18, vec![11, 13]), sequence(1, 15, 17, 4, vec![17])],
        timed: Vec::new(),
        messages: Vec::new(),
        services: Vec::new(),
        procedures: vec![Procedure { name: "STEP".into(), start: 21, end: 24 }],
        initial: Vec::new(),
        init_finished: Vec::new(),
        done_finished: Vec::new(),
    }
}

fn symbols() -> Vec<Symbol> {
    use SymbolKind as K;
    let all: [(&str, Scope, SymbolKind); 17] = [
        ("INPUTS", Scope::Global, K::Cell { addr: INPUTS, width: Width::Byte }),
        ("KSMP", Scope::Global, K::Bit { addr: INPUTS, bit: 0 }),
        ("KSMM", Scope::Global, K::Bit { addr: INPUTS, bit: 1 }),
        ("OUTPUTS", Scope::Global, K::Cell { addr: OUTPUTS, width: Width::Byte }),
        ("SMP", Scope::Global, K::Bit { addr: OUTPUTS, bit: 4 }),
        ("COUNT", Scope::Global, K::Cell { addr: COUNT, width: Width::Word }),
        ("SPEED", Scope::Global, K::Cell { addr: SPEED, width: Width::DWord }),
        ("TITLE", Scope::Global, K::Text { addr: TITLE, len: 8 }),
        ("TABLE", Scope::Global, K::Area { addr: TABLE, len: 20 }),
        ("RATIO", Scope::Global, K::Cell { addr: RATIO, width: Width::Real }),
        ("LONELY", Scope::Global, K::Bit { addr: LONELY, bit: 3 }),
        ("STEP_NO", Scope::File(1), K::Cell { addr: STEP_NO, width: Width::Byte }),
        ("LIMIT", Scope::Global, K::Constant { value: 12 }),
        ("SPINDLE", Scope::Global, K::Mechanism { sequence: 0 }),
        ("TURRET", Scope::Global, K::Mechanism { sequence: 1 }),
        ("P1IN", Scope::System, K::Cell { addr: system::IN_PORTS, width: Width::Byte }),
        ("PB07", Scope::System, K::Cell { addr: system::PB00 + 7, width: Width::Byte }),
    ];
    all.into_iter()
        .map(|(name, scope, kind)| Symbol { name: name.into(), scope, kind, declared: None })
        .collect()
}

fn mechanism(
    name: &str,
    sequence: u16,
    file: u16,
    lines: (u32, u32),
    states: &[(u32, &str, &str)],
) -> Mechanism {
    let states = states.iter().zip(1..).map(|((line, mnemonic, condition), point)| State {
        point,
        line: *line,
        mnemonic: (*mnemonic).into(),
        condition: (*condition).into(),
    });
    Mechanism { name: name.into(), sequence, file, module: ModuleKind::Main, lines, states: states.collect() }
}

/// The texts of the two files: the lines that open and close sections, comments for the rest.
pub(crate) fn texts() -> [(&'static str, String); 2] {
    let text = |lines: u32, boundaries: &[(u32, &str)]| {
        let line = |n: u32| match boundaries.iter().find(|(at, _)| *at == n) {
            Some((_, boundary)) => format!("{boundary}\n"),
            None => format!("; line {n}\n"),
        };
        (1..=lines).map(line).collect::<Vec<_>>().concat()
    };
    let main = [
        (10, "MODULE_MAIN"),
        (18, "MECH_BEGIN SPINDLE"),
        (25, "MECH_END SPINDLE"),
        (26, "MODULE_MAIN_END"),
        (28, "MODULE_FAST"),
        (30, "MODULE_FAST_END"),
        (33, "PROC_BEGIN STEP"),
        (36, "PROC_END STEP"),
        (40, "MODULE_CONT"),
        (42, "MODULE_CONT_END"),
    ];
    let turret =
        [(3, "MODULE_MAIN"), (4, "MECH_BEGIN TURRET"), (6, "MECH_END TURRET"), (7, "MODULE_MAIN_END")];
    [("main.plc", text(42, &main)), ("turret.plc", text(7, &turret))]
}

/// Program and debug information.
pub(crate) fn image() -> Image {
    let program = program();
    let files = texts()
        .into_iter()
        .zip(0_u8..)
        .map(|((path, text), order)| SourceFile {
            path: path.into(),
            hash: technol_image::container::hash_bytes(text.as_bytes()),
            order: Some(order),
        })
        .collect();
    let lines = code()
        .iter()
        .zip(0_u32..)
        .map(|((_, file, line), pc)| Line { pc, file: *file, line: *line, in_debug_region: *line != 15 })
        .collect();
    let mechanisms = vec![
        mechanism("SPINDLE", 0, 0, (18, 25), &[(21, "EX0", "LDR KSMP"), (24, "EX", "")]),
        mechanism("TURRET", 1, 1, (4, 6), &[(5, "EX", "")]),
    ];
    let debug = DebugInfo { program: content_hash(&program), files, lines, symbols: symbols(), mechanisms };
    Image { program, debug: Some(debug) }
}
