//! When each module is executed (manual chapter 5).

use technol_analysis::project::FileReader;
use technol_runtime::{Block, Command, PlcState, Resume, StopReason};

use crate::frame;
use crate::plc::{Plc, build};

const DATA: &str = "IB: DFM I0,I1\nOB: DFM O0,O1,O2,O3\nW1: DS 2\nW2: DS 2\nW3: DS 2";

/// A program with these lines of MODULE_MAIN and of one of the mandatory modules.
fn plc(main: &str, module: &str, lines: &str) -> Plc {
    let text = |lines: &str| -> String { lines.split(" / ").flat_map(|line| [" ", line, "\n"]).collect() };
    let source = frame::program(DATA, text(main).trim_end(), "");
    let begin = format!("{module}\n");
    assert!(source.contains(&begin));
    Plc::from_source(&source.replacen(&begin, &format!("{begin}{}", text(lines)), 1))
}

const COUNT: &str = "LOD W1 / INR / STO W1";

#[test]
fn input_comes_before_main() {
    let mut plc = plc(COUNT, "MODULE_INPUT", "LOD W1 / STO W2");
    plc.run(3);
    assert_eq!(plc.differences("W1=3 W2=2"), [""; 0]);
}

#[test]
fn block_init_holds_the_motion_and_block_done_the_next_block() {
    let moves = Block { motion_ms: 100, ..Block::default() };
    let main = "LDR PO_F / WR O2";
    let mut before = plc(main, "MODULE_BLOCK_INIT", "FL 1,O0 / EX / LDR I0 / EX0 / FL 1,O1");
    before.run(2);
    assert_eq!(before.differences("OB=0"), [""; 0], "only a block begins it");
    before.command(Command::StartBlock(moves.clone()));
    before.run(20);
    assert_eq!(before.differences("OB=101b"), [""; 0], "in progress for longer than it moves");
    before.set("I0=1");
    before.run(3);
    assert_eq!(before.differences("OB=111b"), [""; 0], "now it moves");
    before.run(10);
    assert_eq!(before.differences("OB=011b"), [""; 0]);
    let mut behind = plc(main, "MODULE_BLOCK_DONE", "FL 1,O0 / LDR I0 / EX0 / FL 1,O1");
    behind.command(Command::StartBlock(moves.clone()));
    behind.command(Command::StartBlock(moves));
    behind.run(3);
    assert_eq!(behind.differences("OB=100b"), [""; 0]);
    behind.run(20);
    assert_eq!((behind.differences("OB=101b"), behind.runtime().waiting_blocks()), (vec![], 1));
    behind.set("I0=1");
    behind.run(3);
    assert_eq!((behind.differences("OB=111b"), behind.runtime().waiting_blocks()), (vec![], 0));
    behind.run(10);
    assert_eq!(behind.differences("OB=011b"), [""; 0]);
}

