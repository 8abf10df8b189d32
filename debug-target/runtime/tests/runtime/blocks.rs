//! The block cycle: functions, BLOCK_INIT, movement, BLOCK_DONE, stops (manual 5.2, 8.1, 8.2).

use technol_image::op::{Arith, BitRef, Cond, Op, Source, Width};
use technol_image::program::ModuleKind;
use technol_image::system::{self, PB00};
use technol_runtime::{
    Block, BlockFlag, BlockFlags, BlockMode, Command, Prepared, Rejection, RuntimeEvent, Shared,
};

use crate::support::{Bench, Builder, GLOBAL as A, bit, cell, count, indexed, ldr, mem, set, sto};

const READY: BitRef = bit(A, 0);
const STOP: BitRef = system::STOPPI;

/// BLOCK_INIT waits for READY when M10 is programmed; BLOCK_DONE never waits. Passes are counted.
fn machine() -> Bench {
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |b| {
        let through = b.label();
        b.ops(count(A + 2));
        b.op(ldr(system::M10PID));
        b.jump(through, Cond::IfNotRlo);
        b.bex();
        b.op(ldr(READY));
        b.ex_if(false);
        b.place(through);
    });
    b.block_module(ModuleKind::BlockDone, |b| b.ops(count(A + 4)));
    b.module(ModuleKind::Main, 0, |b| b.ops(count(A + 6)));
    // The two last codes are at A+8 and, before it, at A+16.
    let remember = Op::Move { dst: cell(A + 16), src: cell(A + 8), width: Width::DWord, cond: Cond::Always };
    let handler = [remember, sto(A + 8, Width::DWord)];
    b.procedure("_ON_EVENT", handler.into_iter().chain(count(A + 12)));
    b.load().started()
}

fn block(m: &[u8], motion_ms: u32) -> Block {
    Block { m: m.into(), motion_ms, ..Block::default() }
}

fn block_events(bench: &Bench) -> Vec<(&'static str, u64)> {
    bench
        .events
        .iter()
        .filter_map(|event| match event {
            RuntimeEvent::BlockStarted { cycle } => Some(("started", *cycle)),
            RuntimeEvent::BlockFinished { cycle } => Some(("finished", *cycle)),
            RuntimeEvent::BlockAborted { cycle } => Some(("aborted", *cycle)),
            _ => None,
        })
        .collect()
}

#[test]
fn block_without_movement_passes_both_modules_in_one_cycle() {
    let mut bench = machine();
    bench.cycles(2);
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(1);
    assert_eq!(block_events(&bench), [("started", 2), ("finished", 2)]);
    assert_eq!((bench.word(A + 2), bench.word(A + 4), bench.word(A + 6)), (1, 1, 3));
    assert!(!bench.bit(system::PO_F) && bench.bit(system::PO_POL) && bench.bit(system::INPOS));
}

#[test]
fn preparation_then_movement_then_closing() {
    let mut bench = machine();
    bench.command(Command::StartBlock(block(&[10], 400)));
    bench.cycles(3);
    assert_eq!((bench.word(A + 2), bench.bit(system::PO_F)), (1, true), "waits for READY after its BEX");
    assert!(bench.bit(system::M10PID));
    bench.set(READY, true);
    bench.cycles(1);
    assert!(!bench.bit(system::INPOS) && !bench.bit(system::PO_POL), "moves");
    bench.cycles(19);
    assert_eq!(bench.word(A + 4), 0);
    bench.cycles(1);
    assert_eq!(bench.word(A + 4), 1);
    assert_eq!(block_events(&bench), [("started", 0), ("finished", 23)]);
    assert!(bench.bit(system::PO_POL) && !bench.bit(system::M10PID) && !bench.bit(system::PO_F));
    assert_eq!(bench.word(A + 6), 24, "MODULE_MAIN runs in every cycle");
}

