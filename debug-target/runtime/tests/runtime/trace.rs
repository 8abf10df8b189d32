//! The register trace: what it shows is what stepping shows, and who is traced does not notice.

#![allow(clippy::single_range_in_vec_init, reason = "one range of lines is meant")]
use std::collections::BTreeMap;
use std::ops::Range;

use proptest::collection::vec;
use proptest::prelude::*;

use technol_image::op::{Arith, Cond, Op, Pc, Source, Width};
use technol_image::program::ModuleKind;
use technol_runtime::{Command, Registers, Resume, TickOutcome, TraceEntry, TraceValues};

use crate::fused::{an_item, started};
use crate::support::{Bench, Builder, GLOBAL as A, bit, count, la, ldr, lod, mem, sto};

/// What is shown of a line: RLO, DR, values on the equation stack; `None` when it did not run in this cycle.
fn ran(bench: &Bench) -> BTreeMap<Pc, Option<(bool, i64, u8)>> {
    let shown = |values: TraceValues| values.ran.then_some((values.rlo, values.dr, values.depth));
    bench.plc.trace().map(|entry| (entry.pc, entry.last.and_then(shown))).collect()
}

fn values(bench: &Bench, pc: Pc) -> Option<TraceValues> {
    bench.plc.trace().find(|entry| entry.pc == pc).expect("traced").last
}

/// MODULE_MAIN, operations 0 to 8: an equation, a jump over a count when A.3 is 0, and a comparison; all fused but
/// the increment. MODULE_FAST, operations 10 to 13, counts.
fn bench() -> Bench {
    let mut builder = Builder::new().main(|b| {
        let skip = b.label();
        b.ops([ldr(bit(A, 0)), la(bit(A, 1)), Op::Write(bit(A, 3))]);
        b.jump(skip, Cond::IfNotRlo);
        b.ops(count(A + 2));
        b.place(skip);
        b.ops([lod(7), Op::Arith { op: Arith::Add, src: mem(A + 2), width: Width::Word }]);
    });
    builder.module(ModuleKind::Fast, 0, |b| b.ops(count(A + 4)));
    builder.load().started()
}

#[test]
fn registers_behind_each_line_the_last_time_it_ran() {
    let mut bench = bench();
    assert_eq!((bench.plc.set_trace(&[0..9]), bench.plc.traced_lines()), (9, 9));
    assert!(bench.plc.trace().all(|entry| entry.last.is_none()), "not yet");
    bench.plc.write_memory(A, &[0b01]).expect("in memory");
    bench.cycles(1);
    let not = None;
    let shown: Vec<_> = ran(&bench).into_values().collect();
    let (on, off) = (Some((true, 0, 0)), Some((false, 0, 0)));
    assert_eq!(shown, [on, off, off, off, not, not, not, Some((false, 7, 0)), Some((false, 7, 0))]);
    bench.plc.write_memory(A, &[0b11]).expect("in memory");
    bench.cycles(1);
    let shown: Vec<_> = ran(&bench).into_values().collect();
    let (loaded, counted) = (Some((true, 0, 0)), Some((true, 1, 0)));
    let before = Some((true, 7, 0));
    assert_eq!(shown[..4], [before; 4], "DR from the last cycle");
    assert_eq!(shown[4..], [loaded, counted, counted, before, Some((true, 8, 0))]);
    // The count is not executed again; what it showed remains, with the cycle of that.
    bench.plc.write_memory(A, &[0b10]).expect("in memory");
    bench.cycles(1);
    let old = values(&bench, 5).expect("executed once");
    assert_eq!((old.ran, old.cycle, old.rlo, old.dr), (false, 1, true, 1));
    assert_eq!(values(&bench, 8).expect("executed").cycle, 2);
}

#[test]
fn the_fast_modules_are_traced_too() {
    let mut bench = bench();
    let first = bench.plc.program().modules[1].start;
    bench.plc.set_trace(&[first..first + 3]);
    bench.cycles(3);
    let shown: Vec<_> = ran(&bench).into_values().collect();
    assert_eq!(shown, [Some((false, 59, 0)), Some((false, 60, 0)), Some((false, 60, 0))]);
}

#[test]
fn a_trace_is_replaced_ended_and_forgotten_at_a_start() {
    let mut bench = bench();
    assert_eq!(bench.plc.set_trace(&[2..4, 3..5, 400..u32::MAX]), 3, "each line once");
    let lines = |bench: &Bench| bench.plc.trace().map(|entry| entry.pc).collect::<Vec<_>>();
    assert_eq!(lines(&bench), [2, 3, 4]);
    bench.cycles(1);
    assert!(values(&bench, 2).is_some());
    bench.command(Command::StartPlc { cold: true });
    bench.tick();
    assert_eq!(values(&bench, 2), None);
    assert_eq!((bench.plc.set_trace(&[]), lines(&bench).len()), (0, 0));
    assert_eq!(bench.plc.set_trace(&[5..5]), 0);
}

