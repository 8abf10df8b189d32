//! LOD, STO, MOVE, MV, CLEAR and indexing (manual 3.8, 3.14, 3.16).

use technol_image::op::{Cond, Op, Source, Width};
use technol_runtime::{FaultKind, Registers};

use crate::operation::{check, check_fault, registers, with_dr, with_rlo};
use crate::support::{END, GLOBAL as A, cell, indexed, mem, sto};

fn load(src: Source, width: Width, neg: bool) -> Op {
    Op::Load { src, width, neg }
}

#[test]
fn load_sign_extends_from_its_width() {
    let bytes: &[u8] = &[0x80, 0xFF, 0x7F, 0x80, 0x01, 0x02, 0x03, 0x84];
    let rows = [
        (Width::Byte, -0x80),
        (Width::Word, -0x80),
        (Width::DWord, -0x7F80_0080),
        (Width::QWord, 0x8403_0201_807F_FF80_u64 as i64),
    ];
    for (width, value) in rows {
        check(&[load(mem(A), width, false)], registers(), &[(A, bytes)], with_dr(value), &[]);
        check(&[load(mem(A), width, true)], registers(), &[(A, bytes)], with_dr(-value), &[]);
    }
    for (width, positive) in [(Width::Byte, 0x7F), (Width::Word, 0x7F7F), (Width::DWord, 0x7F7F_7F7F)] {
        check(&[load(mem(A), width, false)], registers(), &[(A, &[0x7F; 8])], with_dr(positive), &[]);
    }
}

#[test]
fn load_of_a_constant_takes_all_64_bits() {
    for width in [Width::Byte, Width::Word, Width::DWord, Width::QWord] {
        for value in [0, 1, -1, 0x7F, i64::from(i32::MIN), i64::MAX, i64::MIN] {
            check(&[load(Source::Int(value), width, false)], registers(), &[], with_dr(value), &[]);
            let negated = with_dr(value.wrapping_neg());
            check(&[load(Source::Int(value), width, true)], registers(), &[], negated, &[]);
        }
    }
}

#[test]
fn real_load_also_writes_the_rounded_integer() {
    let rows = [
        (0.0, 0),
        (0.5, 0),
        (1.5, 2),
        (2.5, 2),
        (-0.5, 0),
        (-1.5, -2),
        (-2.5, -2),
        (0.499_999_999_999_999_94, 0),
        (4_503_599_627_370_495.5, 4_503_599_627_370_496),
        (4_503_599_627_370_497.0, 4_503_599_627_370_497),
        (1e300, i64::MAX),
        (-1e300, i64::MIN),
        (f64::INFINITY, i64::MAX),
        (f64::NEG_INFINITY, i64::MIN),
        (f64::NAN, 0),
    ];
    for (value, integer) in rows {
        let after = Registers { dr: integer, dr_real: value, ..registers() };
        check(&[load(Source::Real(value), Width::Real, false)], registers(), &[], after, &[]);
        let memory = value.to_le_bytes();
        check(&[load(mem(A), Width::Real, false)], registers(), &[(A, &memory)], after, &[]);
    }
    let negated = Registers { dr: -10, dr_real: -10.2, ..registers() };
    check(&[load(Source::Real(10.2), Width::Real, true)], registers(), &[], negated, &[]);
}

#[test]
fn store_writes_the_low_bytes_of_its_width() {
    let before = registers();
    let rows: [(Width, &[u8]); 4] = [
        (Width::Byte, &[0xEF]),
        (Width::Word, &[0xEF, 0xCD]),
        (Width::DWord, &[0xEF, 0xCD, 0xAB, 0x89]),
        (Width::QWord, &[0xEF, 0xCD, 0xAB, 0x89, 0x67, 0x45, 0x23, 0x01]),
    ];
    for (width, bytes) in rows {
        check(&[sto(A, width)], before, &[], before, &[(A, bytes)]);
        check(&[sto(END - width.bytes(), width)], before, &[], before, &[(END - width.bytes(), bytes)]);
    }
    let real = 0.625_f64.to_le_bytes();
    check(&[sto(A, Width::Real)], before, &[], before, &[(A, &real)]);
}

#[test]
fn conditional_store_follows_rlo() {
    for (cond, rlo, acts) in [
        (Cond::IfRlo, true, true),
        (Cond::IfRlo, false, false),
        (Cond::IfNotRlo, true, false),
        (Cond::IfNotRlo, false, true),
    ] {
        for width in [Width::Byte, Width::Word, Width::DWord, Width::QWord, Width::Real] {
            let before = Registers { dr: 0, dr_real: 0.0, ..with_rlo(rlo) };
            let store = Op::Store { dst: cell(A), width, cond };
            let zeros = vec![0; width.bytes() as usize];
            let writes: &[(u32, &[u8])] = if acts { &[(A, &zeros)] } else { &[] };
            check(&[store], before, &[(A, &[0xFF; 9])], before, writes);
        }
    }
}