#[test]
fn a_transfer_of_a_block_module_starts_once_in_each_block() {
    let lines = "LOD W1 / INR / STO W1 / SA_READ 1,10,2,W2 / EX0 / FL 1,O0";
    let block = Block { motion_ms: 100, ..Block::default() };
    let mut plc = plc("LDR PO_F / WR O2", "MODULE_BLOCK_INIT", lines);
    plc.control().shared_area_mut(1).expect("an area")[10..12].copy_from_slice(&[7, 1]);
    plc.command(Command::StartBlock(block.clone()));
    plc.run(1);
    assert_eq!(plc.differences("W1=1 W2=0 OB=100b"), [""; 0], "it waits for its data");
    // Central annulment breaks it off; the next block begins it anew, with what is there then.
    plc.command(Command::AbortBlock);
    plc.run(3);
    assert_eq!(plc.differences("W1=1 W2=0 OB=0"), [""; 0]);
    plc.control().shared_area_mut(1).expect("an area")[10] = 8;
    plc.command(Command::StartBlock(block));
    plc.run(1);
    assert_eq!(plc.differences("W1=2 W2=0 OB=100b"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("W1=2 W2=108h OB=101b"), [""; 0]);
    plc.run(10);
    assert_eq!(plc.differences("W1=2 OB=001b"), [""; 0], "the block went on and ended");
}

#[test]
fn the_block_waits_for_the_transfer_of_block_done() {
    let lines = "SA_WRITE 0,W3,2,W1 / STO W2 / EX0 / FL 1,O0";
    let block = Block { motion_ms: 20, ..Block::default() };
    let mut first = plc("LDR PO_F / WR O2", "MODULE_BLOCK_DONE", lines);
    first.set("W1=1234h W3=30");
    first.command(Command::StartBlock(block.clone()));
    first.run(10);
    assert_eq!(first.differences("OB=001b W2=0"), [""; 0]);
    assert_eq!(first.control().shared_area_mut(0).expect("an area")[30..32], [0x34, 0x12]);
    // Outside the area: EX0 holds the block, and DR says why.
    let mut second = plc("LDR PO_F / WR O2", "MODULE_BLOCK_DONE", lines);
    second.set("W3=31999");
    second.command(Command::StartBlock(block));
    second.run(10);
    assert_eq!(second.differences("OB=100b W2=1"), [""; 0]);
}

#[test]
fn clear_and_halt_are_executed_once() {
    let mut cleared = plc("LOD W2 / INR / STO W2", "MODULE_CLEAR", COUNT);
    cleared.run(2);
    assert_eq!(cleared.differences("W1=0 W2=2"), [""; 0]);
    cleared.command(Command::ClearPlc);
    cleared.run(3);
    assert_eq!((cleared.differences("W1=1 W2=5"), cleared.runtime().state()), (vec![], PlcState::Running));
    let mut halted = plc("LOD W2 / INR / STO W2", "MODULE_HALT", COUNT);
    halted.run(2);
    halted.command(Command::Halt);
    halted.run(3);
    assert_eq!((halted.differences("W1=1 W2=2"), halted.runtime().state()), (vec![], PlcState::Halted));
}

#[test]
fn a_comment_may_follow_stop() {
    let mut source = frame::program(DATA, " LOD W1\n INR\n STO W1", "");
    assert!(source.ends_with("STOP\n"));
    source.push_str("; FL 1,O0\n");
    let mut plc = Plc::from_source(&source);
    plc.run(2);
    assert_eq!(plc.differences("W1=2 OB=0"), [""; 0]);
}

/// A project in which only lines of DEBUG regions take break-points.
struct Project(String);

impl FileReader for Project {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        match path {
            "project/technol.toml" => {
                Ok(b"[project]\nname = 'regions'\nmain = 'plc.plc'\n[debug]\neverywhere = false\n".to_vec())
            }
            "project/plc.plc" => Ok(self.0.clone().into_bytes()),
            _ => Err("no such file".to_owned()),
        }
    }
}

#[test]
fn lines_know_whether_they_are_in_a_debug_region() {
    let main = " LOD W1\nDEBUG ON\n INR\nDEBUG OFF\n STO W1\nDEBUG\n LOD W2";
    let project = Project(frame::program(DATA, main, ""));
    let mut plc = Plc::from_image(build(&project, "project").image);
    plc.run(2);
    assert_eq!(plc.differences("W1=2"), [""; 0]);
    let first = 3 + DATA.lines().count() as u32 + 1;
    let within: Vec<u32> =
        (first..first + 7).filter(|line| plc.in_debug_region(*line) == Some(true)).collect();
    let outside: Vec<u32> =
        (first..first + 7).filter(|line| plc.in_debug_region(*line) == Some(false)).collect();
    assert_eq!((within, outside), (vec![first + 2, first + 6], vec![first, first + 4]));
}

#[test]
fn cont_goes_on_while_a_break_point_holds_the_rest() {
    let modules = "MODULE_CONT / LOD W1 / INR / STO W1 / MODULE_CONT_END / \
                   MODULE_FAST / LOD W2 / INR / STO W2 / MODULE_FAST_END";
    let mut plc = Plc::with_modules("", "LOD D1 / INR / STO D1", modules);
    plc.run(3);
    assert_eq!(plc.differences("W1=3 W2=60 D1=3"), [""; 0]);
    plc.runtime().pause();
    plc.tick(40);
    assert_eq!(plc.runtime().stopped().map(|stop| stop.reason), Some(StopReason::Pause));
    assert_eq!(plc.differences("W1=4 D1=3"), [""; 0]);
    plc.tick(60);
    assert_eq!(plc.differences("W1=7 D1=3"), [""; 0]);
    plc.runtime().resume(Resume::Continue);
    plc.run(2);
    assert_eq!(plc.differences("D1=5"), [""; 0]);
}
