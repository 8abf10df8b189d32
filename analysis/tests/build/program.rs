//! A whole small program: its listing, and that a build depends on nothing but the sources.

use technol_image::program::{ModuleKind, RegionKind};
use technol_image::{decode, encode};

use crate::{built, parts, project};

const MANIFEST: &str = "\
[project]
name = \"press\"
main = \"main.plc\"
files = [\"guard.plc\"]
";

const MAIN: &str = "\
; press
EQUI T_DOWN,50
DATA
IN1:   DFM START,DOWN,UP
OUT1:  DFM VALVE,,LAMP
STROKES: DS 2
DATA_END
DATA_LOCAL
TMP:   DS 1
DATA_LOCAL_END
MODULE_INPUT
   LOD P1IN
   STO IN1
MODULE_INPUT_END
MODULE_BLOCK_INIT
   LDR PO_F
   EX1
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
DEBUG ON
MODULE_MAIN
   EDGE_H START
   FL1 1,STROKE
   MECH_BEGIN Stroke       ; down and up again
   FL  1,VALVE
   LDR DOWN
   TEX0 -,T_DOWN,FAULT,12
   FL  0,VALVE
   LDR UP
   EX0
   LOD STROKES
   INR
   STO STROKES
   JUM READY
FAULT:
   FL  0,VALVE
   ESET
READY:
   MECH_END Stroke
DEBUG OFF
   PROC_BEGIN BLINK
   LDR -LAMP
   WR  LAMP
   PROC_END BLINK
   DFTM1 NEXT
   PROC_CALL BLINK
NEXT:
   LOD OUT1
   STO P0OUT
MODULE_MAIN_END
MODULE_INIT
   MODULE_INIT_FINISHED
MODULE_INIT_END
MODULE_CLEAR
   CLEAR GLOBAL,ALL
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

const GUARD: &str = "\
DATA
GATE:  DFM OPEN,,,,,,,ALARM
DATA_END
DATA_LOCAL
TMP:   DS 2
DATA_LOCAL_END
MODULE_MAIN
   LDR OPEN
   LA  STROKE
   WR  ALARM,GATE.LAMP
   LOD TMP
   AD  CNST.1
   STO TMP
MODULE_MAIN_END
";

fn files() -> [(&'static str, &'static str); 3] {
    [("technol.toml", MANIFEST), ("main.plc", MAIN), ("guard.plc", GUARD)]
}

#[test]
fn the_listing_shows_source_address_and_code() {
    let analysis = project(&files());
    let listing = analysis.listing(&built(&analysis)).unwrap();
    // The first line names the hash, which every change of an operation moves.
    let (head, rest) = listing.split_once('\n').unwrap();
    assert!(head.starts_with("TECHNOL listing of press, program "), "{head}");
    insta::assert_snapshot!(rest);
}

#[test]
fn the_same_sources_give_the_same_bytes() {
    let first = built(&project(&files()));
    let second = built(&project(&files()));
    assert_eq!(encode(&first.image), encode(&second.image));
    assert_eq!(first.hash, second.hash);
    assert_eq!(decode(&encode(&first.image)).unwrap(), first.image);
}

#[test]
fn a_comment_changes_the_sources_but_not_the_program() {
    let commented = MAIN.replace("; press", "; the press");
    let (before, after) = (project(&files()), project(&[files()[0], ("main.plc", &commented), files()[2]]));
    assert_eq!(built(&before).hash, built(&after).hash);
    assert_ne!(before.sources_hash().unwrap(), after.sources_hash().unwrap());
    assert_eq!(before.sources_hash().unwrap(), project(&files()).sources_hash().unwrap());
}

#[test]
fn regions_follow_each_other_and_modules_follow_the_files() {
    let built = built(&project(&files()));
    let (program, _) = parts(&built);
    let mut next = 0;
    for region in &program.regions {
        assert_eq!(region.start, next);
        next += region.len;
    }
    assert_eq!(program.memory_len(), next);
    let len = |kind| program.region(kind).unwrap().len;
    // IN1, OUT1, STROKES, GATE; activation bits of three sequences and their nine words.
    assert_eq!(len(RegionKind::Global), 1 + 1 + 2 + 1 + 1 + 3 * 6);
    // TMP of both files, one automatic counter; one edge.
    assert_eq!((len(RegionKind::Local), len(RegionKind::Hidden)), (1 + 2 + 2, 1));
    let main: Vec<u8> =
        program.modules.iter().filter(|m| m.kind == ModuleKind::Main).map(|m| m.file).collect();
    assert_eq!(main, [0, 1]);
    let mut end = 0;
    for module in &program.modules {
        assert_eq!(module.start, end, "modules leave no gap");
        end = module.end;
    }
    assert_eq!(end as usize, program.code.len());
    assert_eq!((program.init_finished.as_slice(), program.done_finished.as_slice()), (&[0u8][..], &[][..]));
}

#[test]
fn every_statement_is_the_first_operation_of_a_line() {
    let built = built(&project(&files()));
    let (program, debug) = parts(&built);
    let of_lines: Vec<u32> = debug.lines.iter().map(|line| line.pc).collect();
    assert_eq!(program.statements, of_lines);
    assert!(program.statements.windows(2).all(|pair| pair[0] < pair[1]));
}