#[test]
fn queued_blocks_follow_one_per_cycle() {
    let mut bench = machine();
    for _ in 0..16 {
        bench.command(Command::StartBlock(block(&[], 0)));
    }
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.millis(1);
    assert_eq!(bench.word(system::CNT_NEXT_BLOCKS), 15);
    assert!(bench.events.contains(&RuntimeEvent::BlockRejected(Rejection::QueueFull)));
    bench.cycles(20);
    assert_eq!(block_events(&bench).len(), 32);
    assert_eq!(block_events(&bench)[31], ("finished", 15));
}

#[test]
fn block_is_rejected_when_stopped_or_out_of_range() {
    let mut bench = machine();
    for bad in [
        block(&[100], 0),
        Block { h: Some(100), ..Block::default() },
        Block { t: Some(100_000_000), ..Block::default() },
        Block { s: Some(0x8000), ..Block::default() },
    ] {
        bench.events.clear();
        bench.command(Command::StartBlock(bad));
        bench.millis(1);
        assert_eq!(bench.events, [RuntimeEvent::BlockRejected(Rejection::OutOfRange)]);
    }
    bench.command(Command::StopPlc { power_off: false });
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.millis(2);
    assert!(bench.events.contains(&RuntimeEvent::BlockRejected(Rejection::NotRunning)));
}

/// Cells after a block with these M functions is taken over and waits in preparation.
fn taken_over(m: &[u8]) -> Bench {
    let mut bench = machine();
    let m: Vec<u8> = m.iter().copied().chain([10]).collect();
    bench.command(Command::StartBlock(block(&m, 0)));
    bench.cycles(1);
    bench
}

fn change_bits(bench: &Bench) -> Vec<u8> {
    let word = bench.word(system::ZMM1PI.addr) & 0x3FFF;
    (1..=14).filter(|group| word >> (group - 1) & 1 != 0).collect()
}

#[test]
fn m_functions_set_the_cells_of_their_group() {
    let spindle = [system::M03PI, system::M04PI, system::M19PI];
    for (m, code, bits) in [
        (3, 0x03, [true, false, false]),
        (4, 0x04, [false, true, false]),
        (5, 0x05, [false, false, false]),
        (19, 0x19, [false, false, true]),
    ] {
        let bench = taken_over(&[4, m]);
        assert_eq!(bench.byte(PB00 + 6), code);
        assert_eq!(spindle.map(|bit| bench.bit(bit)), bits, "M{m:02}");
        assert_eq!(change_bits(&bench), [2, 7]);
    }
    for (m, coolant) in [(7, [true, false]), (8, [false, true]), (9, [false, false]), (17, [true, true])] {
        let bench = taken_over(&[17, m]);
        assert_eq!([system::M07PI, system::M08PI].map(|bit| bench.bit(bit)), coolant, "M{m:02}");
        assert_eq!(change_bits(&bench), [5, 7]);
    }
    for (m, coolant) in [(50, [true, false]), (51, [false, true]), (52, [true, true]), (53, [false, false])] {
        let bench = taken_over(&[52, m]);
        assert_eq!([system::M50PI, system::M51PI].map(|bit| bench.bit(bit)), coolant, "M{m:02}");
        assert_eq!(change_bits(&bench), [6, 7]);
    }
    for gear in 0..4 {
        let bench = taken_over(&[42, 41 + gear]);
        let gears = bench.byte(system::M41PI.addr) >> system::M41PI.bit & 0xF;
        assert_eq!(gears, 1 << gear);
        assert_eq!(change_bits(&bench), [3, 7]);
    }
    let one_block = [
        (0, system::M00_PID, 1),
        (1, system::M01_PID, 1),
        (2, system::M02_PID, 1),
        (30, system::M30_PID, 1),
        (11, system::M11PID, 7),
        (6, system::M06PID, 9),
        (60, system::M60PI, 9),
    ];
    for (m, flag, group) in one_block {
        let bench = taken_over(&[m]);
        assert!(bench.bit(flag), "M{m:02}");
        assert!(change_bits(&bench).contains(&group));
    }
    let bench = taken_over(&[77]);
    assert_eq!((bench.byte(PB00 + 16), change_bits(&bench)), (0x77, vec![7, 14]));
}

