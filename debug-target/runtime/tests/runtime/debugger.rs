//! Break-points, stepping, pausing and what is seen while the program is held.

use technol_image::op::{Cond, Op, Pc, Source, Width};
use technol_image::program::{Message, ModuleKind};
use technol_image::system;
use technol_runtime::{BreakpointError, Command, Frame, PlcState, Resume, Stop, StopReason, TickOutcome};

use crate::support::{Bench, Builder, GLOBAL as A, bit, count, la, ldr, lod, sto};

fn stop(bench: &Bench) -> Stop {
    bench.plc.stopped().expect("held")
}

/// Resumes and gives the place of the next stop.
fn go(bench: &mut Bench, how: Resume) -> Pc {
    bench.plc.resume(how);
    bench.run_to_stop(2_000);
    stop(bench).pc
}

fn step_over(bench: &mut Bench, sequence: Option<u16>) -> Pc {
    go(bench, Resume::StepOver { sequence })
}

/// MODULE_MAIN of eight operations, each a statement, from operation 0 on.
fn straight() -> Bench {
    Builder::new()
        .main(|b| {
            b.ops([lod(5), ldr(bit(A, 0)), la(bit(A, 1)), la(bit(A, 2)), Op::Write(bit(A, 3))]);
            b.ops(count(A + 2));
        })
        .load()
        .started()
}

#[test]
fn break_point_holds_before_its_statement() {
    let mut bench = straight();
    assert_eq!(bench.plc.set_breakpoints(&[1, 7]), [Ok(()), Ok(())]);
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).reason, stop(&bench).pc), (StopReason::Breakpoint, 1));
    assert_eq!((bench.plc.registers().dr, bench.word(A + 2)), (5, 0));
    assert_eq!((stop(&bench).module, stop(&bench).file, stop(&bench).sequence), (ModuleKind::Main, 0, None));
    assert_eq!(go(&mut bench, Resume::Continue), 7);
    assert_eq!((bench.plc.millis(), bench.word(A + 2)), (0, 0), "before the store");
    assert_eq!(go(&mut bench, Resume::Continue), 1, "in the next cycle");
    assert_eq!((bench.plc.cycle(), bench.word(A + 2)), (1, 1));
}

#[test]
fn break_point_inside_a_fused_equation_holds_there() {
    for pc in 1..=4 {
        let mut bench = straight();
        bench.plc.write_memory(A, &[0b0111]).expect("in memory");
        bench.plc.set_breakpoints(&[pc]);
        bench.run_to_stop(1);
        assert_eq!(stop(&bench).pc, pc);
        bench.plc.resume(Resume::Continue);
        bench.tick();
        assert_eq!(bench.byte(A), 0b1111);
        bench.plc.set_breakpoints(&[]);
        bench.millis(100);
        assert_eq!(bench.word(A + 2), 6);
    }
}

#[test]
fn break_points_are_refused_where_nothing_may_stop() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Nop]));
    b.module(ModuleKind::Fast, 0, |b| b.ops([Op::Nop]));
    b.module(ModuleKind::Cont, 0, |b| b.ops([Op::Nop]));
    b.edit(|program| program.statements.retain(|pc| *pc != 1));
    let mut bench = b.load();
    let results = bench.plc.set_breakpoints(&[0, 1, 2, 4, 99]);
    let errors = [
        Ok(()),
        Err(BreakpointError::NotAStatement),
        Err(BreakpointError::InFast),
        Err(BreakpointError::InCont),
        Err(BreakpointError::NotAStatement),
    ];
    assert_eq!(results, errors);
}

#[test]
fn procedure_called_from_the_fast_module_does_not_stop() {
    let mut b = Builder::new();
    b.procedure("SHARED", count(A));
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(0)]));
    b.module(ModuleKind::Fast, 0, |b| b.ops([Op::Call(0)]));
    let mut bench = b.load().started();
    let body = bench.plc.program().procedures[0].start;
    bench.plc.set_breakpoints(&[body]);
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).module, bench.word(A)), (ModuleKind::Main, 1));
}

