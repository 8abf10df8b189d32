//! Time of one 20 ms cycle of mixed operations, with and without an armed break-point that is not hit.
//! `cargo bench -p technol-runtime`
#![allow(missing_docs, reason = "criterion_group writes an undocumented function")]

#[path = "../tests/runtime/support/mod.rs"]
mod support;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};

use support::{Bench, Builder, GLOBAL as A, bit, cell, ldr, lod, mem, sto};
use technol_image::op::{Arith, Compare, Cond, Logic, Op, Source, Width};

/// Operations of one stretch of the mixture: two equations of different length, a conditional jump, data
/// transfer, arithmetic, a comparison and a timer.
const STRETCH: usize = 25;

fn stretch(b: &mut Builder, n: u32) {
    let at = A + n % 64;
    let logic = |op, n: u32, neg| Op::Logic { op, bit: bit(at + n, (n % 8) as u8), neg };
    b.op(ldr(bit(at, 1)));
    b.ops([logic(Logic::And, 1, false), logic(Logic::Or, 2, true), logic(Logic::And, 3, false)]);
    b.ops([logic(Logic::Xor, 4, false), logic(Logic::And, 5, true)]);
    b.ops([Op::Write(bit(at + 100, 0)), Op::Write(bit(at + 101, 3))]);
    b.ops([ldr(bit(at + 100, 0)), Op::Ldr { bit: bit(at, 2), neg: true, push: true }]);
    b.ops([logic(Logic::Or, 6, false), Op::LogicPop(Logic::And)]);
    let over = b.label();
    b.jump(over, Cond::IfRlo);
    b.ops([lod(i64::from(n)), sto(at + 128, Width::Word)]);
    b.place(over);
    b.op(Op::Load { src: mem(at + 128), width: Width::Word, neg: false });
    b.op(Op::Arith { op: Arith::Add, src: Source::Int(3), width: Width::DWord });
    b.op(Op::Arith { op: Arith::Mul, src: mem(at + 130), width: Width::Word });
    b.op(Op::Compare { op: Compare::Gt, src: Source::Int(1000), width: Width::DWord, if_rlo: false });
    b.op(Op::Flag { value: true, bit: bit(at + 200, 1), cond: Cond::IfRlo });
    b.ops([ldr(bit(at, 7)), logic(Logic::And, 3, true), Op::Write(bit(at + 102, 2))]);
    b.op(Op::Timer { count: cell(at + 220), width: Width::Byte });
    b.op(Op::Write(bit(at + 103, 1)));
}

fn program(operations: usize, armed: bool) -> Bench {
    let mut bench = Builder::new()
        .main(|b| {
            for n in 0..operations / STRETCH {
                stretch(b, n as u32);
            }
            let end = b.label();
            b.jump(end, Cond::Always);
            b.op(Op::Nop);
            b.place(end);
        })
        .load()
        .started();
    if armed {
        // The NOP that is always jumped over.
        let nop = bench.plc.program().modules[0].end - 2;
        assert_eq!(bench.plc.set_breakpoints(&[nop]), [Ok(())]);
    }
    bench.plc.write_memory(A, &[0x5A, 0xC3, 0x0F, 0x96, 0x69].repeat(20)).expect("in memory");
    bench
}

fn cycle(c: &mut Criterion) {
    let mut group = c.benchmark_group("cycle");
    for operations in [1_000, 10_000] {
        for (name, armed) in [("plain", false), ("armed", true)] {
            let mut bench = program(operations, armed);
            group.throughput(Throughput::Elements(operations as u64));
            group.bench_function(format!("{operations}/{name}"), |b| b.iter(|| bench.cycles(1)));
        }
    }
    group.finish();
}

criterion_group!(benches, cycle);
criterion_main!(benches);