#[test]
fn static_bits_stay_and_one_block_bits_go_with_the_block() {
    let mut bench = taken_over(&[3, 8, 30]);
    bench.set(READY, true);
    bench.cycles(1);
    assert!(bench.bit(system::M03PI) && bench.bit(system::M08PI));
    assert!(!bench.bit(system::M30_PID) && !bench.bit(system::M10PID));
    assert!(change_bits(&bench).is_empty());
}

#[test]
fn numbers_and_mode_are_in_their_cells() {
    let mut bench = machine();
    bench.command(Command::StartBlock(Block {
        m: [10].into(),
        t: Some(12_345_678),
        s: Some(0x7FFF),
        h: Some(42),
        motion_ms: 0,
        rapid: true,
        mode: BlockMode::Reference,
        prepared: None,
    }));
    bench.cycles(1);
    let cells = [7, 8, 9, 10].map(|n| bench.byte(PB00 + n));
    assert_eq!(cells, [0x78, 0x56, 0x34, 0x12]);
    assert_eq!((bench.word(PB00 + 11), bench.byte(PB00 + 5)), (0x7FFF, 0x42));
    for bit in [system::ZMSTPI, system::ZMSHPI, system::ZMSSPI, system::G00PI] {
        assert!(bench.bit(bit), "{bit:?}");
    }
    let modes = [system::AUTPI, system::CAPI, system::REFPI].map(|flag| bench.bit(flag));
    assert_eq!(modes, [false, false, true]);
}

#[test]
fn start_waits_while_the_plc_forbids_it() {
    let mut bench = machine();
    bench.set(system::START_DISABLE, true);
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(3);
    assert!(block_events(&bench).is_empty());
    bench.set(system::START_DISABLE, false);
    bench.cycles(1);
    assert_eq!(block_events(&bench).len(), 2);
}

/// `_ON_EVENT` suspends every start, and remembers the codes it was called with at A, A+2 … (A+16: how many bytes).
fn suspends() -> Bench {
    use technol_image::op::Compare;
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |b| b.ops([]));
    b.block_module(ModuleKind::BlockDone, |b| b.ops([]));
    b.module(ModuleKind::Main, 0, |b| b.ops([]));
    let load = |addr| Op::Load { src: mem(addr), width: Width::Word, neg: false };
    let add = Op::Arith { op: Arith::Add, src: Source::Int(2), width: Width::Word };
    b.procedure(
        "_ON_EVENT",
        [
            sto(A + 18, Width::Word),
            Op::Compare { op: Compare::Eq, src: Source::Int(5), width: Width::DWord, if_rlo: false },
            Op::Flag { value: true, bit: system::START_SUSPEND, cond: Cond::IfRlo },
            load(A + 16),
            Op::IndexFromDr,
            add,
            sto(A + 16, Width::Word),
            load(A + 18),
            Op::Store { dst: indexed(A), width: Width::Word, cond: Cond::Always },
        ],
    );
    b.load().started()
}

fn codes(bench: &Bench) -> Vec<u16> {
    (0..u32::from(bench.word(A + 16)) / 2).map(|n| bench.word(A + 2 * n)).collect()
}

#[test]
fn a_start_asks_first_and_goes_on_when_the_plc_lets_it() {
    let mut bench = suspends();
    bench.set(system::START_SUSPEND, true); // preset to 0 when a start begins
    bench.command(Command::StartBlock(block(&[], 60)));
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(3);
    assert_eq!((codes(&bench), block_events(&bench)), (vec![5], vec![]));
    bench.set(system::START_SUSPEND, false);
    bench.cycles(2);
    assert_eq!((codes(&bench), block_events(&bench)), (vec![5, 4], vec![("started", 3)]));
    bench.cycles(3);
    assert_eq!(codes(&bench), [5, 4], "the next block of a program is no start");
    assert_eq!(block_events(&bench)[1..], [("finished", 6), ("started", 7), ("finished", 7)]);
}

