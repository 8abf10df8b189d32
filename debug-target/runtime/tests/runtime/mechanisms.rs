//! Mechanisms in virtual time: rulings 22 to 25 (manual chapter 4).

use technol_image::op::{Cond, Op, Source, Width};
use technol_image::program::ModuleKind;

use crate::support::{Bench, Builder, GLOBAL as A, bit, cell, count, ldr, lod, mem, set, sto};

const GO: technol_image::op::BitRef = bit(A, 0);
const FAILED: technol_image::op::BitRef = bit(A, 1);
const TIMER: u32 = A + 2;
/// Pass counters of up to four sections.
const SECTION: [u32; 4] = [A + 0x10, A + 0x12, A + 0x14, A + 0x16];

fn sections(bench: &Bench) -> [u16; 4] {
    SECTION.map(|addr| bench.word(addr))
}

#[test]
fn continuation_is_after_the_ex_type_instruction_passed_last() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.ops(count(SECTION[0]));
                b.ex();
                b.ops(count(SECTION[1]));
                b.op(ldr(GO));
                b.ex_if(false);
                b.ops(count(SECTION[2]));
                b.bex();
                b.ops(count(SECTION[3]));
                b.op(ldr(GO));
                b.ex_if(true);
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(1);
    assert_eq!(sections(&bench), [1, 0, 0, 0], "EX always waits one cycle");
    bench.cycles(3);
    assert_eq!(sections(&bench), [1, 3, 0, 0], "EX0 repeats what follows EX");
    assert_eq!(bench.sequence(0).resume, 1, "a waiting EX0 does not move the continuation");
    bench.set(GO, true);
    bench.cycles(2);
    assert_eq!(sections(&bench), [1, 4, 1, 2], "EX0 and BEX moved it when they passed");
    assert_eq!(bench.sequence(0).resume, 3);
    bench.set(GO, false);
    bench.cycles(1);
    assert_eq!(sections(&bench), [1, 4, 1, 3]);
    assert!(!bench.sequence(0).active);
}

#[test]
fn first_section_repeats_while_the_first_ex_type_instruction_waits() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.ops(count(SECTION[0]));
                b.op(ldr(GO));
                b.ex_if(false);
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(4);
    assert_eq!(sections(&bench)[0], 4);
}

#[test]
fn registers_survive_a_pass_that_does_not_wait() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let error = b.label();
                b.op(lod(-42));
                b.op(ldr(GO));
                b.ex_if(false);
                b.op(sto(A + 0x20, Width::QWord));
                b.op(Op::Write(bit(A + 1, 0)));
                b.bex();
                b.op(sto(A + 0x28, Width::QWord));
                b.op(Op::Write(bit(A + 1, 1)));
                b.tex(false, TIMER, Source::Int(5), error, Some(7));
                b.op(sto(A + 0x30, Width::QWord));
                b.op(Op::Write(bit(A + 1, 2)));
                b.place(error);
            });
        })
        .load()
        .started();
    bench.set(GO, true);
    bench.activate(0);
    bench.cycles(1);
    assert_eq!(bench.byte(A + 1), 0b111);
    for addr in [A + 0x20, A + 0x28, A + 0x30] {
        assert_eq!(bench.plc.memory()[addr as usize..][..8], (-42_i64).to_le_bytes());
    }
}

#[test]
fn waiting_leaves_the_sequence_with_an_empty_equation_stack() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.op(Op::Ldr { bit: GO, neg: false, push: true });
                b.op(Op::Ldr { bit: GO, neg: false, push: true });
                b.ex();
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(1);
    assert_eq!((bench.plc.registers().depth, bench.plc.registers().stack), (0, 0));
}

/// A mechanism that waits for GO with a limit and then sets FAILED, DR going to A+0x20.
fn supervised(limit: Source) -> Bench {
    Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let (error, end) = (b.label(), b.label());
                b.ex();
                b.ops(count(SECTION[0]));
                b.op(ldr(GO));
                b.tex(false, TIMER, limit, error, Some(-3));
                b.ops(count(SECTION[1]));
                b.jump(end, Cond::Always);
                b.place(error);
                b.op(set(FAILED, true));
                b.op(sto(A + 0x20, Width::QWord));
                b.place(end);
            });
        })
        .load()
        .started()
}

#[test]
fn tex_waits_its_time_and_then_jumps_in_the_same_pass() {
    for limit in [Source::Int(5), mem(A + 4)] {
        let mut bench = supervised(limit);
        bench.plc.write_memory(A + 4, &[5, 0]).expect("in memory");
        bench.activate(0);
        bench.cycles(1 + 5);
        assert!(!bench.bit(FAILED), "five passes wait");
        assert_eq!((sections(&bench)[0], bench.word(TIMER)), (5, 5));
        assert_eq!(bench.sequence(0).waiting, Some(2));
        bench.cycles(1);
        assert!(bench.bit(FAILED), "the sixth jumps");
        assert_eq!(bench.plc.memory()[A as usize + 0x20..][..8], (-3_i64).to_le_bytes());
        assert_eq!(bench.word(TIMER), 0, "timed out: the counter restarts");
        assert!(!bench.sequence(0).active, "the error branch ran on to the end");
        assert_eq!(sections(&bench)[1], 0);
    }
}