#[test]
fn break_point_in_module_init_and_restart_while_held() {
    let mut b = Builder::new();
    b.module(ModuleKind::Init, 0, |b| b.ops(count(A)));
    b.module(ModuleKind::Main, 0, |b| b.ops(count(A + 2)));
    let mut bench = b.load();
    bench.plc.set_breakpoints(&[0]);
    bench.command(Command::StartPlc { cold: true });
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).pc, bench.state()), (0, PlcState::Starting));
    go(&mut bench, Resume::StepInto);
    bench.command(Command::StartPlc { cold: true });
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).pc, bench.word(A), bench.plc.registers().dr), (0, 0, 0));
    bench.plc.resume(Resume::Continue);
    bench.millis(21);
    assert_eq!((bench.word(A), bench.word(A + 2)), (1, 1));
}

#[test]
fn stop_at_entry_holds_at_the_first_statement() {
    let mut bench = Builder::new().main(|b| b.ops([Op::Nop])).load();
    bench.plc.stop_at_entry();
    bench.command(Command::StartPlc { cold: true });
    bench.run_to_stop(2);
    assert_eq!((stop(&bench).reason, stop(&bench).pc), (StopReason::Entry, 0));
}

#[test]
fn pause_holds_at_the_first_statement_of_the_next_cycle() {
    let mut bench = straight();
    bench.millis(5);
    bench.plc.pause();
    bench.run_to_stop(16);
    assert_eq!((stop(&bench).reason, stop(&bench).pc, bench.plc.cycle()), (StopReason::Pause, 0, 1));
    assert!(bench.plc.call_stack().len() == 1);
    bench.plc.resume(Resume::Continue);
    bench.millis(100);
}

#[test]
fn endless_loop_can_be_stepped() {
    let mut bench = Builder::new()
        .main(|b| {
            let again = b.label();
            b.place(again);
            b.ops(count(A));
            b.jump(again, Cond::Always);
        })
        .load()
        .started();
    bench.plc.set_breakpoints(&[3]);
    bench.run_to_stop(1);
    bench.plc.set_breakpoints(&[]);
    bench.plc.resume(Resume::StepInto);
    bench.run_to_stop(1);
    assert_eq!(stop(&bench).pc, 0);
}

#[test]
fn held_program_runs_only_module_cont() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| {
        b.op(lod(77));
        b.ops(count(A));
    });
    b.module(ModuleKind::Fast, 0, |b| b.ops(count(A + 2)));
    b.module(ModuleKind::Cont, 0, |b| {
        b.ops(count(A + 4));
        b.ops([ldr(bit(system::IN_PORTS, 0)), Op::Write(bit(system::OUT_PORTS, 0))]);
    });
    let mut bench = b.load().started();
    bench.plc.set_breakpoints(&[1]);
    bench.run_to_stop(1);
    bench.inputs[0] = 1;
    for _ in 0..100 {
        assert_eq!(bench.tick(), TickOutcome::Stopped);
    }
    assert_eq!((bench.word(A), bench.word(A + 2), bench.word(A + 4)), (0, 1, 5));
    assert_eq!(bench.plc.outputs()[0], 1, "MODULE_CONT sees and moves the ports");
    assert_eq!(bench.plc.registers().dr, 77, "with registers of its own");
    assert_eq!((bench.plc.millis(), stop(&bench).pc), (0, 1), "PLC time stands still");
}

#[test]
fn registers_and_memory_can_be_changed_while_held() {
    let mut bench = straight();
    bench.plc.set_breakpoints(&[4]);
    bench.run_to_stop(1);
    let mut registers = bench.plc.registers();
    registers.rlo = true;
    registers.depth = 200;
    bench.plc.set_registers(registers);
    assert_eq!(bench.plc.registers().depth, 8);
    bench.plc.write_memory(A + 2, &[41, 0]).expect("in memory");
    bench.plc.resume(Resume::Continue);
    bench.tick();
    assert_eq!((bench.byte(A), bench.word(A + 2)), (0b1000, 42));
}

#[test]
fn writes_outside_memory_are_refused() {
    let mut bench = straight();
    let end = bench.plc.memory().len() as u32;
    assert!(bench.plc.write_memory(end - 2, &[1, 2]).is_ok());
    assert!(bench.plc.write_memory(end - 1, &[1, 2]).is_err());
    assert!(bench.plc.write_memory(u32::MAX, &[1]).is_err());
    assert!(bench.plc.write_bit(end - 1, 7, true).is_ok());
    assert!(bench.plc.write_bit(end, 0, true).is_err());
    assert!(bench.plc.write_bit(0, 8, true).is_err());
}

