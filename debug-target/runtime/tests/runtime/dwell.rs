//! Dwell (G04) and continuous run (G23) of blocks (manual 8.1.21, 8.3.6, 8.4.4).

use technol_image::program::ModuleKind;
use technol_image::system;
use technol_runtime::{Block, BlockFlag, BlockFlags, BlockReal, Command, Prepared, Shared};

use crate::support::{Bench, Builder, GLOBAL as A, count};

/// Closing functions are counted.
fn machine() -> Bench {
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |_| ());
    b.block_module(ModuleKind::BlockDone, |b| b.ops(count(A)));
    b.load().started()
}

/// A block that moves for a time and dwells so many seconds behind it.
fn dwelling(motion_ms: u32, seconds: f64) -> Block {
    let mut prepared = Prepared::default();
    prepared.set(BlockReal::Delay, seconds);
    Block { motion_ms, prepared: Some(Shared::new(prepared)), ..Block::default() }
}

/// PO_F, PO_POL, SF_DELAYINPROGR, PRODLEVA and how often closing functions ran.
fn drawn(bench: &Bench) -> String {
    let bits = [system::PO_F, system::PO_POL, system::SF_DELAYINPROGR, system::PRODLEVA];
    let drawn: String =
        bits.iter().zip("FPDL".chars()).map(|(bit, c)| if bench.bit(*bit) { c } else { '_' }).collect();
    format!("{drawn}{}", bench.word(A))
}

fn each_cycle(bench: &mut Bench, cycles: u32) -> Vec<String> {
    let look = |_| {
        bench.cycles(1);
        drawn(bench)
    };
    (0..cycles).map(look).collect()
}

#[test]
fn a_dwell_runs_between_the_movement_and_the_closing_functions() {
    let mut bench = machine();
    bench.command(Command::StartBlock(dwelling(20, 0.06)));
    let seen = each_cycle(&mut bench, 6);
    assert_eq!(seen, ["F___0", "FPDL0", "FPDL0", "FPDL0", "_P__1", "_P__1"]);
}

#[test]
fn a_block_without_movement_may_dwell_and_no_time_is_none() {
    for (seconds, cycles) in [(0.02, 1), (0.03, 2), (0.0, 0), (-1.0, 0), (f64::NAN, 0), (0.000_4, 0)] {
        let mut bench = machine();
        bench.command(Command::StartBlock(dwelling(0, seconds)));
        let seen = each_cycle(&mut bench, 4);
        let dwelt = seen.iter().filter(|drawn| drawn.contains('D')).count();
        assert_eq!((dwelt, seen[3].as_str()), (cycles, "_P__1"), "{seconds}");
    }
}

#[test]
fn a_stop_holds_a_dwell_and_start_goes_on_with_it() {
    let mut bench = machine();
    bench.command(Command::StartBlock(dwelling(0, 0.06)));
    bench.cycles(2);
    bench.set(system::STOP_REQ, true);
    bench.cycles(1);
    assert_eq!(each_cycle(&mut bench, 10), ["FPDL0"; 10]);
    bench.command(Command::ContinueBlock);
    bench.cycles(1);
    assert_eq!((bench.byte(system::STATUS_RESTART), bench.bit(system::BLOCK_RESTART)), (3, true));
    assert_eq!(each_cycle(&mut bench, 1), ["_P__1"]);
}

#[test]
fn the_lamp_goes_out_when_a_dwell_is_broken_off_and_else_is_the_programs() {
    let mut bench = machine();
    bench.command(Command::StartBlock(dwelling(0, 5.0)));
    bench.cycles(2);
    bench.command(Command::AbortBlock);
    bench.cycles(1);
    assert_eq!(drawn(&bench), "_P__0");
    bench.set(system::PRODLEVA, true);
    bench.command(Command::StartBlock(dwelling(20, 0.0)));
    bench.cycles(3);
    assert!(bench.bit(system::PRODLEVA), "without a dwell nobody touches it");
}

/// A block of 40 ms in a continuous run.
fn smooth(m: &[u8]) -> Block {
    let flags = BlockFlags::default().with(BlockFlag::Continuous);
    let prepared = Some(Shared::new(Prepared { flags, ..Prepared::default() }));
    Block { m: m.into(), motion_ms: 40, prepared, ..Block::default() }
}

/// G23ACT and TIME_DIST after each cycle.
fn run(blocks: &[Block], cycles: u32) -> Vec<(bool, u32)> {
    let mut bench = machine();
    for block in blocks {
        bench.command(Command::StartBlock(block.clone()));
    }
    let look = |_| {
        bench.cycles(1);
        let at = system::TIME_DIST;
        let left = u32::from(bench.word(at)) | u32::from(bench.word(at + 2)) << 16;
        (bench.bit(system::G23ACT), left)
    };
    (0..cycles).map(look).collect()
}

#[test]
fn a_continuous_run_counts_down_to_its_end() {
    let three = [smooth(&[3]), smooth(&[]), smooth(&[])];
    let seen = run(&three, 11);
    assert_eq!(seen[0], (true, 120), "the functions of the first block do not matter");
    let run: Vec<u32> = seen.iter().take_while(|(active, _)| *active).map(|(_, left)| *left).collect();
    assert!(run.is_sorted_by(|a, b| a >= b), "{run:?}");
    assert!(!seen[10].0 && seen[10].1 == 0, "{seen:?}");
}

#[test]
fn what_does_not_run_on_ends_it() {
    let rapid = Block { rapid: true, ..smooth(&[]) };
    let still = Block { motion_ms: 0, ..smooth(&[]) };
    let plain = Block { motion_ms: 40, ..Block::default() };
    let tool = Block { t: Some(1), ..smooth(&[]) };
    for end in [rapid, still, plain, tool, smooth(&[8])] {
        let seen = run(&[smooth(&[]), smooth(&[]), end.clone(), smooth(&[])], 2);
        assert_eq!(seen[0], (true, 80), "{end:?}");
    }
    assert_eq!(run(&[Block { motion_ms: 40, ..Block::default() }], 1), [(false, 0)]);
}
