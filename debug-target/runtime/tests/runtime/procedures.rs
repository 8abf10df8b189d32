//! Procedures, messages and the event procedures (manual 3.17, 14.1; ruling 36).

use technol_image::op::{Cond, Op, Source, Width};
use technol_image::program::Message;
use technol_image::program::ModuleKind;
use technol_runtime::{Command, FaultKind, Registers, RuntimeEvent, TickOutcome};

use crate::support::{Bench, Builder, GLOBAL as A, bit, count, ldr, lod, mem, set, sto};

fn message(number: Option<(Source, Width)>) -> Message {
    Message { number, sub_id: None, set: true, parameters: [None; 3] }
}

/// Number, supplementary number, shown, parameters.
type Shown = (u32, Option<i64>, bool, [Option<i64>; 3]);

fn messages(bench: &Bench) -> Vec<Shown> {
    bench
        .events
        .iter()
        .filter_map(|event| match event {
            RuntimeEvent::Message { number, sub_id, set, parameters, .. } => {
                Some((*number, *sub_id, *set, *parameters))
            }
            _ => None,
        })
        .collect()
}

#[test]
fn registers_pass_through_a_call_both_ways() {
    let mut b = Builder::new();
    b.procedure(
        "DOUBLE",
        [
            Op::Arith { op: technol_image::op::Arith::Mul, src: Source::Int(2), width: Width::DWord },
            Op::Complement,
        ],
    );
    b.module(ModuleKind::Main, 0, |b| {
        b.ops([lod(21), ldr(bit(A, 0)), Op::Call(0), sto(A + 8, Width::DWord), Op::Write(bit(A, 1))]);
    });
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!((bench.word(A + 8), bench.bit(bit(A, 1))), (42, true));
}

#[test]
fn calls_nest_and_return_in_order() {
    let mut b = Builder::new();
    let inner = b.procedure("INNER", count(A));
    b.procedure("OUTER", [Op::Call(inner), Op::Call(inner)]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(1), Op::Call(0)]));
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!(bench.word(A), 3);
}

#[test]
fn recursion_is_a_fault() {
    let mut b = Builder::new();
    b.procedure("AGAIN", [Op::Call(0)]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(0)]));
    let mut bench = b.load().started();
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    assert_eq!(bench.plc.fault().map(|f| f.kind), Some(FaultKind::CallDepth));
    assert_eq!(bench.plc.call_stack().len(), 65);
}

#[test]
fn return_without_a_call_is_a_fault() {
    let mut bench = Builder::new().main(|b| b.ops([Op::Return])).load().started();
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    assert_eq!(bench.plc.fault().map(|f| f.kind), Some(FaultKind::UnexpectedReturn));
}

#[test]
fn module_end_inside_a_procedure_is_a_fault() {
    let mut b = Builder::new();
    b.procedure("LOST", [Op::Jump { target: 1, cond: Cond::Always }]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(0)]));
    let mut bench = b.load().started();
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    assert_eq!(bench.plc.fault().map(|f| f.kind), Some(FaultKind::UnexpectedEnd));
}

#[test]
fn message_takes_its_number_from_a_constant_a_cell_or_dr() {
    let mut bench = Builder::new()
        .main(|b| {
            b.op(lod(0x7_0011));
            b.message(message(Some((Source::Int(12), Width::DWord))), Cond::Always);
            b.message(message(Some((mem(A), Width::Word))), Cond::Always);
            b.message(message(None), Cond::Always);
        })
        .load()
        .started();
    bench.plc.write_memory(A, &[0xFF, 0xFF]).expect("in memory");
    bench.cycles(1);
    let numbers: Vec<_> = messages(&bench).into_iter().map(|m| m.0).collect();
    assert_eq!(numbers, [12, 0xFFFF, 0x11]);
}

#[test]
fn message_carries_its_parameters() {
    let full = Message {
        number: Some((Source::Int(67), Width::DWord)),
        sub_id: Some((mem(A), Width::DWord)),
        set: false,
        parameters: [None, Some((mem(A + 4), Width::DWord)), Some((Source::Int(9), Width::DWord))],
    };
    let mut bench = Builder::new()
        .main(|b| {
            b.message(full, Cond::Always);
        })
        .load()
        .started();
    bench.plc.write_memory(A, &[1, 0, 0, 0, 0xFE, 0xFF, 0xFF, 0xFF]).expect("in memory");
    bench.cycles(1);
    assert_eq!(messages(&bench), [(67, Some(1), false, [None, Some(-2), Some(9)])]);
}

#[test]
fn conditional_message_needs_rlo_and_repeats_every_pass() {
    let mut bench = Builder::new()
        .main(|b| {
            b.op(ldr(bit(A, 0)));
            b.message(message(Some((Source::Int(5), Width::DWord))), Cond::IfRlo);
        })
        .load()
        .started();
    bench.cycles(2);
    assert!(messages(&bench).is_empty());
    bench.set(bit(A, 0), true);
    bench.cycles(3);
    assert_eq!(messages(&bench).len(), 3);
    let cycles = bench.events.iter().filter_map(|event| match event {
        RuntimeEvent::Message { cycle, .. } => Some(*cycle),
        _ => None,
    });
    assert_eq!(cycles.collect::<Vec<_>>(), [2, 3, 4]);
}

#[test]
fn on_eset_gets_the_number_and_gives_all_registers_back() {
    let mut b = Builder::new();
    b.procedure(
        "_ON_ESET",
        [
            sto(A + 8, Width::DWord),
            lod(-1),
            Op::Load { src: Source::Real(2.5), width: Width::Real, neg: false },
            Op::Complement,
        ],
    );
    b.module(ModuleKind::Main, 0, |b| {
        b.op(lod(77));
        b.op(Op::Ldr { bit: bit(A, 0), neg: true, push: false });
        b.op(Op::Ldr { bit: bit(A, 0), neg: true, push: true });
        b.message(message(Some((Source::Int(300), Width::DWord))), Cond::Always);
    });
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!(bench.word(A + 8), 300);
    let after = Registers { rlo: true, dr: 77, stack: 1, depth: 1, ..Registers::default() };
    assert_eq!(bench.plc.registers(), after);
}

#[test]
fn message_from_within_on_eset_is_reported_once() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| {
        b.message(message(Some((Source::Int(1), Width::DWord))), Cond::Always);
    });
    b.edit(|program| program.messages.push(message(Some((Source::Int(2), Width::DWord)))));
    b.procedure("_ON_ESET", [Op::Message { index: 1, cond: Cond::Always }]);
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!(messages(&bench).iter().map(|m| m.0).collect::<Vec<_>>(), [1, 2]);
}

#[test]
fn on_event_is_called_in_the_next_cycle_once_per_event() {
    let mut b = Builder::new();
    b.procedure("_ON_EVENT", [sto(A + 8, Width::DWord)].into_iter().chain(count(A)));
    b.module(ModuleKind::Main, 0, |b| b.op(set(bit(A + 4, 0), true)));
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!(bench.word(A), 0);
    bench.command(Command::Event(4));
    bench.command(Command::Event(3));
    bench.cycles(2);
    assert_eq!((bench.word(A), bench.word(A + 8)), (2, 3));
}

#[test]
fn event_without_its_procedure_is_ignored() {
    let mut bench = Builder::new().main(|b| b.ops(count(A))).load().started();
    bench.command(Command::Event(1));
    bench.cycles(1);
    assert_eq!(bench.word(A), 1);
}