#[test]
fn step_into_goes_to_the_next_statement_wherever_it_is() {
    let mut b = Builder::new();
    b.procedure("P", [Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(0), Op::Nop]));
    b.module(ModuleKind::Fast, 0, |b| b.ops([Op::Nop]));
    b.module(ModuleKind::Main, 1, |b| b.ops([Op::Nop]));
    let mut bench = b.load().started();
    bench.plc.pause();
    bench.run_to_stop(1);
    let mut places = vec![stop(&bench).pc];
    for _ in 0..7 {
        places.push(go(&mut bench, Resume::StepInto));
    }
    // Call, body, return, statement after it, module end, second file, its end, next cycle.
    assert_eq!(places, [0, 7, 8, 1, 2, 5, 6, 0]);
}

#[test]
fn step_over_runs_a_call_and_step_out_leaves_it() {
    let mut b = Builder::new();
    let inner = b.procedure("INNER", [Op::Nop, Op::Nop]);
    b.procedure("OUTER", [Op::Call(inner), Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(1), Op::Nop]));
    let mut bench = b.load().started();
    let (inner, outer) = (bench.plc.program().procedures[0].start, bench.plc.program().procedures[1].start);
    bench.plc.pause();
    bench.run_to_stop(1);
    assert_eq!(step_over(&mut bench.clone(), None), 1);
    assert_eq!(go(&mut bench, Resume::StepInto), outer);
    assert_eq!(step_over(&mut bench.clone(), None), outer + 1);
    assert_eq!(go(&mut bench, Resume::StepInto), inner);
    let frame = |pc, procedure| Frame { pc, procedure, sequence: None, module: ModuleKind::Main };
    assert_eq!(bench.plc.call_stack(), [frame(inner, Some(0)), frame(outer, Some(1)), frame(0, None)]);
    assert_eq!(go(&mut bench.clone(), Resume::StepOut), outer + 1);
    assert_eq!(step_over(&mut bench, None), inner + 1);
    assert_eq!(step_over(&mut bench, None), inner + 2, "the return of the procedure");
    assert_eq!(step_over(&mut bench, None), outer + 1, "a lower call depth");
    assert_eq!(go(&mut bench, Resume::StepOut), 1);
}

#[test]
fn break_point_stops_a_step_over() {
    let mut b = Builder::new();
    b.procedure("P", [Op::Nop, Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| b.ops([Op::Call(0), Op::Nop]));
    let mut bench = b.load().started();
    let body = bench.plc.program().procedures[0].start;
    bench.plc.set_breakpoints(&[0, body + 1]);
    bench.run_to_stop(1);
    assert_eq!(step_over(&mut bench, None), body + 1);
    assert_eq!(stop(&bench).reason, StopReason::Breakpoint);
}

/// A mechanism of `EX, count, LDR, EX0, count` between two NOPs.
fn mechanism() -> (Bench, Pc) {
    let mut start = 0;
    let mut bench = Builder::new()
        .main(|b| {
            b.op(Op::Nop);
            start = b.here();
            b.mechanism(|b| {
                b.ex();
                b.op(Op::Nop);
                b.op(ldr(bit(A, 0)));
                b.ex_if(false);
                b.op(Op::Nop);
            });
            b.op(Op::Nop);
        })
        .load()
        .started();
    bench.activate(0);
    (bench, start)
}

#[test]
fn step_over_in_a_sequence_waits_with_it() {
    let (mut bench, begin) = mechanism();
    let over = |bench: &mut Bench| step_over(bench, Some(0));
    bench.plc.set_breakpoints(&[begin + 1]);
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).sequence, bench.plc.cycle()), (Some(0), 0));
    bench.plc.set_breakpoints(&[]);
    // In the next cycle; MECH_BEGIN only continues there and is not shown again.
    assert_eq!((over(&mut bench), bench.plc.cycle()), (begin + 2, 1), "after EX");
    assert_eq!(over(&mut bench), begin + 3);
    assert_eq!(over(&mut bench), begin + 4);
    assert_eq!((over(&mut bench), bench.plc.cycle()), (begin + 2, 2), "EX0 waits");
    bench.set(bit(A, 0), true);
    let rest: Vec<Pc> = (0..5).map(|_| over(&mut bench)).collect();
    // The rest of the section, through EX0, to MECH_END, and out because the mechanism has ended.
    assert_eq!(rest, [begin + 3, begin + 4, begin + 5, begin + 6, begin + 7]);
    assert!(!bench.sequence(0).active);
}