#[test]
fn real_register_of_lines_that_work_with_it() {
    let real = |op, value| Op::Arith { op, src: Source::Real(value), width: Width::Real };
    let load = Op::Load { src: Source::Real(1.5), width: Width::Real, neg: false };
    let mut bench =
        Builder::new().main(|b| b.ops([lod(1), load, real(Arith::Add, 1.0), lod(3)])).load().started();
    bench.plc.set_trace(&[0..4]);
    bench.cycles(1);
    let shown: Vec<_> = bench.plc.trace().map(|entry| entry.last.map(|v| (v.dr, v.dr_real))).collect();
    assert_eq!(shown, [Some((1, None)), Some((2, Some(1.5))), Some((2, Some(2.5))), Some((3, None))]);
}

#[test]
fn a_line_of_several_operations_shows_what_the_last_one_left() {
    let mut builder = Builder::new()
        .main(|b| b.ops([lod(1), ldr(bit(A, 0)), Op::Complement, lod(2), sto(A + 2, Width::Byte)]));
    builder.edit(|program| program.statements = vec![0, 1, 4]);
    let mut bench = builder.load().started();
    bench.plc.set_trace(&[0..9]);
    bench.cycles(1);
    let shown: Vec<_> = ran(&bench).into_iter().collect();
    assert_eq!(shown, [(0, Some((false, 1, 0))), (1, Some((true, 2, 0))), (4, Some((true, 2, 0)))]);
}

#[test]
fn what_ran_is_known_while_the_program_is_held() {
    let mut bench = bench();
    bench.plc.set_trace(&[0..20]);
    bench.cycles(1);
    bench.plc.set_breakpoints(&[1]);
    bench.run_to_stop(1);
    let running: Vec<_> = ran(&bench).into_iter().filter_map(|(pc, shown)| shown.map(|_| pc)).collect();
    assert_eq!(running, [0, 10, 11, 12, 13], "the fast module comes first");
}

/// The registers behind each operation that a cycle executes, seen by stepping.
fn stepped(bench: &mut Bench) -> BTreeMap<Pc, Registers> {
    let mut seen = BTreeMap::new();
    bench.plc.pause();
    let mut before = None;
    while bench.tick() == TickOutcome::Stopped && bench.plc.fault().is_none() {
        if let Some(pc) = before {
            seen.insert(pc, bench.plc.registers());
        }
        before = bench.plc.stopped().map(|stop| stop.pc);
        bench.plc.resume(Resume::StepInto);
    }
    seen
}

fn all(bench: &Bench) -> Vec<TraceEntry> {
    bench.plc.trace().collect()
}

/// As they are told apart: by bits, for NaN.
fn same(one: &[TraceEntry], other: &[TraceEntry]) -> bool {
    format!("{one:?}") == format!("{other:?}")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn traced_programs_do_the_same_and_show_what_stepping_shows(
        items in vec(an_item(), 1..90),
        memory in vec(any::<u8>(), 20),
        windows in vec((any::<prop::sample::Index>(), 1..12_u32), 1..3),
        places in vec(any::<prop::sample::Index>(), 0..3),
        whole in any::<bool>(),
    ) {
        let mut free = started(&items, &memory);
        let end = free.plc.program().modules[0].end;
        let within = |index: &prop::sample::Index| index.index(end as usize) as Pc;
        let mut lines: Vec<Range<Pc>> = windows.iter().map(|(at, len)| within(at)..within(at) + len).collect();
        if whole {
            lines.push(0..end);
        }
        let (mut traced, mut slow, mut steps) = (free.clone(), free.clone(), free.clone());
        slow.plc.set_line_by_line(true);
        let mut held = free.clone();
        for bench in [&mut traced, &mut slow, &mut held] {
            bench.plc.set_trace(&lines);
        }
        let pcs: Vec<Pc> = places.iter().map(within).collect();
        let _ = held.plc.set_breakpoints(&pcs);
        for cycle in 0..4 {
            for bench in [&mut free, &mut traced, &mut slow] {
                bench.tick();
            }
            while held.tick() == TickOutcome::Stopped && held.plc.fault().is_none() {
                held.plc.resume(Resume::Continue);
            }
            let seen = stepped(&mut steps);
            for bench in [&traced, &slow, &held, &steps] {
                prop_assert_eq!(free.plc.memory(), bench.plc.memory());
                prop_assert_eq!(free.plc.state_hash(), bench.plc.state_hash());
            }
            prop_assert!(same(&all(&traced), &all(&slow)), "{:?}\n{:?}", all(&traced), all(&slow));
            prop_assert!(same(&all(&traced), &all(&held)), "{:?}\n{:?}", all(&traced), all(&held));
            for entry in traced.plc.trace() {
                let values = entry.last.filter(|values| values.ran);
                // The last operation ends the module, so nothing can be seen behind it.
                if entry.pc + 1 < end {
                    let shown = values.map(|v| (v.rlo, v.dr, v.stack, v.depth));
                    let real = seen.get(&entry.pc).map(|r| (r.rlo, r.dr, r.stack, r.depth));
                    prop_assert_eq!(shown, real, "operation {} in cycle {}", entry.pc, cycle);
                }
            }
            if free.plc.fault().is_some() {
                break;
            }
            for bench in [&mut free, &mut traced, &mut slow, &mut held, &mut steps] {
                for _ in 0..19 {
                    bench.tick();
                }
            }
        }
    }
}
