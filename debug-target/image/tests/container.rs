//! The image file: what is written is read back, and nothing else is.

use proptest::prelude::*;

use technol_image::container::{self, FORMAT_VERSION, content_hash, decode_program, encode_program};
use technol_image::debug_info::{DebugInfo, Line, Scope, SourceFile, Symbol, SymbolKind};
use technol_image::op::{Arith, BitRef, Cond, Op, Place, Source, Width};
use technol_image::program::{Module, ModuleKind, Region, RegionKind, Timed};
use technol_image::{DecodeError, Image, Program, decode, encode};

fn program() -> Program {
    let bit = BitRef { addr: 0x8000, bit: 3, indexed: false };
    let place = Place { addr: 0x8010, indexed: true };
    Program {
        name: "soustruh č. 1".into(),
        regions: vec![Region { kind: RegionKind::System, start: 0, len: 0x8000 }],
        code: vec![
            Op::Ldr { bit, neg: true, push: false },
            Op::Load { src: Source::Real(-0.1), width: Width::Real, neg: false },
            Op::Arith { op: Arith::Mul, src: Source::Int(i64::MIN), width: Width::DWord },
            Op::Store { dst: place, width: Width::QWord, cond: Cond::IfNotRlo },
            Op::ModuleEnd,
        ],
        statements: vec![0, 1, 3],
        modules: vec![Module { kind: ModuleKind::Main, file: 63, start: 0, end: 5 }],
        sequences: vec![],
        timed: vec![Timed {
            wait_when: Some(true),
            count: place,
            width: Width::Byte,
            time: Source::Int(500),
            error: Some(4),
            code: None,
            point: 1,
            line: 12,
        }],
        messages: vec![],
        services: Vec::new(),
        procedures: vec![],
        initial: vec![],
        init_finished: vec![0, 5],
        done_finished: vec![],
    }
}

fn debug_of(program: &Program) -> DebugInfo {
    DebugInfo {
        program: content_hash(program),
        files: vec![SourceFile { path: "main.plc".into(), hash: [7; 16], order: Some(0) }],
        lines: [(0, 10), (1, 11), (3, 20)]
            .map(|(pc, line)| Line { pc, file: 0, line, in_debug_region: true })
            .into(),
        symbols: vec![Symbol {
            name: "KONEC".into(),
            scope: Scope::Global,
            kind: SymbolKind::Label { pc: 4 },
            declared: Some((0, 20)),
        }],
        mechanisms: vec![],
    }
}

fn image() -> Image {
    Image { program: program(), debug: Some(debug_of(&program())) }
}

#[test]
fn image_comes_back_as_it_was_written() {
    assert_eq!(decode(&encode(&image())), Ok(image()));
    let stripped = Image { debug: None, ..image() };
    assert_eq!(decode(&encode(&stripped)), Ok(stripped));
    assert_eq!(decode_program(&encode_program(&program())), Ok(program()));
}

#[test]
fn every_shorter_file_is_refused() {
    let bytes = encode(&image());
    for len in 0..bytes.len() {
        let expected = if len < 4 { DecodeError::NotAnImage } else { DecodeError::Truncated };
        assert_eq!(decode(&bytes[..len]), Err(expected), "{len} bytes");
    }
}

#[test]
fn every_changed_byte_is_noticed() {
    let bytes = encode(&image());
    for at in 0..bytes.len() {
        for flip in [0x01, 0x80, 0xFF] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            assert!(decode(&damaged).is_err(), "byte {at} xor {flip:#x}");
        }
    }
}

#[test]
fn appended_bytes_are_noticed() {
    let mut bytes = encode(&image());
    bytes.push(0);
    assert_eq!(decode(&bytes), Err(DecodeError::Checksum));
}

#[test]
fn other_version_is_named_before_the_checksum_is_looked_at() {
    let mut bytes = encode(&image());
    let other = FORMAT_VERSION + 1;
    bytes[4..6].copy_from_slice(&other.to_le_bytes());
    assert_eq!(decode(&bytes), Err(DecodeError::Version { found: other }));
}

#[test]
fn debug_information_of_another_program_is_refused() {
    let mut other = program();
    other.code[0] = Op::Nop;
    let foreign = Image { program: program(), debug: Some(debug_of(&other)) };
    assert_eq!(decode(&encode(&foreign)), Err(DecodeError::ForeignDebugInfo));
}

#[test]
fn content_hash_depends_on_the_program_only() {
    let hash = content_hash(&program());
    assert_eq!(hash, content_hash(&decode(&encode(&image())).expect("valid").program));
    let mut other = program();
    other.statements.pop();
    assert_ne!(hash, content_hash(&other));
}

#[test]
fn program_with_trailing_bytes_is_malformed() {
    let mut bytes = encode_program(&program());
    bytes.push(0);
    assert_eq!(decode_program(&bytes), Err(DecodeError::Malformed));
}

#[test]
fn position_is_the_line_that_covers_the_operation() {
    let debug = debug_of(&program());
    assert_eq!(debug.position(0), Some(("main.plc", 10)));
    assert_eq!(debug.position(2), Some(("main.plc", 11)), "second operation of its line");
    assert_eq!(debug.position(4), Some(("main.plc", 20)));
    assert_eq!(DebugInfo::default().position(0), None);
}

/// A file that passes the checksum whatever its content is.
fn sealed(program: &[u8], debug: &[u8]) -> Vec<u8> {
    let mut bytes = container::MAGIC.to_vec();
    bytes.extend(FORMAT_VERSION.to_le_bytes());
    bytes.extend((program.len() as u32).to_le_bytes());
    bytes.extend((debug.len() as u32).to_le_bytes());
    bytes.extend(program);
    bytes.extend(debug);
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI).checksum(&bytes);
    bytes.extend(crc.to_le_bytes());
    bytes
}

proptest! {
    #[test]
    fn arbitrary_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(decode(&bytes).is_err());
        let _ = decode_program(&bytes);
        let _ = decode(&sealed(&bytes, &[]));
        let _ = decode(&sealed(&encode_program(&program()), &bytes));
    }

    #[test]
    fn damaged_content_under_a_valid_checksum_never_panics(
        at in any::<prop::sample::Index>(),
        value in any::<u8>(),
    ) {
        let mut bytes = encode_program(&program());
        let at = at.index(bytes.len());
        bytes[at] = value;
        if let Ok(image) = decode(&sealed(&bytes, &[])) {
            prop_assert_eq!(decode_program(&encode_program(&image.program)), Ok(image.program));
        }
    }
}