#[test]
fn tex_that_is_satisfied_passes_and_resets_its_counter() {
    let mut bench = supervised(Source::Int(5));
    bench.activate(0);
    bench.cycles(4);
    assert_eq!(bench.word(TIMER), 3);
    bench.set(GO, true);
    bench.cycles(1);
    assert_eq!((bench.word(TIMER), sections(&bench)[1], bench.bit(FAILED)), (0, 1, false));
}

#[test]
fn condition_wins_over_a_limit_reached_in_the_same_pass() {
    let mut bench = supervised(Source::Int(5));
    bench.activate(0);
    bench.cycles(1 + 5);
    bench.set(GO, true);
    bench.cycles(1);
    assert_eq!((sections(&bench)[1], bench.bit(FAILED)), (1, false));
}

#[test]
fn tex1_waits_while_rlo_is_1_and_time_zero_does_not_wait() {
    let run = |go: bool, time: i64| {
        let mut bench = Builder::new()
            .main(|b| {
                b.mechanism(|b| {
                    let error = b.label();
                    b.op(ldr(GO));
                    b.tex(true, TIMER, Source::Int(time), error, None);
                    b.op(set(bit(A, 2), true));
                    b.place(error);
                });
            })
            .load()
            .started();
        bench.set(GO, go);
        bench.activate(0);
        bench.cycles(1);
        (bench.bit(bit(A, 2)), bench.sequence(0).active)
    };
    assert_eq!(run(false, 3), (true, false), "passes");
    assert_eq!(run(true, 3), (false, true), "waits");
    assert_eq!(run(true, 0), (false, false), "jumps at once");
}

#[test]
fn tim_holds_for_its_time() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.tim(TIMER, Source::Int(10));
                b.op(set(GO, true));
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(10);
    assert!(!bench.bit(GO));
    bench.cycles(1);
    assert!(bench.bit(GO), "0.2 s after cycle 0");
}

#[test]
fn time_in_the_fast_module_is_counted_in_milliseconds() {
    let mut b = Builder::new();
    b.module(ModuleKind::Fast, 0, |b| {
        b.mechanism(|b| {
            b.tim(TIMER, Source::Int(7));
            b.op(set(GO, true));
        });
    });
    let mut bench = b.load().started();
    bench.activate(0);
    bench.millis(7);
    assert!(!bench.bit(GO));
    bench.millis(1);
    assert!(bench.bit(GO));
}

#[test]
fn counter_restarts_when_its_state_is_entered_anew() {
    // While OTHER is 1 the mechanism waits at an EX1 of its own instead of the TEX.
    let other = bit(A, 2);
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let (error, timed) = (b.label(), b.label());
                b.op(ldr(other));
                b.jump(timed, Cond::IfNotRlo);
                b.op(ldr(other));
                b.ex_if(true);
                b.place(timed);
                b.op(ldr(GO));
                b.tex(false, TIMER, Source::Int(5), error, None);
                b.place(error);
                b.op(set(FAILED, true));
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(4);
    assert_eq!(bench.word(TIMER), 4);
    bench.set(other, true);
    bench.cycles(1);
    assert_eq!(bench.sequence(0).waiting, Some(1));
    bench.set(other, false);
    bench.cycles(5);
    assert!(!bench.bit(FAILED), "five more passes, not one");
    bench.cycles(1);
    assert!(bench.bit(FAILED));
}

#[test]
fn counter_restarts_behind_another_ex_type_instruction_that_passes() {
    let other = bit(A, 2);
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let (error, timed) = (b.label(), b.label());
                b.op(ldr(other));
                b.jump(timed, Cond::IfNotRlo);
                b.bex();
                b.place(timed);
                b.op(ldr(GO));
                b.tex(false, TIMER, Source::Int(5), error, None);
                b.place(error);
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(4);
    assert_eq!(bench.word(TIMER), 4);
    bench.set(other, true);
    bench.cycles(1);
    assert_eq!(bench.word(TIMER), 1);
}

