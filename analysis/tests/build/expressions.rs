//! Expressions of the debugger against a built program.

use technol_analysis::expression::{
    Assignment, ExpressionError, Register, RegisterValues, Target, Value, ValueError, resolve,
};
use technol_image::DebugInfo;
use technol_image::op::Width;
use technol_image::system;

use crate::{built, parts, project, source};

const SECOND: &str = "\
DATA
DATA_END
DATA_LOCAL
TMP:  DS 1
ONLY: DS 1
DATA_LOCAL_END
MODULE_MAIN
MODULE_MAIN_END
";

fn debug() -> (DebugInfo, technol_image::Program) {
    let manifest = "[project]\nname = \"p\"\nmain = \"main.plc\"\nfiles = [\"sub/second.plc\"]\n";
    let data = "CTL: DFM A,B,,,,,,H\nWrd: DS 2\nDWD: DS 4\nBIG: DS 16\nTX: STR 5\nEQUI K,3\n\
                DATA_LOCAL\nTMP: DS 2\nDATA_LOCAL_END\n";
    let main = "MECH_BEGIN M\nTEX0 -,5,L1\nL1: EX\nMECH_END M\nPROC_BEGIN P\nNOP\nPROC_END P\n";
    let main = source(data, main);
    let built =
        built(&project(&[("technol.toml", manifest), ("main.plc", &main), ("sub/second.plc", SECOND)]));
    let (program, debug) = parts(&built);
    (debug.clone(), program.clone())
}

const fn bit(addr: u32, bit: u8) -> Target {
    Target::Bit { addr, bit }
}

const fn cell(addr: u32, width: Width) -> Target {
    Target::Cell { addr, width }
}

#[test]
fn names_registers_and_addresses() {
    let (debug, program) = debug();
    let local = program.regions[2].start;
    let big = 0x8007;
    let rows = [
        ("A", bit(0x8000, 0)),
        (" h ", bit(0x8000, 7)),
        ("ctl", cell(0x8000, Width::Byte)),
        ("WRD", cell(0x8001, Width::Word)),
        ("TX", Target::Text { addr: 0x8017, len: 5 }),
        ("K", Target::Constant(3)),
        ("M", Target::Mechanism(0)),
        ("m_line", cell(program.sequences[0].line_cell, Width::Word)),
        ("Wrd.H", bit(0x8001, 7)),
        ("Wrd.3", bit(0x8001, 3)),
        ("(BIG+2).B", bit(big + 2, 1)),
        ("$+2.B", bit(0x8002, 1)),
        ("$.B", bit(0x8000, 1)),
        ("BYTE.BIG", cell(big, Width::Byte)),
        ("dwrd.(BIG + 4)", cell(big + 4, Width::DWord)),
        ("QWRD.BIG+8-1", cell(big + 7, Width::QWord)),
        ("REAL.(BIG+K)", cell(big + 3, Width::Real)),
        ("HIGH.WRD", cell(0x8002, Width::Byte)),
        ("DWD+4", cell(big, Width::DWord)),
        ("(DWD-1)", cell(0x8002, Width::DWord)),
        ("BYTE.A", cell(0x8000, Width::Byte)),
        ("TMP", cell(local, Width::Word)),
        ("ONLY", cell(local + 3, Width::Byte)),
        ("second.plc:TMP", cell(local + 2, Width::Byte)),
        ("sub/second.plc:TMP", cell(local + 2, Width::Byte)),
        ("P2IN", cell(system::IN_PORTS + 1, Width::Byte)),
        ("P2IN.3", bit(system::IN_PORTS + 1, 3)),
        ("CNST.-5", Target::Constant(-5)),
        ("0F8h", Target::Constant(0xF8)),
        ("-0x10", Target::Constant(-16)),
        ("'A'", Target::Constant(65)),
        ("rlo", Target::Register(Register::Rlo)),
        ("DR", Target::Register(Register::Dr)),
        ("DR16", Target::Register(Register::DrPart(Width::Word))),
        ("DR_REAL", Target::Register(Register::DrReal)),
        ("BX", Target::Register(Register::Bx)),
    ];
    for (text, expected) in rows {
        assert_eq!(resolve(&debug, Some(0), text), Ok(expected), "{text}");
    }
    assert_eq!(resolve(&debug, Some(1), "TMP"), Ok(cell(local + 2, Width::Byte)));
    let cells = &program.sequences[0];
    assert_eq!(Target::Mechanism(0).in_memory(&program), bit(cells.active_addr, cells.active_bit));
}

#[test]
fn what_is_wrong_is_said() {
    let (debug, _) = debug();
    let error = |text: &str| resolve(&debug, None, text).expect_err(text);
    assert_eq!(error(""), ExpressionError::Empty);
    assert_eq!(error("NOBODY"), ExpressionError::Unknown("NOBODY".into(), None));
    assert_eq!(error("NOBODY.A"), ExpressionError::Unknown("NOBODY".into(), None));
    assert_eq!(error("BIG"), ExpressionError::NeedsType("BIG".into()));
    assert_eq!(error("BIG+1"), ExpressionError::NeedsType("BIG".into()));
    assert_eq!(error("WRD.9"), ExpressionError::NotABit("9".into()));
    assert_eq!(error("WRD.DWD"), ExpressionError::NotABit("DWD".into()));
    assert_eq!(error("P"), ExpressionError::NotInMemory("P".into(), "a procedure"));
    assert_eq!(error("L1"), ExpressionError::NotInMemory("L1".into(), "a label"));
    assert_eq!(error("BYTE.K"), ExpressionError::NotInMemory("K".into(), "a constant"));
    assert_eq!(error("WRD+DWD"), ExpressionError::NotAConstant("DWD".into()));
    assert_eq!(error("WRD-99999999"), ExpressionError::Address);
    assert_eq!(error("other.plc:A"), ExpressionError::File("other.plc".into()));
    assert_eq!(error("12xyz"), ExpressionError::Number("12xyz".into()));
    assert_eq!(error("WRD)"), ExpressionError::Unexpected(3, ")".into()));
    assert_eq!(error("(WRD"), ExpressionError::Unexpected(0, String::new()));
    assert_eq!(error("A B"), ExpressionError::Unexpected(2, "B".into()));
    let ambiguous = error("TMP").to_string();
    assert_eq!(ambiguous, "TMP is local in several files; say main.plc:TMP or sub/second.plc:TMP");
}

