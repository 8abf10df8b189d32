//! Modules, their order, ports, starting and stopping (manual 5; rulings 29, 37).

use technol_image::op::{Op, Width};
use technol_image::program::{InitialData, ModuleKind};
use technol_image::system;
use technol_runtime::{Command, FaultKind, PlcState, RuntimeEvent, TickOutcome};

use crate::support::{Bench, Builder, GLOBAL as A, HIDDEN, LOCAL, bit, count, ldr, lod, sto};

/// Writes the next number of a log: which module ran when.
fn log(b: &mut Builder, number: u8) {
    use technol_image::op::{Cond, Place};
    b.ops(count(A));
    b.op(Op::IndexFromDr);
    b.op(lod(i64::from(number)));
    let dst = Place { addr: A + 0x10, indexed: true };
    b.op(Op::Store { dst, width: Width::Byte, cond: Cond::Always });
}

fn logged(bench: &Bench) -> Vec<u8> {
    (1..=bench.word(A)).map(|n| bench.byte(A + 0x10 + u32::from(n))).collect()
}

#[test]
fn modules_run_in_the_order_of_the_cycle_and_of_the_files() {
    let mut b = Builder::new();
    b.module(ModuleKind::Cont, 0, |b| log(b, 9));
    b.module(ModuleKind::Main, 0, |b| log(b, 4));
    b.module(ModuleKind::Main, 1, |b| log(b, 5));
    b.module(ModuleKind::Input, 0, |b| log(b, 3));
    b.module(ModuleKind::Fast, 0, |b| log(b, 1));
    b.module(ModuleKind::Fast, 1, |b| log(b, 2));
    b.module(ModuleKind::Init, 0, |b| log(b, 7));
    b.module(ModuleKind::Init, 1, |b| log(b, 8));
    let mut bench = b.load().started();
    assert_eq!(logged(&bench), [7, 8]);
    bench.millis(2);
    assert_eq!(logged(&bench), [7, 8, 1, 2, 3, 4, 5, 9, 1, 2], "FAST first, then the cycle");
}

#[test]
fn slow_modules_run_each_20_ms_and_fast_ones_each_millisecond() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| b.ops(count(A)));
    b.module(ModuleKind::Fast, 0, |b| b.ops(count(A + 2)));
    let mut bench = b.load().started();
    assert_eq!((bench.plc.millis(), bench.plc.cycle()), (0, 0));
    bench.millis(1);
    assert_eq!((bench.word(A), bench.word(A + 2)), (1, 1));
    bench.millis(19);
    assert_eq!((bench.word(A), bench.word(A + 2)), (1, 20));
    assert_eq!((bench.plc.millis(), bench.plc.cycle()), (20, 1));
    bench.millis(1);
    assert_eq!((bench.word(A), bench.word(A + 2)), (2, 21));
}

#[test]
fn ports_are_copied_around_the_cycle() {
    let mut bench = Builder::new()
        .main(|b| b.ops([ldr(bit(system::IN_PORTS + 2, 5)), Op::Write(bit(system::OUT_PORTS, 1))]))
        .load()
        .started();
    bench.inputs[2] = 0b0010_0000;
    bench.millis(1);
    assert_eq!(bench.plc.outputs()[0], 0b10);
    bench.inputs[2] = 0;
    bench.millis(19);
    assert_eq!(bench.plc.outputs()[0], 0b10, "not within the cycle");
    bench.millis(1);
    assert_eq!(bench.plc.outputs()[0], 0);
}

#[test]
fn force_to_0_wins_over_force_to_1() {
    let mut bench = Builder::new().main(|b| b.ops([])).load().started();
    let masks = [
        (system::IN_FORCE_HIGH + 4, 0b0011),
        (system::IN_FORCE_LOW + 4, 0b0101),
        (system::OUT_PORTS + 7, 0b1100),
        (system::OUT_FORCE_HIGH + 7, 0b0011),
        (system::OUT_FORCE_LOW + 7, 0b0101),
    ];
    for (addr, mask) in masks {
        bench.plc.write_memory(addr, &[mask]).expect("in memory");
    }
    bench.inputs[4] = 0b1100;
    bench.millis(1);
    assert_eq!(bench.byte(system::IN_PORTS + 4), 0b1010);
    assert_eq!(bench.plc.outputs()[7], 0b1010);
    assert_eq!(bench.byte(system::OUT_PORTS + 7), 0b1100, "forcing does not change the cell");
}

#[test]
fn fast_ports_are_copied_each_millisecond() {
    let mut b = Builder::new();
    b.module(ModuleKind::Fast, 0, |b| {
        b.ops([ldr(bit(system::IN_PORTS + 4, 0)), Op::Write(bit(system::OUT_PORTS + 1, 0))]);
    });
    let mut bench = b.load();
    bench.plc.set_fast_ports(&[4], &[1]).expect("ports exist");
    let mut bench = bench.started();
    for value in [1, 0, 1, 1, 0] {
        bench.inputs[4] = value;
        bench.millis(1);
        assert_eq!(bench.plc.outputs()[1], value);
    }
    assert!(bench.plc.set_fast_ports(&[128], &[]).is_err());
    assert!(bench.plc.set_fast_ports(&[], &[96]).is_err());
}