#[test]
fn counter_restarts_on_mech_init() {
    let mut bench = Builder::new()
        .main(|b| {
            let skip = b.label();
            b.op(ldr(bit(A, 3)));
            b.jump(skip, Cond::IfNotRlo);
            b.op(Op::SeqInit(0));
            b.op(set(bit(A, 3), false));
            b.place(skip);
            b.mechanism(|b| {
                b.tim(TIMER, Source::Int(5));
                b.op(set(GO, true));
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(4);
    bench.set(bit(A, 3), true);
    bench.cycles(1);
    assert!(!bench.sequence(0).active);
    bench.activate(0);
    bench.cycles(5);
    assert!(!bench.bit(GO));
    bench.cycles(1);
    assert!(bench.bit(GO));
}

#[test]
fn clearing_the_activation_bit_pauses_and_setting_it_goes_on() {
    let mut bench = supervised(Source::Int(5));
    bench.activate(0);
    bench.cycles(3);
    let before = bench.sequence(0);
    assert_eq!((before.resume, before.waiting, before.line, bench.word(TIMER)), (1, Some(2), 20, 2));
    bench.set(bench.activation(0), false);
    bench.cycles(10);
    let paused = bench.sequence(0);
    assert_eq!((paused.active, paused.resume, paused.line), (false, 1, 0), "no line while inactive");
    assert_eq!(bench.word(TIMER), 2);
    bench.activate(0);
    bench.cycles(1);
    assert_eq!((bench.sequence(0).line, bench.word(TIMER)), (20, 3), "where it was");
}

#[test]
fn mech_init_rewinds_from_outside() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.ops(count(SECTION[0]));
                b.ex();
                b.op(ldr(GO));
                b.ex_if(false);
            });
            let skip = b.label();
            b.op(ldr(FAILED));
            b.jump(skip, Cond::IfNotRlo);
            b.op(Op::SeqInit(0));
            b.place(skip);
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(3);
    bench.set(FAILED, true);
    bench.cycles(1);
    let rest = bench.sequence(0);
    assert_eq!((rest.active, rest.resume, rest.waiting, rest.line), (false, 0, None, 0));
    bench.set(FAILED, false);
    bench.activate(0);
    bench.cycles(1);
    assert_eq!(sections(&bench)[0], 2, "from the start again");
}

#[test]
fn mech_init_from_inside_runs_on_to_the_next_wait_and_stays_at_rest() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.ops(count(SECTION[0]));
                b.ex();
                b.op(Op::SeqInit(0));
                b.ops(count(SECTION[1]));
                b.bex();
                b.ops(count(SECTION[2]));
                b.ex();
                b.ops(count(SECTION[3]));
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(5);
    assert_eq!(sections(&bench), [1, 1, 1, 0]);
    let rest = bench.sequence(0);
    assert_eq!((rest.active, rest.resume, rest.waiting, rest.line), (false, 0, None, 0));
    bench.activate(0);
    bench.cycles(1);
    assert_eq!(sections(&bench)[0], 2, "restarts at its begin");
}

#[test]
fn reaching_the_end_clears_the_bit_rewinds_and_zeroes_the_line() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.ops(count(SECTION[0]));
                b.ex();
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(1);
    assert_eq!(bench.sequence(0).line, 10);
    bench.cycles(1);
    let end = bench.sequence(0);
    assert_eq!((end.active, end.resume, end.waiting, end.line), (false, 0, None, 0));
    bench.cycles(3);
    assert_eq!(sections(&bench)[0], 1, "not started again by itself");
}

#[test]
fn line_shows_the_state_and_how_long_it_lasts() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                b.op(ldr(GO));
                b.ex_if(false);
                b.op(ldr(FAILED));
                b.ex_if(false);
            });
        })
        .load()
        .started();
    bench.cycles(2);
    bench.activate(0);
    bench.cycles(1);
    assert_eq!((bench.sequence(0).line, bench.sequence(0).cycles_in_state), (10, 1));
    bench.cycles(4);
    assert_eq!((bench.sequence(0).line, bench.sequence(0).cycles_in_state), (10, 5));
    bench.set(GO, true);
    bench.cycles(1);
    assert_eq!((bench.sequence(0).line, bench.sequence(0).cycles_in_state), (20, 1));
}

#[test]
fn coming_back_to_a_state_is_a_new_stay_in_it() {
    let mut bench = Builder::new()
        .main(|b| {
            b.mechanism(|b| {
                let again = b.here();
                b.ex();
                b.op(Op::Jump { target: again, cond: Cond::Always });
            });
        })
        .load()
        .started();
    bench.activate(0);
    bench.cycles(6);
    assert_eq!((bench.sequence(0).line, bench.sequence(0).cycles_in_state), (10, 1));
}

#[test]
fn mechanisms_run_independently() {
    let mut bench = Builder::new()
        .main(|b| {
            for n in 0..4 {
                b.mechanism(|b| {
                    b.tim(TIMER + 2 * n, Source::Int(i64::from(n) + 1));
                    b.ops(count(SECTION[n as usize]));
                });
            }
        })
        .load()
        .started();
    for n in 0..4 {
        bench.activate(n);
    }
    bench.cycles(3);
    assert_eq!(sections(&bench), [1, 1, 0, 0]);
    bench.cycles(2);
    assert_eq!(sections(&bench), [1, 1, 1, 1]);
}

#[test]
fn byte_counter_with_a_longer_time_expires_at_its_end() {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| {
        b.mechanism(|b| {
            b.tim(TIMER, Source::Int(300));
            b.op(set(GO, true));
        });
    });
    b.edit(|program| {
        program.timed[0].width = Width::Byte;
        program.timed[0].count = cell(TIMER);
    });
    let mut bench = b.load().started();
    bench.activate(0);
    bench.cycles(255);
    assert!(!bench.bit(GO));
    bench.cycles(1);
    assert!(bench.bit(GO));
}