#[test]
fn integer_store_after_a_real_operation_stores_the_copy() {
    let ops = [load(Source::Real(2.5), Width::Real, false), sto(A, Width::Word), sto(A + 8, Width::Real)];
    let after = Registers { dr: 2, dr_real: 2.5, ..registers() };
    check(&ops, registers(), &[], after, &[(A, &[2, 0]), (A + 8, &2.5_f64.to_le_bytes())]);
}

#[test]
fn move_copies_its_width_and_no_register() {
    let source: &[u8] = &[1, 2, 3, 4, 5, 6, 7, 8, 9];
    for width in [Width::Byte, Width::Word, Width::DWord, Width::QWord, Width::Real] {
        let copied = &source[..width.bytes() as usize];
        for (cond, rlo, acts) in [
            (Cond::Always, false, true),
            (Cond::IfRlo, false, false),
            (Cond::IfRlo, true, true),
            (Cond::IfNotRlo, true, false),
        ] {
            let op = Op::Move { dst: cell(A + 16), src: cell(A), width, cond };
            let writes: &[(u32, &[u8])] = if acts { &[(A + 16, copied)] } else { &[] };
            check(&[op], with_rlo(rlo), &[(A, source)], with_rlo(rlo), writes);
        }
    }
}

#[test]
fn move_keeps_every_bit_of_a_real() {
    // A signalling NaN survives, because nothing computes with it.
    let bytes = 0x7FF0_0000_0000_0001_u64.to_le_bytes();
    let op = Op::Move { dst: cell(A + 8), src: cell(A), width: Width::Real, cond: Cond::Always };
    check(&[op], registers(), &[(A, &bytes)], registers(), &[(A + 8, &bytes)]);
}

#[test]
fn copy_of_overlapping_areas_acts_as_if_through_a_buffer() {
    let source: &[u8] = &[1, 2, 3, 4, 5, 6];
    let copy = |src, dst| Op::Copy { src: cell(src), dst: cell(dst), len: 4 };
    check(&[copy(A, A + 2)], registers(), &[(A, source)], registers(), &[(A + 2, &[1, 2, 3, 4])]);
    check(&[copy(A + 2, A)], registers(), &[(A, source)], registers(), &[(A, &[3, 4, 5, 6])]);
    let nothing = Op::Copy { src: cell(A), dst: cell(A + 2), len: 0 };
    check(&[nothing], registers(), &[(A, source)], registers(), &[]);
}

#[test]
fn clear_zeroes_exactly_its_bytes() {
    let clear = Op::Clear { addr: A + 1, len: 3 };
    check(&[clear], registers(), &[(A, &[0xFF; 6])], registers(), &[(A + 1, &[0, 0, 0])]);
}

#[test]
fn index_is_the_low_word_of_dr() {
    let after = Registers { bx: 0xCDEF, ..registers() };
    check(&[Op::IndexFromDr], registers(), &[], after, &[]);
}

#[test]
fn indexed_cells_reach_every_byte_of_memory_and_none_outside() {
    for width in [Width::Byte, Width::Word, Width::DWord, Width::QWord, Width::Real] {
        let last = END - width.bytes();
        let store = Op::Store { dst: indexed(A), width, cond: Cond::Always };
        let fetch = load(Source::Mem(indexed(A)), width, false);
        for inside in [0, A, last] {
            let before = Registers { bx: inside.wrapping_sub(A), dr: 0, dr_real: 0.0, ..registers() };
            check(&[fetch, store], before, &[], before, &[]);
        }
        for (outside, addr) in [(u32::MAX, -1), (last + 1, i64::from(last) + 1)] {
            let before = Registers { bx: outside.wrapping_sub(A), ..registers() };
            let fault = FaultKind::BadAddress { addr, len: width.bytes() };
            check_fault(&[store], before, &[], 0, fault);
            check_fault(&[fetch], before, &[], 0, fault);
        }
    }
    let far = Registers { bx: i32::MIN as u32, ..registers() };
    let addr = i64::from(A) + i64::from(i32::MIN);
    let copy = Op::Copy { src: indexed(A), dst: cell(A), len: 7 };
    check_fault(&[copy], far, &[], 0, FaultKind::BadAddress { addr, len: 7 });
}

#[test]
fn nop_does_nothing() {
    check(&[Op::Nop], registers(), &[], registers(), &[]);
}
