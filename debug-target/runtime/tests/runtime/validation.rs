//! Programs that must not be loaded.

use technol_image::op::{Arith, DrTest, Op, Place, Source, Width};
use technol_image::program::{InitialData, Module, ModuleKind, RegionKind};
use technol_image::{BitRef, Cond, Program};
use technol_runtime::{LoadItem, Runtime};

use crate::support::{Builder, END, GLOBAL as A, bit, cell, mem};

fn program() -> Program {
    let mut b = Builder::new();
    b.procedure("P", [Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| {
        b.op(Op::Nop);
        b.mechanism(|b| {
            let error = b.label();
            b.ex();
            b.tex(true, A, mem(A + 2), error, Some(1));
            b.place(error);
        });
    });
    b.build()
}

#[track_caller]
fn rejected(change: impl FnOnce(&mut Program), item: LoadItem) {
    let mut program = program();
    change(&mut program);
    match Runtime::new(program) {
        Ok(_) => panic!("accepted"),
        Err(error) => {
            assert_eq!(error.item, item, "{error}");
            assert!(error.to_string().ends_with("build the program again"));
        }
    }
}

#[test]
fn the_program_the_changes_start_from_is_accepted() {
    assert!(Runtime::new(program()).is_ok());
}

#[test]
fn operands_that_leave_memory_or_code_are_rejected() {
    let outside = BitRef { addr: END, bit: 0, indexed: false };
    let far = Place { addr: END - 1, indexed: false };
    let ops = [
        Op::Ldr { bit: outside, neg: false, push: false },
        Op::Write(outside),
        Op::Write(BitRef { bit: 8, ..bit(A, 0) }),
        Op::Ldr { bit: BitRef { addr: 0, bit: 8, indexed: true }, neg: false, push: false },
        Op::MoveBit { dst: bit(A, 0), src: outside, neg: false, cond: Cond::Always },
        Op::Edge { rising: true, bit: bit(A, 0), state: END },
        Op::Load { src: Source::Mem(far), width: Width::Word, neg: false },
        Op::Load { src: mem(u32::MAX), width: Width::QWord, neg: false },
        Op::Store { dst: far, width: Width::QWord, cond: Cond::Always },
        Op::Move { dst: cell(A), src: far, width: Width::DWord, cond: Cond::Always },
        Op::Copy { src: cell(A), dst: far, len: 2 },
        Op::Copy { src: Place { addr: 0, indexed: true }, dst: cell(A), len: END + 1 },
        Op::Clear { addr: A, len: u32::MAX },
        Op::Shift { left: true, count: mem(END), width: Width::Word },
        Op::Timer { count: far, width: Width::Word },
        Op::Counter { op: technol_image::op::Count::Up, count: cell(A), width: Width::Byte, state: END },
        Op::Jump { target: 1_000, cond: Cond::Always },
        Op::Raster { rate: technol_image::op::Raster::Tenth, end: 1_000 },
        Op::Call(1),
        Op::SeqInit(1),
        Op::SeqBegin(0),
        Op::SeqEnd(0),
        Op::Timed(1),
        Op::Message { index: 0, cond: Cond::Always },
        Op::Ex { point: 1, line: 1 },
        Op::InitFinished(64),
        Op::DoneFinished(200),
    ];
    for op in ops {
        rejected(|p| p.code[0] = op, LoadItem::Op(0));
    }
}

#[test]
fn widths_an_operation_does_not_have_are_rejected() {
    let int = Source::Int(1);
    let real = Source::Real(1.0);
    let ops = [
        Op::Load { src: int, width: Width::Real, neg: false },
        Op::Load { src: real, width: Width::QWord, neg: false },
        Op::Arith { op: Arith::Mul, src: int, width: Width::QWord },
        Op::Arith { op: Arith::Div, src: int, width: Width::QWord },
        Op::Arith { op: Arith::Or, src: real, width: Width::Real },
        Op::Arith { op: Arith::And, src: mem(A), width: Width::Real },
        Op::BcdToBin(Width::Byte),
        Op::BinToBcd(Width::QWord),
        Op::Shift { left: true, count: real, width: Width::Word },
        Op::Shift { left: true, count: int, width: Width::Real },
        Op::DrToRlo(DrTest::Bit(32)),
        Op::DrToRlo(DrTest::NonZero(Width::Real)),
        Op::RloToDr(Width::Real),
        Op::IntToReal(Width::Real),
        Op::Timer { count: cell(A), width: Width::DWord },
        Op::SelectBlock { offset: 361, len: 8 },
        Op::SelectBlock { offset: 0, len: 0 },
        Op::SelectBlock { offset: 0, len: 9 },
    ];
    for op in ops {
        rejected(|p| p.code[0] = op, LoadItem::Op(0));
    }
}

#[test]
fn processor_instructions_with_operands_they_do_not_have_are_rejected() {
    use technol_image::assembler::{Condition, Function, Operand, Register};
    let register = |name| Operand::Register(Register::named(name).expect("a register"));
    let near = Operand::Cell(cell(A));
    let far = Operand::Cell(Place { addr: END - 1, indexed: false });
    let one = Operand::Number(1);
    let ops = [
        (Function::Add, Width::Word, far, one),
        (Function::Add, Width::Word, register("CX"), far),
        (Function::Add, Width::QWord, near, one),
        (Function::Move, Width::Real, near, one),
        (Function::Move, Width::Word, one, near),
        (Function::Compare, Width::Word, one, one),
        (Function::Move, Width::Word, near, near),
        (Function::Move, Width::Word, register("ECX"), one),
        (Function::Move, Width::Word, register("CX"), register("AL")),
        (Function::Move, Width::Word, near, register("EAX")),
        (Function::ShiftLeft, Width::Word, near, register("CX")),
        (Function::ShiftRight, Width::Byte, register("AL"), near),
        (Function::Increment, Width::Byte, register("AL"), Operand::Number(2)),
        (Function::Decrement, Width::Byte, register("AL"), register("BL")),
    ];
    for (function, width, to, from) in ops {
        rejected(|p| p.code[0] = Op::Assembler { function, width, to, from }, LoadItem::Op(0));
    }
    let jump = Op::AssemblerJump { condition: Condition::Equal, target: 1_000 };
    rejected(|p| p.code[0] = jump, LoadItem::Op(0));
}

#[test]
fn tables_that_do_not_fit_the_code_are_rejected() {
    rejected(|p| p.statements.push(1_000), LoadItem::Statement(program().statements.len()));
    rejected(|p| p.statements.swap(0, 1), LoadItem::Statement(1));
    rejected(|p| p.modules[0].end -= 1, LoadItem::Module(0));
    rejected(|p| p.modules[0].start = 1_000, LoadItem::Module(0));
    rejected(|p| p.modules[0].file = 64, LoadItem::Module(0));
    let empty = Module { kind: ModuleKind::Main, file: 1, start: 2, end: 2 };
    rejected(|p| p.modules.push(empty), LoadItem::Module(1));
    rejected(|p| p.procedures[0].end += 1, LoadItem::Procedure(0));
    rejected(|p| p.code.push(Op::Nop), LoadItem::Program);
    rejected(|p| p.init_finished.push(64), LoadItem::Program);
}

#[test]
fn damaged_sequences_are_rejected() {
    let item = LoadItem::Sequence(0);
    rejected(|p| p.sequences[0].start = 0, item);
    rejected(|p| p.sequences[0].end = 0, item);
    rejected(|p| p.sequences[0].active_bit = 8, item);
    rejected(|p| p.sequences[0].active_addr = END, item);
    rejected(|p| p.sequences[0].line_cell = END - 1, item);
    rejected(|p| p.sequences[0].resume[0] = 0, item);
    rejected(|p| p.sequences[0].resume[1] = u32::MAX, item);
    rejected(|p| p.sequences[0].resume.truncate(1), LoadItem::Op(3));
    rejected(|p| p.timed[0].point = 0, LoadItem::Op(3));
    rejected(|p| p.sequences.clear(), LoadItem::Op(1));
}

#[test]
fn damaged_parameters_are_rejected() {
    rejected(|p| p.timed[0].width = Width::DWord, LoadItem::Timed(0));
    rejected(|p| p.timed[0].count.addr = END, LoadItem::Timed(0));
    rejected(|p| p.timed[0].time = Source::Real(1.0), LoadItem::Timed(0));
    rejected(|p| p.timed[0].error = Some(1_000), LoadItem::Timed(0));
    rejected(|p| p.timed[0].error = None, LoadItem::Timed(0));
    rejected(|p| p.timed[0].code = Some((Source::Real(1.0), Width::Real)), LoadItem::Timed(0));
    let initial = InitialData { addr: END - 1, bytes: vec![1, 2] };
    rejected(|p| p.initial.push(initial), LoadItem::Initial(0));
}

#[test]
fn memory_that_overlaps_or_is_too_large_is_rejected() {
    rejected(|p| p.regions[1].start -= 1, LoadItem::Region(1));
    rejected(|p| p.regions[3].len = u32::MAX, LoadItem::Region(3));
    rejected(|p| p.regions[3].len = 1 << 24, LoadItem::Region(3));
    rejected(|p| p.regions[0].len = 0x3FF, LoadItem::Program);
    rejected(|p| p.regions[0].kind = RegionKind::Local, LoadItem::Program);
}
