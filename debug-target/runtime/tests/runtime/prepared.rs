//! The records of the prepared blocks, `BLK[n]` (manual 8.3).

use technol_image::op::{Op, Width};
use technol_image::program::ModuleKind;
use technol_image::system::{self, BLOCK_RECORD_COUNT, BLOCK_RECORDS, block_record as record};
use technol_runtime::{Block, BlockFlag, BlockFlags, BlockReal, Command, Prepared, Shared};

use crate::support::{Bench, Builder, GLOBAL as A, lod, mem, sto};

/// Executes BLK[BX].T with BX from A into A+4 in each cycle.
fn machine() -> Bench {
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |b| b.ops([]));
    b.block_module(ModuleKind::BlockDone, |b| b.ops([]));
    b.module(ModuleKind::Main, 0, |b| {
        b.ops([
            Op::Load { src: mem(A), width: Width::Word, neg: false },
            Op::IndexFromDr,
            lod(-1),
            Op::SelectBlock { offset: record::T as u16, len: 4 },
            Op::Load { src: mem(system::BLOCK_WINDOW), width: Width::DWord, neg: false },
            sto(A + 4, Width::DWord),
        ]);
    });
    b.load().started()
}

fn tool(t: u32) -> Block {
    Block { t: Some(t), motion_ms: 40, ..Block::default() }
}

fn dword(bench: &Bench, number: u32, offset: u32) -> u32 {
    let at = (BLOCK_RECORDS + number * record::LEN + offset) as usize;
    u32::from_le_bytes(bench.plc.memory()[at..at + 4].try_into().expect("in memory"))
}

fn real(bench: &Bench, number: u32, offset: u32) -> f64 {
    let at = (BLOCK_RECORDS + number * record::LEN + offset) as usize;
    f64::from_le_bytes(bench.plc.memory()[at..at + 8].try_into().expect("in memory"))
}

/// The eight bytes of bits, lowest first.
fn bits(bench: &Bench, number: u32) -> u64 {
    real(bench, number, 0).to_bits()
}

fn tools(bench: &Bench) -> Vec<u32> {
    (0..BLOCK_RECORD_COUNT).map(|n| dword(bench, n, record::T)).take_while(|t| *t != 0).collect()
}

#[test]
fn the_queue_is_seen_as_it_was_when_the_block_began() {
    let mut bench = machine();
    for t in 1..=3 {
        bench.command(Command::StartBlock(tool(t)));
    }
    bench.cycles(1);
    assert_eq!((tools(&bench), bench.word(system::CNT_NEXT_BLOCKS)), (vec![1, 2, 3], 2));
    bench.command(Command::StartBlock(tool(4)));
    bench.cycles(1);
    assert_eq!(
        (tools(&bench), bench.word(system::CNT_NEXT_BLOCKS)),
        (vec![1, 2, 3], 2),
        "not before the next"
    );
    bench.cycles(2);
    assert_eq!((tools(&bench), bench.word(system::CNT_NEXT_BLOCKS)), (vec![2, 3, 4], 2));
    bench.set(system::STOP_REQ, true);
    bench.cycles(1);
    assert_eq!((tools(&bench), bench.word(system::CNT_NEXT_BLOCKS)), (vec![2, 3, 4], 2), "a stop keeps them");
    bench.command(Command::AbortBlock);
    bench.cycles(1);
    assert_eq!((bits(&bench, 0), tools(&bench)), (0, vec![2]), "nothing is programmed any more");
}

#[test]
fn sixteen_blocks_can_wait() {
    let mut bench = machine();
    bench.command(Command::StartBlock(tool(100)));
    bench.cycles(1);
    for t in 101..=116 {
        bench.command(Command::StartBlock(tool(t)));
    }
    bench.cycles(3);
    assert_eq!(tools(&bench), (101..=116).collect::<Vec<_>>());
}