#[test]
fn the_fastest_module_runs_after_the_fast_ones_as_often_as_its_period_fits() {
    let mut b = Builder::new();
    b.module(ModuleKind::Fastest, 0, |b| log(b, 3));
    b.module(ModuleKind::Fast, 0, |b| log(b, 2));
    b.module(ModuleKind::CyclicOperation, 0, |b| log(b, 1));
    let mut bench = b.load().started();
    bench.millis(2);
    assert_eq!(logged(&bench), [1, 2, 3, 1, 2, 3], "once a millisecond unless set");
    let wrong = bench.plc.set_fastest_period(300).expect_err("no such period");
    assert!(wrong.to_string().contains("not every 300"));
    bench.plc.set_fastest_period(250).expect("a period");
    bench.millis(1);
    assert_eq!(logged(&bench)[6..], [1, 2, 3, 3, 3, 3]);
}

fn with_init(b: &mut Builder) {
    b.module(ModuleKind::Init, 0, |b| b.ops([sto(A + 8, Width::DWord), lod(99)]));
    b.module(ModuleKind::Init, 1, |b| b.op(sto(A + 12, Width::DWord)));
    b.edit(|p| p.initial.push(InitialData { addr: A + 4, bytes: vec![7, 8] }));
}

#[test]
fn cold_start_zeroes_memory_and_warm_start_keeps_it() {
    let mut b = Builder::new();
    with_init(&mut b);
    let mut bench = b.load();
    assert_eq!(bench.word(A + 4), 0x0807, "initial data is there when the program is loaded");
    assert_eq!(bench.state(), PlcState::Stopped);
    bench = bench.started();
    assert_eq!(bench.state(), PlcState::Running);
    for (addr, value) in [(A + 4, 1), (LOCAL, 2), (HIDDEN, 3), (A + 8, 0xEE)] {
        bench.plc.write_memory(addr, &[value]).expect("in memory");
    }
    bench.cycles(2);
    bench.command(Command::StartPlc { cold: false });
    bench.tick();
    assert_eq!([A + 4, LOCAL, HIDDEN].map(|addr| bench.byte(addr)), [1, 2, 0], "hidden states are new");
    assert_eq!((bench.word(A + 8), bench.word(A + 12)), (1, 1), "DR = 1 in each file");
    assert_eq!(bench.plc.millis(), 0);
    bench.command(Command::StartPlc { cold: true });
    bench.tick();
    assert_eq!([A + 4, A + 5, LOCAL, HIDDEN].map(|addr| bench.byte(addr)), [7, 8, 0, 0]);
    assert_eq!((bench.word(A + 8), bench.word(A + 12)), (0, 0), "DR = 0 in each file");
}

#[test]
fn start_waits_for_every_file_that_reports_while_the_cycle_runs() {
    let mut b = Builder::new();
    for file in 0..2 {
        b.module(ModuleKind::Main, file, |b| {
            b.ops(count(A + 2 * u32::from(file)));
            let skip = b.label();
            b.op(ldr(bit(A + 8, file)));
            b.jump(skip, technol_image::op::Cond::IfNotRlo);
            b.op(Op::InitFinished(file));
            b.place(skip);
        });
    }
    b.edit(|p| p.init_finished = vec![0, 1]);
    let mut bench = b.load().started();
    bench.cycles(3);
    assert_eq!((bench.state(), bench.word(A), bench.word(A + 2)), (PlcState::Starting, 3, 3));
    bench.set(bit(A + 8, 1), true);
    bench.cycles(1);
    assert_eq!(bench.state(), PlcState::Starting);
    bench.set(bit(A + 8, 0), true);
    bench.cycles(1);
    assert_eq!(bench.state(), PlcState::Running);
    let states: Vec<_> = bench.events.iter().collect();
    assert_eq!(
        states,
        [&RuntimeEvent::StateChanged(PlcState::Starting), &RuntimeEvent::StateChanged(PlcState::Running)]
    );
}

fn stopping(waits: bool) -> Bench {
    let mut b = Builder::new();
    b.module(ModuleKind::Done, 0, |b| b.ops([sto(A + 8, Width::DWord)]));
    b.module(ModuleKind::Main, 0, |b| {
        b.ops(count(A));
        b.op(Op::Flag { value: true, bit: bit(system::OUT_PORTS, 0), cond: technol_image::op::Cond::Always });
        let skip = b.label();
        b.op(ldr(bit(A + 4, 0)));
        b.jump(skip, technol_image::op::Cond::IfNotRlo);
        b.op(Op::DoneFinished(0));
        b.place(skip);
    });
    if waits {
        b.edit(|p| p.done_finished = vec![0]);
    }
    let mut bench = b.load().started();
    bench.cycles(1);
    assert_eq!(bench.plc.outputs()[0], 1);
    bench
}