#[test]
fn step_out_of_a_sequence_goes_behind_its_end_and_out_of_code_to_the_next_module() {
    let (mut bench, begin) = mechanism();
    bench.plc.set_breakpoints(&[begin + 1]);
    bench.run_to_stop(1);
    bench.plc.set_breakpoints(&[]);
    assert_eq!(go(&mut bench, Resume::StepOut), begin + 7);
    assert_eq!((go(&mut bench, Resume::StepOut), bench.plc.cycle()), (0, 1), "next module: next cycle");
}

#[test]
fn procedure_called_by_a_mechanism_counts_as_its_sequence() {
    let mut b = Builder::new();
    b.procedure("P", [Op::Nop, Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| {
        b.mechanism(|b| {
            b.op(Op::Call(0));
            b.ex();
        });
    });
    let mut bench = b.load().started();
    bench.activate(0);
    let body = bench.plc.program().procedures[0].start;
    bench.plc.set_breakpoints(&[body]);
    bench.run_to_stop(1);
    assert_eq!(stop(&bench).sequence, Some(0));
    assert_eq!(stop(&bench).call_stack.len(), 2);
    assert_eq!(stop(&bench).call_stack[0].sequence, Some(0));
    assert_eq!(step_over(&mut bench, Some(0)), body + 1);
}

#[test]
fn on_eset_appears_as_a_call_from_its_message() {
    let mut b = Builder::new();
    b.procedure("_ON_ESET", [Op::Nop]);
    b.module(ModuleKind::Main, 0, |b| {
        let number = Some((Source::Int(3), Width::DWord));
        b.message(Message { number, sub_id: None, set: true, parameters: [None; 3] }, Cond::Always);
    });
    let mut bench = b.load().started();
    let body = bench.plc.program().procedures[0].start;
    bench.plc.set_breakpoints(&[body]);
    bench.run_to_stop(1);
    assert_eq!(stop(&bench).call_stack.iter().map(|f| f.pc).collect::<Vec<_>>(), [body, 0]);
    assert_eq!(bench.plc.registers().dr, 3);
}

#[test]
fn fault_shows_its_place_and_registers() {
    let mut bench = Builder::new()
        .main(|b| {
            b.op(lod(10_000));
            b.op(Op::BinToBcd(Width::Word));
        })
        .load()
        .started();
    bench.run_to_stop(1);
    assert_eq!((stop(&bench).reason, stop(&bench).pc), (StopReason::Fault, 1));
    assert_eq!(bench.plc.registers().dr, 10_000);
}

#[test]
fn snapshot_goes_on_as_the_original_would() {
    let mut bench = straight();
    bench.millis(33);
    let mut copy = bench.clone();
    bench.millis(50);
    assert_ne!(copy.plc.state_hash(), bench.plc.state_hash());
    copy.millis(50);
    assert_eq!(copy.plc.state_hash(), bench.plc.state_hash());
}

#[test]
fn break_points_survive_a_restart_and_are_replaced_as_a_set() {
    let mut bench = straight();
    bench.plc.set_breakpoints(&[2, 6]);
    bench.run_to_stop(1);
    bench.command(Command::StartPlc { cold: true });
    bench.tick();
    bench.run_to_stop(1);
    assert_eq!(stop(&bench).pc, 2);
    bench.plc.set_breakpoints(&[6]);
    assert_eq!(go(&mut bench, Resume::Continue), 6);
    assert_eq!(go(&mut bench, Resume::Continue), 6);
    assert_eq!(bench.plc.cycle(), 1);
}

#[test]
fn store_of_a_step_is_seen_at_the_next_statement() {
    let mut bench = Builder::new().main(|b| b.ops([lod(1), sto(A, Width::Byte), Op::Nop])).load().started();
    bench.plc.set_breakpoints(&[1]);
    bench.run_to_stop(1);
    assert_eq!(bench.byte(A), 0);
    assert_eq!(go(&mut bench, Resume::StepInto), 2);
    assert_eq!(bench.byte(A), 1);
}
