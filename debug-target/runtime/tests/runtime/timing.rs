//! TM, CU, CD, CUBCD and DFTM rasters (manual 3.8; rulings 13 and 28).

use technol_image::op::{Count, Op, Raster, Source, Width};
use technol_image::program::ModuleKind;
use technol_runtime::{FaultKind, Registers};

use crate::operation::{check, check_fault, registers, with_dr, with_rlo};
use crate::support::{Builder, GLOBAL as A, HIDDEN, bit, cell, count, ldr, lod};

const BOTH: [Width; 2] = [Width::Byte, Width::Word];

fn tm(width: Width) -> Op {
    Op::Timer { count: cell(A), width }
}

#[test]
fn timer_is_reset_by_rlo_0_and_expires_after_dr_passes() {
    for width in BOTH {
        let dr = 0x7700 << 32 | 3;
        let before = |rlo| Registers { rlo, dr, ..registers() };
        check(&[tm(width)], before(false), &[(A, &[2, 0])], before(false), &[(A, &[0, 0])]);
        check(&[tm(width)], before(true), &[(A, &[0, 0])], before(false), &[(A, &[1, 0])]);
        check(&[tm(width)], before(true), &[(A, &[2, 0])], before(false), &[(A, &[3, 0])]);
        check(&[tm(width)], before(true), &[(A, &[3, 0])], before(true), &[]);
        check(&[tm(width)], before(true), &[(A, &[200, 0])], before(true), &[]);
    }
}

#[test]
fn timer_compares_unsigned_at_the_counter_width() {
    let before = Registers { rlo: true, dr: 0x1_00C8, ..registers() }; // 200 in eight bits
    let after = Registers { rlo: false, ..before };
    check(&[tm(Width::Byte)], before, &[(A, &[100])], after, &[(A, &[101])]);
    check(&[tm(Width::Byte)], before, &[(A, &[200])], before, &[]);
    let before = Registers { rlo: true, dr: -1, ..registers() };
    let after = Registers { rlo: false, ..before };
    check(&[tm(Width::Word)], before, &[(A, &[0xFE, 0xFF])], after, &[(A, &[0xFF, 0xFF])]);
    check(&[tm(Width::Word)], before, &[(A, &[0xFF, 0xFF])], before, &[]);
}

#[test]
fn timer_in_a_raster_counts_ticks_of_the_raster() {
    // Preset 2 in 0.1 s: true on the third tick while the condition holds without a break.
    let (condition, done) = (bit(A, 0), bit(A, 1));
    let mut bench = Builder::new()
        .main(|b| {
            let end = b.label();
            b.raster(Raster::Tenth, end);
            b.ops([lod(2), ldr(condition), Op::Timer { count: cell(A + 2), width: Width::Byte }]);
            b.op(Op::Write(done));
            b.place(end);
        })
        .load()
        .started();
    bench.set(condition, true);
    let mut expired_in = None;
    for cycle in 0..40 {
        bench.cycles(1);
        if bench.bit(done) && expired_in.is_none() {
            expired_in = Some(cycle);
        }
    }
    assert_eq!(expired_in, Some(15));
}

#[test]
fn counter_counts_on_the_rising_input_only() {
    for width in BOTH {
        let op = |op| Op::Counter { op, count: cell(A), width, state: HIDDEN };
        let before = |rlo| Registers { rlo, dr: 5, ..registers() };
        // (function, input, previous input, counter, counter after, equal to the preset 5)
        let rows = [
            (Count::Up, true, 0, 4, 5, true),
            (Count::Up, true, 1, 4, 4, false),
            (Count::Up, false, 1, 5, 5, true),
            (Count::Up, false, 0, 5, 5, true),
            (Count::Down, true, 0, 6, 5, true),
            (Count::Down, true, 1, 5, 5, true),
            (Count::Down, false, 0, 6, 6, false),
            (Count::UpBcd, true, 0, 4, 5, true),
            (Count::UpBcd, true, 0, 9, 0x10, false),
        ];
        for (function, input, previous, counter, counted, equal) in rows {
            let after = Registers { rlo: equal, dr: counted, ..registers() };
            let memory: &[(u32, &[u8])] = &[(A, &[counter, 0]), (HIDDEN, &[previous])];
            let state = [u8::from(input)];
            let cell = (counted as u16).to_le_bytes();
            let writes: &[(u32, &[u8])] = &[(A, &cell), (HIDDEN, &state)];
            check(&[op(function)], before(input), memory, after, writes);
        }
    }
}