#[test]
fn no_text_panics() {
    let (debug, _) = debug();
    for text in
        ["$", "$+", ".", "..", "A.", "(", "((A", "+1", "-", "'", "''", "'ab'", "BYTE.", "CNST.", ":", "x:"]
    {
        assert!(resolve(&debug, Some(0), text).is_err(), "{text}");
    }
    let far =
        ["BIG-8000000000000000h", "A+9223372036854775807+9223372036854775807", "ž.ž", "-8000000000000000h"];
    for text in far {
        let _ = resolve(&debug, Some(0), text);
    }
}

#[test]
fn values_are_shown_as_their_kind() {
    let mut memory = vec![0u8; 32];
    memory[0] = 0b1000_0001;
    memory[1..3].copy_from_slice(&0xFFFEu16.to_le_bytes());
    memory[8..16].copy_from_slice(&(-2.5f64).to_le_bytes());
    memory[16..20].copy_from_slice(b"it's");
    let registers = RegisterValues { rlo: true, dr: -2, dr_real: 3.0, bx: 7 };
    let rows = [
        (bit(0, 7), "true"),
        (bit(0, 1), "false"),
        (cell(1, Width::Word), "65534"),
        (cell(1, Width::Byte), "254"),
        (cell(8, Width::Real), "-2.5"),
        (cell(8, Width::QWord), "13836183955189006336"),
        (Target::Text { addr: 16, len: 8 }, "'it''s'"),
        (Target::Constant(-4), "-4"),
        (Target::Register(Register::Rlo), "true"),
        (Target::Register(Register::Dr), "-2"),
        (Target::Register(Register::DrPart(Width::Byte)), "254"),
        (Target::Register(Register::DrPart(Width::DWord)), "4294967294"),
        (Target::Register(Register::DrReal), "3.0"),
        (Target::Register(Register::Bx), "7"),
    ];
    for (target, expected) in rows {
        assert_eq!(
            target.read(&memory, &registers).map(|v| v.to_string()).as_deref(),
            Some(expected),
            "{target:?}"
        );
    }
    assert_eq!(cell(30, Width::DWord).read(&memory, &registers), None);
    assert_eq!(Target::Mechanism(0).read(&memory, &registers), None);
    assert_eq!(bit(0, 0).decode(&[1]), Some(Value::Bit(true)));
}

#[test]
fn values_are_parsed_and_checked() {
    let byte = cell(4, Width::Byte);
    let memory = |bytes: &[u8]| Ok(Assignment::Memory { addr: 4, bytes: bytes.to_vec() });
    for (text, bytes) in
        [("255", [255u8]), ("-1", [255]), ("-128", [128]), ("0F8h", [0xF8]), ("0xf8", [0xF8]), ("'A'", [65])]
    {
        assert_eq!(byte.assign(text), memory(&bytes), "{text}");
    }
    assert_eq!(cell(4, Width::Word).assign(" 0101b "), memory(&[5, 0]));
    assert_eq!(cell(4, Width::Real).assign("1.5"), memory(&1.5f64.to_le_bytes()));
    assert_eq!(Target::Text { addr: 4, len: 3 }.assign("'ab'"), memory(&[b'a', b'b', 0, 0]));
    assert_eq!(bit(4, 2).assign("TRUE"), Ok(Assignment::Bit { addr: 4, bit: 2, value: true }));
    assert_eq!(byte.assign("256"), Err(ValueError::Range("256".into(), -128, 255)));
    assert_eq!(byte.assign("-129"), Err(ValueError::Range("-129".into(), -128, 255)));
    assert_eq!(byte.assign("1.5"), Err(ValueError::Integer("1.5".into())));
    assert_eq!(byte.assign(""), Err(ValueError::Integer(String::new())));
    assert_eq!(cell(4, Width::Real).assign("x"), Err(ValueError::Real("x".into())));
    assert_eq!(bit(4, 2).assign("2"), Err(ValueError::Bit("2".into())));
    assert_eq!(Target::Text { addr: 4, len: 3 }.assign("abcd"), Err(ValueError::TextLength(4, 3)));
    assert_eq!(Target::Constant(1).assign("1"), Err(ValueError::ReadOnly));
}

#[test]
fn a_part_of_dr_leaves_the_rest() {
    let before = RegisterValues { dr: 0x1122_3344_5566_7788, ..RegisterValues::default() };
    let after = |register, text: &str| match Target::Register(register).assign(text) {
        Ok(Assignment::Registers(change)) => change.apply(before),
        other => panic!("{other:?}"),
    };
    assert_eq!(after(Register::DrPart(Width::Word), "-1").dr, 0x1122_3344_5566_FFFF);
    assert_eq!(after(Register::Dr, "-1").dr, -1);
    assert!(after(Register::Rlo, "1").rlo);
    assert_eq!(after(Register::Bx, "9").bx, 9);
    assert!((after(Register::DrReal, "-0.5").dr_real + 0.5).abs() < f64::EPSILON);
}