#[test]
fn a_stopped_block_goes_on_by_a_start_of_its_own() {
    let mut bench = suspends();
    bench.command(Command::StartBlock(block(&[], 100)));
    bench.cycles(1);
    bench.set(system::START_SUSPEND, false);
    bench.cycles(1);
    bench.set(system::STOP_REQ, true);
    bench.cycles(2);
    bench.command(Command::ContinueBlock);
    bench.cycles(5);
    assert_eq!(codes(&bench), [5, 4, 1, 3, 5], "suspended again");
    assert!(bench.bit(system::PO_STOP) && !bench.bit(system::BLOCK_RESTART));
    bench.set(system::START_SUSPEND, false);
    bench.cycles(2);
    assert!(!bench.bit(system::PO_STOP) && bench.bit(system::BLOCK_RESTART));
    assert_eq!(codes(&bench), [5, 4, 1, 3, 5, 4]);
}

#[test]
fn a_programmed_stop_holds_the_blocks_behind_it_until_the_next_start() {
    for (m, conditional, stops) in [(0, false, true), (1, false, false), (1, true, true)] {
        let mut bench = machine();
        bench.plc.set_conditional_stop(conditional);
        bench.command(Command::StartBlock(block(&[m], 0)));
        bench.command(Command::StartBlock(block(&[], 0)));
        bench.cycles(5);
        assert_eq!(bench.bit(system::PO_STOP), stops, "M{m:02}");
        assert_eq!(block_events(&bench).len(), if stops { 2 } else { 4 }, "M{m:02}");
        bench.command(Command::ContinueBlock);
        bench.cycles(2);
        assert_eq!(block_events(&bench).len(), 4, "M{m:02}");
        assert!(!bench.bit(system::PO_STOP));
    }
}

/// RUN, BLOCKINPROGR, BLOCKFINISHED, STOP, NOTINPOS, CONDSTOPMODE, BACKWARD as a drawing.
fn status(bench: &Bench) -> String {
    let bits = [
        system::SF_RUN,
        system::SF_BLOCKINPROGR,
        system::SF_BLOCKFINISHED,
        system::SF_STOP,
        system::SF_NOTINPOS,
        system::SF_CONDSTOPMODE,
        system::SF_BACKWARD,
    ];
    bits.iter().zip("RBFSNCK".chars()).map(|(bit, sign)| if bench.bit(*bit) { sign } else { '_' }).collect()
}

#[test]
fn the_status_follows_the_block() {
    let mut bench = machine();
    bench.cycles(1);
    let idle = status(&bench);
    let flags = BlockFlags::default().with(BlockFlag::Backward);
    let prepared = Some(Shared::new(Prepared { flags, ..Prepared::default() }));
    bench.plc.set_conditional_stop(true);
    bench.command(Command::StartBlock(Block { m: [1].into(), motion_ms: 60, prepared, ..Block::default() }));
    bench.command(Command::StartBlock(block(&[], 0)));
    let mut seen = vec![idle];
    for cycle in 0..9 {
        match cycle {
            1 => bench.set(system::STOP_REQ, true),
            3 => bench.command(Command::ContinueBlock),
            _ => {}
        }
        bench.cycles(1);
        seen.push(status(&bench));
    }
    let expected = [
        "_______", "RB__NCK", "RB__NCK", // the request is taken at the end of the cycle
        "_B_S_CK", "RB__NCK", "RB__NCK", "__FS_C_", // M01 stops behind the block
        "__FS_C_", "__FS_C_", "__FS_C_",
    ];
    assert_eq!(seen, expected);
}