#[test]
fn counter_wraps_and_leaves_its_content_sign_extended_in_dr() {
    let rows = [
        (Count::Up, Width::Byte, 0xFF, 0x00, 0),
        (Count::Up, Width::Byte, 0x7F, 0x80, -0x80),
        (Count::Up, Width::Word, 0xFFFF, 0x0000, 0),
        (Count::Up, Width::Word, 0x00FF, 0x0100, 0x100),
        (Count::Down, Width::Byte, 0x00, 0xFF, -1),
        (Count::Down, Width::Word, 0x0000, 0xFFFF, -1),
        (Count::UpBcd, Width::Byte, 0x99, 0x00, 0),
        (Count::UpBcd, Width::Word, 0x0099, 0x0100, 0x100),
        (Count::UpBcd, Width::Word, 0x9999, 0x0000, 0),
    ];
    for (op, width, before, after, dr) in rows {
        let op = Op::Counter { op, count: cell(A), width, state: HIDDEN };
        let (before, after) = (u16::to_le_bytes(before), u16::to_le_bytes(after));
        let registers = Registers { rlo: true, dr: 0x3333, ..registers() };
        let result = Registers { rlo: false, dr, ..registers };
        let len = width.bytes() as usize;
        check(&[op], registers, &[(A, &before[..len])], result, &[(A, &after[..len]), (HIDDEN, &[1])]);
    }
}

#[test]
fn bcd_counter_with_another_content_faults() {
    let op = |width| Op::Counter { op: Count::UpBcd, count: cell(A), width, state: HIDDEN };
    check_fault(&[op(Width::Byte)], with_rlo(true), &[(A, &[0x0A])], 0, FaultKind::BcdRange);
    check_fault(&[op(Width::Word)], with_dr(0), &[(A, &[0x00, 0xA0])], 0, FaultKind::BcdRange);
}

#[test]
fn first_pass_after_a_start_counts_a_closed_input() {
    let mut bench = Builder::new()
        .main(|b| {
            b.op(lod(0));
            b.op(Op::Load { src: Source::Int(1), width: Width::DWord, neg: false });
            b.op(ldr(bit(A, 0)));
            b.op(Op::Counter { op: Count::Up, count: cell(A + 2), width: Width::Word, state: HIDDEN });
        })
        .load()
        .started();
    bench.set(bit(A, 0), true);
    bench.cycles(3);
    assert_eq!(bench.word(A + 2), 1);
}

#[test]
fn rasters_tick_together_after_each_whole_interval() {
    let rates = [Raster::Tenth, Raster::Second, Raster::TenSeconds, Raster::HundredSeconds];
    let mut bench = Builder::new()
        .main(|b| {
            for (n, rate) in rates.into_iter().enumerate() {
                let end = b.label();
                b.raster(rate, end);
                b.ops(count(A + 2 * n as u32));
                b.place(end);
            }
        })
        .load()
        .started();
    let passes = |bench: &crate::support::Bench| [0, 2, 4, 6].map(|n| bench.word(A + n));
    bench.cycles(5);
    assert_eq!(passes(&bench), [0, 0, 0, 0], "cycles 0..=4 lie in the first 0.1 s");
    bench.cycles(1);
    assert_eq!(passes(&bench), [1, 0, 0, 0], "cycle 5 begins at 0.1 s");
    bench.cycles(45);
    assert_eq!(passes(&bench), [10, 1, 0, 0], "cycle 50 begins at 1 s");
    bench.cycles(450);
    assert_eq!(passes(&bench), [100, 10, 1, 0]);
    bench.cycles(4500);
    assert_eq!(passes(&bench), [1000, 100, 10, 1]);
}

#[test]
fn raster_in_the_fast_module_ticks_in_one_millisecond_only() {
    let mut b = Builder::new();
    b.module(ModuleKind::Fast, 0, |b| {
        let end = b.label();
        b.raster(Raster::Tenth, end);
        b.ops(count(A));
        b.place(end);
    });
    let mut bench = b.load().started();
    bench.millis(100);
    assert_eq!(bench.word(A), 0);
    bench.millis(1);
    assert_eq!(bench.word(A), 1);
    bench.millis(99);
    assert_eq!(bench.word(A), 1);
}
