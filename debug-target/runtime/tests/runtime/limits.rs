//! Loops that yield and loops that do not, overruns, overwritten cells: rulings 26 and 27.

use technol_image::op::{Cond, Op};
use technol_image::program::ModuleKind;
use technol_runtime::{Command, FaultKind, Limits, PlcState, RateKind, Resume, RuntimeEvent, TickOutcome};

use crate::support::{Bench, Builder, GLOBAL as A, bit, count, la, ldr};

/// A mechanism that counts its rounds in the first WORD of data, without end.
fn endless(yields: bool) -> Bench {
    Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let again = b.label();
                b.place(again);
                b.ops(count(A));
                if yields {
                    b.ex();
                } else {
                    b.bex();
                }
                b.jump(again, Cond::Always);
            });
        })
        .load()
        .started()
}

#[test]
fn endless_mechanism_that_yields_runs_once_per_cycle() {
    let mut bench = endless(true);
    bench.activate(0);
    bench.cycles(50);
    assert_eq!((bench.word(A), bench.state()), (50, PlcState::Running));
}

#[test]
fn endless_loop_is_stopped_and_the_debugger_still_answers() {
    let mut bench = endless(false);
    bench.plc.set_limits(Limits { per_pass: 10_000, ..Limits::default() });
    bench.activate(0);
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    let fault = *bench.plc.fault().expect("faulted");
    assert_eq!(
        (fault.kind, fault.sequence, fault.module, fault.file),
        (FaultKind::EndlessLoop, Some(0), ModuleKind::Main, 0)
    );
    assert!(bench.events.contains(&RuntimeEvent::Fault(fault)));
    assert!(bench.events.contains(&RuntimeEvent::StateChanged(PlcState::Faulted)));
    assert_eq!(bench.plc.stopped().map(|stop| stop.pc), Some(fault.pc));
    assert_eq!(bench.plc.registers().dr & 0xFFFF, i64::from(bench.word(A)));
    bench.command(Command::StartPlc { cold: true });
    bench.tick();
    assert_eq!((bench.state(), bench.plc.fault()), (PlcState::Running, None));
    bench.cycles(3);
}

#[test]
fn overrun_of_either_rate_is_reported_and_execution_goes_on() {
    let mut b = Builder::new();
    b.module(ModuleKind::Fast, 0, |b| b.ops([Op::Nop; 9]));
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Nop; 29]));
    let mut bench = b.load().started();
    bench.plc.set_limits(Limits { per_cycle: Some(30), per_fast: Some(10), ..Limits::default() });
    bench.cycles(2);
    assert!(!bench.events.iter().any(|e| matches!(e, RuntimeEvent::Overrun { .. })));
    bench.plc.set_limits(Limits { per_cycle: Some(29), per_fast: Some(9), ..Limits::default() });
    bench.millis(1);
    let overruns: Vec<_> =
        bench.events.iter().filter(|e| matches!(e, RuntimeEvent::Overrun { .. })).collect();
    assert_eq!(
        overruns,
        [
            &RuntimeEvent::Overrun { cycle: 2, rate: RateKind::Fast, executed: 10, limit: 9 },
            &RuntimeEvent::Overrun { cycle: 2, rate: RateKind::Cycle, executed: 30, limit: 29 },
        ]
    );
}

#[test]
fn overwritten_continuation_is_a_fault() {
    let mut bench = endless(true);
    bench.activate(0);
    let cell = bench.plc.program().sequences[0].resume_cell;
    bench.plc.write_memory(cell, &[2, 0]).expect("in memory");
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    let kind = bench.plc.fault().map(|fault| fault.kind);
    assert_eq!(kind, Some(FaultKind::BadContinuation { sequence: 0, point: 2 }));
}

#[test]
fn budget_ends_at_the_same_operation_freely_and_stepped() {
    // A loop of a fused equation and a jump: every place in it is where the budget may end.
    for per_pass in 1..20 {
        let mut bench = Builder::new()
            .main(|b| {
                let again = b.label();
                b.place(again);
                b.ops([ldr(bit(A, 0)), la(bit(A, 1)), Op::Complement, Op::Write(bit(A, 2))]);
                b.jump(again, Cond::Always);
            })
            .load()
            .started();
        bench.plc.set_limits(Limits { per_pass, ..Limits::default() });
        let mut stepped = bench.clone();
        assert_eq!(bench.tick(), TickOutcome::Stopped);
        assert_eq!(bench.plc.fault().map(|fault| fault.pc), Some(per_pass % 5));
        stepped.plc.pause();
        while stepped.plc.fault().is_none() {
            stepped.tick();
            stepped.plc.resume(Resume::StepInto);
        }
        assert_eq!(bench.plc.fault(), stepped.plc.fault());
        assert_eq!(bench.plc.state_hash(), stepped.plc.state_hash());
    }
}

#[test]
fn what_runs_while_held_does_not_count_as_overrun() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Nop; 3]));
    b.module(ModuleKind::Cont, 0, |b| b.ops([Op::Nop; 3]));
    let mut bench = b.load().started();
    bench.plc.set_limits(Limits { per_cycle: Some(8), ..Limits::default() });
    bench.plc.set_breakpoints(&[1]);
    for _ in 0..100 {
        bench.tick();
    }
    bench.plc.resume(Resume::Continue);
    bench.millis(1);
    assert!(!bench.events.iter().any(|e| matches!(e, RuntimeEvent::Overrun { .. })));
}
