//! Counting executed statements.

use technol_image::op::{Cond, Op};
use technol_image::program::ModuleKind;
use technol_runtime::{Resume, StopReason};

use crate::support::{Bench, Builder, GLOBAL as A, bit, count, la, ldr};

/// MODULE_MAIN, operations 0 to 8: an equation, which the free run fuses, and a count that only A.0 lets happen.
/// MODULE_FAST, from operation 9 on, counts.
fn bench() -> Bench {
    let mut builder = Builder::new().main(|b| {
        let skip = b.label();
        b.ops([ldr(bit(A, 0)), la(bit(A, 0)), Op::Write(bit(A, 1))]);
        b.jump(skip, Cond::IfNotRlo);
        b.ops(count(A + 2));
        b.place(skip);
        b.op(ldr(bit(A, 1)));
    });
    builder.module(ModuleKind::Fast, 0, |b| b.ops(count(A + 4)));
    builder.load().started()
}

#[test]
fn statements_of_every_module_are_counted_from_the_moment_on_it_is_asked_for() {
    let mut bench = bench();
    bench.cycles(1);
    assert_eq!(bench.plc.statement_counts(), None, "nobody asked");
    bench.plc.count_statements(true);
    bench.cycles(2);
    let counts = |bench: &Bench| bench.plc.statement_counts().expect("asked for").to_vec();
    assert_eq!(counts(&bench)[..9], [2, 2, 2, 2, 0, 0, 0, 2, 2], "jumped over");
    assert_eq!(counts(&bench)[9..], [40, 40, 40, 40]);
    bench.set(bit(A, 0), true);
    bench.cycles(1);
    assert_eq!(counts(&bench)[..9], [3, 3, 3, 3, 1, 1, 1, 3, 3]);
    bench.plc.count_statements(true);
    assert!(counts(&bench).iter().all(|count| *count == 0), "from zero again");
    bench.plc.count_statements(false);
    bench.cycles(1);
    assert_eq!(bench.plc.statement_counts(), None);
}

#[test]
fn counting_changes_nothing_else() {
    let mut plain = bench();
    let mut counting = bench();
    counting.plc.count_statements(true);
    for _ in 0..5 {
        for bench in [&mut plain, &mut counting] {
            let on = bench.bit(bit(A, 0));
            bench.set(bit(A, 0), !on);
            bench.cycles(1);
        }
        assert_eq!(plain.plc.state_hash(), counting.plc.state_hash());
        assert_eq!(plain.plc.memory(), counting.plc.memory());
    }
    assert_eq!(plain.events, counting.events);
}

#[test]
fn a_statement_with_a_break_point_holds_and_counts_once() {
    let mut bench = bench();
    bench.plc.count_statements(true);
    bench.plc.set_breakpoints(&[1]);
    bench.run_to_stop(1);
    let stop = bench.plc.stopped().expect("held");
    assert_eq!((stop.reason, stop.pc), (StopReason::Breakpoint, 1));
    bench.plc.resume(Resume::Continue);
    bench.tick();
    assert_eq!(bench.plc.statement_counts().expect("asked for")[..4], [1, 1, 1, 1]);
}
