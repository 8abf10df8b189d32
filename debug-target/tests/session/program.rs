//! Programs for the tests, put together from operations.

use technol_image::op::{Arith, BitRef, Cond, Op, Place, Source, Width};
use technol_image::program::{Message, Module, ModuleKind, Program, Region, RegionKind};
use technol_image::system;

/// First byte of DATA.
pub(crate) const DATA: u32 = system::LEN;
/// WORD: counts cycles.
pub(crate) const COUNT: Place = Place { addr: DATA, indexed: false };
/// WORD: divisor.
pub(crate) const DIVISOR: Place = Place { addr: DATA + 2, indexed: false };
/// Bit: says that the message is to be shown.
pub(crate) const SHOW: BitRef = BitRef { addr: DATA + 4, bit: 3, indexed: false };
/// P0OUT.0.
pub(crate) const MOTOR: BitRef = BitRef { addr: system::OUT_PORTS, bit: 0, indexed: false };
/// P1IN.0.
pub(crate) const FEEDBACK: BitRef = BitRef { addr: system::IN_PORTS, bit: 0, indexed: false };

/// First operation of each statement of [`counter`] in MODULE_MAIN.
pub(crate) const LOAD: u32 = 1;
pub(crate) const ADD: u32 = 2;
pub(crate) const STORE: u32 = 3;
pub(crate) const DIVIDE: u32 = 7;

/// Counts cycles in COUNT, drives MOTOR, divides by DIVISOR (1 at first), shows message 27 while SHOW is on.
pub(crate) fn counter() -> Program {
    let word = Width::Word;
    let code = vec![
        Op::ModuleEnd,
        Op::Load { src: Source::Mem(COUNT), width: word, neg: false },
        Op::Arith { op: Arith::Add, src: Source::Int(1), width: word },
        Op::Store { dst: COUNT, width: word, cond: Cond::Always },
        Op::Flag { value: true, bit: MOTOR, cond: Cond::Always },
        Op::Ldr { bit: SHOW, neg: false, push: false },
        Op::Message { index: 0, cond: Cond::IfRlo },
        Op::Arith { op: Arith::Div, src: Source::Mem(DIVISOR), width: word },
        Op::ModuleEnd,
    ];
    let module = |kind, start, end| Module { kind, file: 0, start, end };
    let message = Message {
        number: Some((Source::Int(27), word)),
        sub_id: None,
        set: true,
        parameters: [Some((Source::Mem(COUNT), word)), None, None],
    };
    Program {
        name: "counter".into(),
        regions: vec![
            Region { kind: RegionKind::System, start: 0, len: system::LEN },
            Region { kind: RegionKind::Global, start: DATA, len: 64 },
        ],
        code,
        statements: (1..=7).collect(),
        modules: vec![module(ModuleKind::Init, 0, 1), module(ModuleKind::Main, 1, 9)],
        sequences: vec![],
        timed: vec![],
        messages: vec![message],
        services: Vec::new(),
        procedures: vec![],
        initial: vec![technol_image::program::InitialData { addr: DIVISOR.addr, bytes: vec![1, 0] }],
        init_finished: vec![],
        done_finished: vec![],
    }
}