#[test]
fn groups_of_the_configuration_have_their_cells_and_bits() {
    let mut bench = machine();
    bench.plc.set_m_groups(&[(91, 10), (92, 11), (93, 12), (94, 13), (95, 4), (96, 2), (6, 9)]).unwrap();
    bench.command(Command::StartBlock(block(&[3, 10], 0)));
    bench.cycles(1);
    assert!(bench.bit(system::M03PI));
    bench.set(READY, true);
    bench.cycles(1);
    bench.set(READY, false);
    bench.command(Command::StartBlock(block(&[91, 92, 93, 94, 95, 96, 97, 10], 0)));
    bench.cycles(1);
    let cells = [3, 13, 14, 15, 6, 16].map(|n| bench.byte(PB00 + n));
    assert_eq!(cells, [0x91, 0x92, 0x93, 0x94, 0x96, 0x97]);
    assert_eq!(change_bits(&bench), [2, 4, 7, 10, 11, 12, 13, 14]);
    assert!(!bench.bit(system::M03PI), "another function of the group");
    let error = |groups: &[(u8, u8)]| machine().plc.set_m_groups(groups).unwrap_err().to_string();
    assert_eq!(error(&[(90, 10), (3, 4)]), "M03 belongs to group 2 and cannot be moved");
    assert_eq!(error(&[(90, 15)]), "there is no group 15; M functions have groups 1 to 14");
    assert_eq!(error(&[(100, 14)]), "there is no M100; M functions go from 0 to 99");
}

#[test]
fn stop_request_holds_the_movement_until_the_next_start() {
    for (request, code, stays) in
        [(STOP, 1, true), (system::STOP_REQ, 1, false), (system::STOP_EMERGENCY_REQ, 2, false)]
    {
        let mut bench = machine();
        bench.command(Command::StartBlock(block(&[], 100)));
        bench.command(Command::StartBlock(block(&[], 0)));
        bench.cycles(2);
        bench.set(request, true);
        bench.cycles(1);
        assert!(bench.bit(system::PO_STOP) && bench.bit(system::PO_F) && bench.bit(system::INPOS));
        assert_eq!(bench.bit(request), stays, "an acknowledged request is cleared");
        bench.cycles(50);
        assert_eq!(block_events(&bench), [("started", 0)]);
        let codes = [bench.word(A + 16), bench.word(A + 8)];
        assert_eq!((bench.word(A + 12), codes), (4, [code, 3]), "start, the request, then STOP");
        bench.command(Command::ContinueBlock);
        bench.cycles(1);
        assert!(!bench.bit(system::PO_STOP) && bench.bit(system::BLOCK_RESTART));
        assert_eq!(bench.byte(system::STATUS_RESTART), 2);
        bench.cycles(5);
        assert_eq!(block_events(&bench).len(), 4, "the queued block follows");
        assert!(bench.bit(system::PO_POL) && !bench.bit(system::BLOCK_RESTART));
    }
}

#[test]
fn a_stop_in_the_closing_functions_holds_the_blocks_behind() {
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |b| b.ops([]));
    b.block_module(ModuleKind::BlockDone, |b| b.tim(A + 2, Source::Int(3)));
    b.module(ModuleKind::Main, 0, |b| b.ops([]));
    let mut bench = b.load().started();
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(1);
    bench.set(system::STOP_REQ, true);
    bench.cycles(20);
    assert_eq!(block_events(&bench), [("started", 0), ("finished", 3)]);
    assert!(bench.bit(system::PO_STOP) && !bench.bit(system::PO_F));
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(5);
    assert_eq!(block_events(&bench).len(), 2, "more of the program is no start");
    bench.command(Command::ContinueBlock);
    bench.cycles(1);
    assert!(!bench.bit(system::PO_STOP));
    bench.set(system::STOP_REQ, true);
    bench.cycles(1);
    bench.command(Command::ContinueBlock);
    bench.cycles(1);
    assert_eq!(bench.byte(system::STATUS_RESTART), 4, "BLOCK_DONE");
    bench.cycles(20);
    assert_eq!(block_events(&bench).len(), 6);
}

