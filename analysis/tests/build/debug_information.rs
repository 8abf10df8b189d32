//! What the debugger gets to know.

use technol_image::debug_info::{Scope, Symbol, SymbolKind};
use technol_image::op::Width;
use technol_image::program::ModuleKind;
use technol_image::{container, system};

use crate::{built, built_source, parts, project, source};

const DATA: &str =
    "CTL: DFM A,B\nCount: DS 2\nTX: STR 5,'abc'\nEQUI LIMIT,50\nDATA_LOCAL\nTmp: DS 30\nDATA_LOCAL_END\n";

const MAIN: &str = "\
MECH_BEGIN Pump
  FL 1,A   ;start
  LDR B
  LA  -A
  EX0
again:
  TIM -,LIMIT
  LDR P3IN.B
  JL1 again
MECH_END Pump
MECH_BEGIN Idle
  EX
MECH_END Idle
";

#[test]
fn mechanisms_have_states_with_their_conditions() {
    let built = built_source(DATA, MAIN);
    let (_, debug) = parts(&built);
    let pump = &debug.mechanisms[0];
    assert_eq!((pump.name.as_str(), pump.sequence, pump.lines), ("Pump", 0, (11, 20)));
    assert_eq!(pump.module, ModuleKind::Main);
    let states: Vec<(u16, u32, &str, &str)> =
        pump.states.iter().map(|s| (s.point, s.line, s.mnemonic.as_str(), s.condition.as_str())).collect();
    assert_eq!(states, [(1, 15, "EX0", "FL 1,A / LDR B / LA -A"), (2, 17, "TIM", "")]);
    let names: Vec<&str> = debug.mechanisms.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["Pump", "Idle", "MODULE_BLOCK_INIT", "MODULE_BLOCK_DONE"]);
    let init = &debug.mechanisms[2];
    assert_eq!((init.module, init.states.len()), (ModuleKind::BlockInit, 0));
}

#[test]
fn symbols_are_as_declared_with_scope_and_place() {
    let built = built_source(DATA, MAIN);
    let (program, debug) = parts(&built);
    let find = |name: &str| -> &Symbol { debug.symbols.iter().find(|s| s.name == name).unwrap() };
    let kind = |name: &str| find(name).kind.clone();
    assert_eq!(kind("A"), SymbolKind::Bit { addr: 0x8000, bit: 0 });
    assert_eq!(kind("Count"), SymbolKind::Cell { addr: 0x8001, width: Width::Word });
    assert_eq!(kind("TX"), SymbolKind::Text { addr: 0x8003, len: 5 });
    assert_eq!(kind("LIMIT"), SymbolKind::Constant { value: 50 });
    assert_eq!(find("Count").declared, Some((0, 3)));
    let local = find("Tmp");
    assert_eq!(local.scope, Scope::File(0));
    assert_eq!(local.kind, SymbolKind::Area { addr: program.regions[2].start, len: 30 });
    assert_eq!(kind("Pump"), SymbolKind::Mechanism { sequence: 0 });
    let line = SymbolKind::Cell { addr: program.sequences[0].line_cell, width: Width::Word };
    assert_eq!(kind("Pump_LINE"), line);
    let again = find("again");
    assert_eq!(again.kind, SymbolKind::Label { pc: program.sequences[0].resume[0] });
    assert_eq!(again.scope, Scope::File(0));
    assert_eq!(program.initial.last().expect("the text").bytes, b"abc");
    // Of the predefined symbols only those that occur.
    let predefined: Vec<&Symbol> = debug.symbols.iter().filter(|s| s.scope == Scope::System).collect();
    assert_eq!(predefined.len(), 1);
    assert_eq!(predefined[0].kind, SymbolKind::Cell { addr: system::IN_PORTS + 2, width: Width::Byte });
}

#[test]
fn debug_regions_count_when_not_every_line_takes_break_points() {
    let manifest = "[project]\nname = \"p\"\nmain = \"main.plc\"\n[debug]\neverywhere = false\n";
    let text = source("CTL: DFM A,B\n", "LDR A\nDEBUG\nLA B\nDEBUG OFF\nWR A\n");
    let built = built(&project(&[("technol.toml", manifest), ("main.plc", &text)]));
    let (_, debug) = parts(&built);
    let inside: Vec<u32> = debug.lines.iter().filter(|l| l.in_debug_region).map(|l| l.line).collect();
    assert_eq!(inside, [7]);
}

#[test]
fn files_carry_the_hash_of_their_text() {
    let text = source("", "");
    let built = built(&project(&[("main.plc", &text)]));
    let (_, debug) = parts(&built);
    assert_eq!(debug.files.len(), 1);
    assert_eq!(debug.files[0].hash, container::hash_bytes(text.as_bytes()));
    assert_eq!(debug.files[0].order, Some(0));
    assert_eq!(debug.program, built.hash);
}

#[test]
fn an_included_constant_belongs_to_its_file() {
    let text = source("A: DS 1\n", "LOD SPEED\nSTO A\n");
    let main = format!("T_INCLUDE consts.inc\n{text}");
    let built = built(&project(&[("main.plc", &main), ("consts.inc", "EQUI SPEED,7\n")]));
    let (_, debug) = parts(&built);
    let speed = debug.symbols.iter().find(|s| s.name == "SPEED").unwrap();
    assert_eq!(speed.declared, Some((1, 1)));
    assert_eq!((debug.files[1].path.as_str(), debug.files[1].order), ("consts.inc", None));
}