#[test]
fn bx_selects_the_block_and_reads_0_past_the_last() {
    let mut bench = machine();
    for t in [7, 8] {
        bench.command(Command::StartBlock(tool(t)));
    }
    for (bx, found) in [(0_u16, 7), (1, 8), (2, 0), (16, 0), (17, 0), (0xFFFF, 0)] {
        bench.plc.write_memory(A, &bx.to_le_bytes()).unwrap();
        bench.millis(1);
        // A movement of 40 ms would be over too soon.
        let mut at_once = bench.clone();
        at_once.cycles(1);
        assert_eq!(at_once.word(A + 4), found, "BLK[{bx}]");
    }
}

#[test]
fn what_a_block_does_not_program_is_that_of_the_block_before() {
    let mut prepared = Prepared {
        flags: BlockFlags::default().with(BlockFlag::First).with(BlockFlag::RevFeed).with(BlockFlag::Thread),
        integers: [None, Some(-5), None, None, None],
        reals: [Some(0.5), None, None, None, Some(-2.25)],
        ..Prepared::default()
    };
    prepared.axes[15] = Some(12.5);
    for (n, value) in BlockReal::ALL.into_iter().zip(1_u8..) {
        prepared.set(n, f64::from(value));
    }
    let full = Block {
        m: [0, 1, 3, 77].into(),
        t: Some(12_345_678),
        h: Some(42),
        motion_ms: 20,
        prepared: Some(Shared::new(prepared)),
        ..Block::default()
    };
    let mut bench = machine();
    bench.command(Command::StartBlock(full));
    bench.command(Command::StartBlock(Block { m: [4].into(), ..Block::default() }));
    bench.cycles(1);
    assert!(bench.bit(system::G33PI));
    let m_bits = |groups: &[u32]| groups.iter().map(|group| 1_u64 << group).sum::<u64>();
    let flags = |flags: &[u32]| flags.iter().map(|flag| 1_u64 << (45 + flag)).sum::<u64>();
    let changed = (1 << (16 + 15)) | (1 << (32 + 1)) | (1 << 40) | (1 << 44);
    assert_eq!(bits(&bench, 0), m_bits(&[1, 2, 14]) | changed | flags(&[0, 2, 3, 9, 10, 11]));
    assert_eq!(bits(&bench, 1), m_bits(&[2]));
    for (offset, first, second) in [
        (record::M + 4, 0x01, 0x01),
        (record::M + 8, 0x03, 0x04),
        (record::M + 56, 0x77, 0x77),
        (record::INTEGERS + 4, -5_i32 as u32, -5_i32 as u32),
        (record::T, 12_345_678, 12_345_678),
        (record::GEOMETRIC_AXES + 8, 2, 2),
    ] {
        assert_eq!((dword(&bench, 0, offset), dword(&bench, 1, offset)), (first, second), "{offset}");
    }
    let reals = [
        (record::H, 42.0, 42.0),
        (record::REALS, 0.5, 0.5),
        (record::REALS + 32, -2.25, -2.25),
        (record::AXES + 120, 12.5, 12.5),
        (record::DELAY, 1.0, 0.0),
        (record::BLOCK_LEN, 2.0, 0.0),
        (record::BLOCK_LEN + 8, 3.0, 1.0), // Scale
        (record::BLOCK_LEN + 16, 4.0, 4.0),
        (record::BLOCK_LEN + 72, 11.0, 11.0),
    ];
    for (offset, first, second) in reals {
        let found = [0, 1].map(|number| real(&bench, number, offset).to_bits());
        assert_eq!(found, [first, second].map(f64::to_bits), "{offset}");
    }
}

#[test]
fn a_block_that_goes_on_after_a_stop_starts_in_its_middle() {
    let mut bench = machine();
    bench.command(Command::StartBlock(tool(1)));
    bench.cycles(1);
    let partial = 1 << (45 + 8);
    bench.set(system::STOP_REQ, true);
    bench.cycles(1);
    assert_eq!(bits(&bench, 0) & partial, 0);
    bench.command(Command::ContinueBlock);
    bench.cycles(1);
    assert_eq!(bits(&bench, 0) & partial, partial);
}