#[test]
fn the_end_of_the_part_program_is_the_end_of_its_blocks() {
    let first = || {
        Some(Shared::new(Prepared {
            flags: BlockFlags::default().with(BlockFlag::First),
            ..Prepared::default()
        }))
    };
    for end in [2, 30] {
        let mut bench = machine();
        bench.set(READY, true);
        bench.command(Command::StartBlock(block(&[end], 40)));
        bench.command(Command::StartBlock(block(&[10], 0)));
        bench.cycles(10);
        assert_eq!(block_events(&bench).len(), 2, "M{end:02}");
        assert_eq!(bench.word(system::CNT_NEXT_BLOCKS), 0);
        assert!(!bench.bit(system::PO_STOP) && !bench.bit(system::PO_F), "it is no stop");
        // A program that waits behind it begins.
        bench.command(Command::StartBlock(block(&[end], 40)));
        bench.command(Command::StartBlock(block(&[10], 0)));
        bench.command(Command::StartBlock(Block { prepared: first(), ..block(&[], 0) }));
        bench.cycles(10);
        assert_eq!(block_events(&bench).len(), 6, "M{end:02}");
    }
}

#[test]
fn stop_level_that_stays_1_stops_only_once() {
    let mut bench = machine();
    bench.set(STOP, true);
    bench.cycles(1);
    assert!(!bench.bit(system::PO_STOP), "nothing was running");
    bench.command(Command::StartBlock(block(&[], 40)));
    bench.cycles(3);
    assert_eq!(block_events(&bench).len(), 2);
}

#[test]
fn central_annulment_breaks_the_block_and_rewinds() {
    let mut bench = taken_over(&[]);
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(1);
    bench.command(Command::AbortBlock);
    bench.cycles(1);
    assert_eq!(block_events(&bench), [("started", 0), ("aborted", 2)]);
    let init = bench.sequence(0);
    assert_eq!((init.active, init.resume, init.waiting), (false, 0, None));
    assert!(bench.bit(system::CAPI) && !bench.bit(system::PO_F) && !bench.bit(system::M10PID));
    bench.command(Command::StartBlock(block(&[10], 0)));
    bench.cycles(1);
    assert_eq!(bench.word(A + 2), 2, "BLOCK_INIT begins at its start");
    assert!(!bench.bit(system::CAPI));
}

#[test]
fn stopping_the_plc_breaks_the_block() {
    let mut bench = taken_over(&[]);
    bench.command(Command::StopPlc { power_off: false });
    bench.millis(1);
    assert_eq!(block_events(&bench), [("started", 0), ("aborted", 1)]);
    assert!(!bench.bit(system::PO_F));
}

#[test]
fn time_in_a_block_module_is_counted_in_cycles() {
    let mut b = Builder::new();
    b.block_module(ModuleKind::BlockInit, |b| b.tim(A + 2, Source::Int(4)));
    b.block_module(ModuleKind::BlockDone, |b| {
        b.ex();
        b.op(set(READY, true));
    });
    b.module(ModuleKind::Main, 0, |b| b.ops([]));
    let mut bench = b.load().started();
    bench.command(Command::StartBlock(block(&[], 0)));
    bench.cycles(4);
    assert!(!bench.bit(system::PO_POL));
    bench.cycles(1);
    assert!(bench.bit(system::PO_POL) && !bench.bit(READY), "then EX of BLOCK_DONE waits one cycle");
    bench.cycles(1);
    assert!(bench.bit(READY));
    assert_eq!(block_events(&bench), [("started", 0), ("finished", 5)]);
}