#[test]
fn stop_runs_module_done_and_switches_the_outputs_off() {
    for power_off in [true, false] {
        let mut bench = stopping(false);
        bench.command(Command::StopPlc { power_off });
        bench.millis(1);
        assert_eq!((bench.state(), bench.plc.outputs()[0]), (PlcState::Stopped, 0));
        assert_eq!(bench.word(A + 8), u16::from(!power_off), "DR on entry");
        bench.millis(100);
        assert_eq!(bench.word(A), 1, "nothing runs any more");
    }
}

#[test]
fn stop_waits_for_done_finished_while_main_runs() {
    let mut bench = stopping(true);
    bench.command(Command::StopPlc { power_off: false });
    bench.millis(1);
    bench.cycles(5);
    assert_eq!((bench.state(), bench.word(A)), (PlcState::Stopping, 6));
    bench.set(bit(A + 4, 0), true);
    bench.cycles(1);
    assert_eq!(bench.state(), PlcState::Stopped);
}

#[test]
fn second_stop_does_not_wait() {
    let mut bench = stopping(true);
    bench.command(Command::StopPlc { power_off: false });
    bench.millis(3);
    bench.command(Command::StopPlc { power_off: false });
    bench.millis(1);
    assert_eq!(bench.state(), PlcState::Stopped);
}

#[test]
fn clear_and_halt_run_their_modules_once() {
    let mut b = Builder::new();
    b.module(ModuleKind::Clear, 0, |b| b.ops(count(A)));
    b.module(ModuleKind::Clear, 1, |b| b.ops(count(A)));
    b.module(ModuleKind::Halt, 0, |b| {
        b.ops(count(A + 2));
        b.op(sto(system::OUT_PORTS, Width::Byte));
    });
    b.module(ModuleKind::Main, 0, |b| b.ops(count(A + 4)));
    let mut bench = b.load().started();
    bench.command(Command::ClearPlc);
    bench.millis(1);
    assert_eq!((bench.word(A), bench.word(A + 4), bench.state()), (2, 0, PlcState::Running));
    bench.cycles(2);
    bench.command(Command::Halt);
    bench.command(Command::Halt);
    bench.millis(200);
    assert_eq!((bench.word(A + 2), bench.word(A + 4), bench.state()), (1, 2, PlcState::Halted));
    assert_eq!(bench.plc.outputs()[0], 1, "what MODULE_HALT wrote is driven");
    bench.command(Command::StartPlc { cold: false });
    bench.millis(1);
    assert_eq!(bench.state(), PlcState::Running);
}

#[test]
fn stopped_plc_executes_nothing() {
    let mut bench = Builder::new().main(|b| b.ops(count(A))).load();
    bench.millis(100);
    assert_eq!((bench.word(A), bench.plc.millis()), (0, 0));
    assert!(bench.events.is_empty());
}

#[test]
fn fault_stops_the_plc_until_the_next_start() {
    use technol_image::op::{Arith, Source};
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| b.ops(count(A)));
    b.module(ModuleKind::Main, 1, |b| {
        b.op(sto(system::OUT_PORTS, Width::Byte));
        b.op(Op::Arith { op: Arith::Div, src: Source::Mem(crate::support::cell(A + 4)), width: Width::Byte });
    });
    let mut bench = b.load().started();
    bench.plc.write_memory(A + 4, &[1]).expect("in memory");
    bench.cycles(3);
    bench.plc.write_memory(A + 4, &[0]).expect("in memory");
    assert_eq!(bench.tick(), TickOutcome::Stopped);
    let fault = *bench.plc.fault().expect("faulted");
    assert_eq!((fault.kind, fault.file, fault.cycle), (FaultKind::DivisionByZero, 1, 3));
    assert_eq!(fault.to_string(), "division by zero in MODULE_MAIN of file 2, operation 5, cycle 3");
    assert_eq!(bench.plc.outputs()[0], 0, "a faulted PLC drives nothing");
    for _ in 0..50 {
        assert_eq!(bench.tick(), TickOutcome::Stopped);
    }
    bench.plc.resume(technol_runtime::Resume::Continue);
    bench.millis(50);
    assert_eq!((bench.word(A), bench.state()), (4, PlcState::Faulted));
}

#[test]
fn registers_of_the_fast_module_are_its_own() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| b.ops([lod(1)]));
    b.module(ModuleKind::Fast, 0, |b| b.ops([lod(2)]));
    b.module(ModuleKind::Cont, 0, |b| b.ops([lod(3)]));
    let mut bench = b.load().started();
    bench.millis(5);
    assert_eq!(bench.plc.registers().dr, 1);
}
