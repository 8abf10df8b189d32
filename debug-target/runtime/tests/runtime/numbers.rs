//! Arithmetic, comparison, conversion and shifting (manual 3.9 to 3.13, 3.15).

use technol_image::op::{Arith, Compare, DrTest, Op, Source, Unary, Width};
use technol_runtime::{FaultKind, Registers};

use crate::operation::{check, check_fault, registers, with_dr, with_rlo};
use crate::support::{GLOBAL as A, mem};

const WIDTHS: [Width; 4] = [Width::Byte, Width::Word, Width::DWord, Width::QWord];

fn arith(op: Arith, src: Source, width: Width) -> Op {
    Op::Arith { op, src, width }
}

/// The operand as a constant and in memory must give the same.
#[track_caller]
fn check_arith(op: Arith, width: Width, dr: i64, operand: i64, result: i64) {
    check(&[arith(op, Source::Int(operand), width)], with_dr(dr), &[], with_dr(result), &[]);
    let bytes = operand.to_le_bytes();
    let memory: &[u8] = &bytes[..width.bytes() as usize];
    check(&[arith(op, mem(A), width)], with_dr(dr), &[(A, memory)], with_dr(result), &[]);
}

const X: i64 = 0x1122_3344_5566_77F0;

#[test]
fn addition_carries_no_further_than_its_width() {
    let rows = [
        (Width::Byte, 0x20, 0x1122_3344_5566_7710),
        (Width::Byte, -1, 0x1122_3344_5566_77EF),
        (Width::Word, 0x0910, 0x1122_3344_5566_8100),
        (Width::Word, -0x77F1, 0x1122_3344_5566_FFFF),
        (Width::DWord, 0x7FFF_FFFF, 0x1122_3344_D566_77EF),
        (Width::DWord, -0x5566_77F1, 0x1122_3344_FFFF_FFFF),
        (Width::QWord, i64::MAX, 0x1122_3344_5566_77EF | i64::MIN),
    ];
    for (width, operand, result) in rows {
        check_arith(Arith::Add, width, X, operand, result);
    }
    check_arith(Arith::Add, Width::QWord, i64::MAX, 1, i64::MIN);
}

#[test]
fn subtraction_borrows_no_further_than_its_width() {
    let rows = [
        (Width::Byte, 0x71, 0x1122_3344_5566_777F),
        (Width::Byte, -0x10, 0x1122_3344_5566_7700),
        (Width::Word, 0x77F1, 0x1122_3344_5566_FFFF),
        (Width::DWord, 0x5566_77F1, 0x1122_3344_FFFF_FFFF),
        (Width::QWord, X, 0),
    ];
    for (width, operand, result) in rows {
        check_arith(Arith::Sub, width, X, operand, result);
    }
    check_arith(Arith::Sub, Width::QWord, i64::MIN, 1, i64::MAX);
}

#[test]
fn bitwise_functions_leave_the_bits_above_their_width() {
    for width in WIDTHS {
        let low = if width == Width::QWord { -1 } else { (1_i64 << width.bits()) - 1 };
        let operand = -0x0F0F_0F0F_0F0F_0F10; // F0F0…F0 in every byte
        let operand = operand << (64 - width.bits()) >> (64 - width.bits());
        let parts = |value: i64| X & !low | value & low;
        check_arith(Arith::And, width, X, operand, parts(X & operand));
        check_arith(Arith::Or, width, X, operand, parts(X | operand));
        check_arith(Arith::Xor, width, X, operand, parts(X ^ operand));
    }
    check_arith(Arith::And, Width::Byte, -1, 0x0F, -0xF1);
    check_arith(Arith::Or, Width::Word, 0, -1, 0xFFFF);
    check_arith(Arith::Xor, Width::DWord, -1, -1, -0x1_0000_0000);
}

#[test]
fn product_is_double_width_and_sign_extended() {
    let upper = 0x7700_0000_0000_0000;
    let rows = [
        (Width::Byte, upper | 0x1_00FF, 2, -2),
        (Width::Byte, upper | 0x80, -0x80, 0x4000),
        (Width::Byte, 0x7F, -0x80, -0x3F80),
        (Width::Word, upper | 0xFFFF, 0x7FFF, -0x7FFF),
        (Width::Word, upper | 0x8000, -0x8000, 0x4000_0000),
        (Width::DWord, upper | 0xFFFF_FFFF, i64::from(i32::MAX), -i64::from(i32::MAX)),
        (Width::DWord, 0x8000_0000, i64::from(i32::MIN), 0x4000_0000_0000_0000),
        (Width::DWord, upper, 12, 0),
    ];
    for (width, dr, operand, result) in rows {
        check_arith(Arith::Mul, width, dr, operand, result);
    }
}

#[test]
fn quotient_takes_a_dividend_of_double_width() {
    let upper = 0x7700_0000_0000_0000;
    let rows = [
        (Width::Byte, upper + 1000, 7, 142),
        (Width::Byte, upper | 0xFFF9, 2, -3), // -7 / 2, towards zero
        (Width::Byte, 7, -2, -3),
        (Width::Byte, upper | 0x8000, -1, 0x8000), // -32768 / -1 fits 32 bits
        (Width::Word, upper + 100_000, 300, 333),
        (Width::Word, upper | 0x8000_0000, 2, -0x4000_0000),
        (Width::Word, 0x8000_0000, 1, i64::from(i32::MIN)),
        (Width::DWord, 0x7FFF_FFFF, 1, 0x7FFF_FFFF),
        (Width::DWord, 0x1_0000_0000, 3, 0x5555_5555),
        (Width::DWord, -0x1_0000_0000, 2, i64::from(i32::MIN)),
        (Width::DWord, -7, -2, 3),
    ];
    for (width, dr, operand, result) in rows {
        check_arith(Arith::Div, width, dr, operand, result);
    }
}

#[test]
fn division_by_zero_faults_at_every_width() {
    for width in [Width::Byte, Width::Word, Width::DWord] {
        let op = arith(Arith::Div, Source::Int(0), width);
        check_fault(&[op], registers(), &[], 0, FaultKind::DivisionByZero);
        check_fault(&[arith(Arith::Div, mem(A), width)], registers(), &[], 0, FaultKind::DivisionByZero);
    }
    for zero in [0.0, -0.0] {
        let op = arith(Arith::Div, Source::Real(zero), Width::Real);
        check_fault(&[op], registers(), &[], 0, FaultKind::DivisionByZero);
    }
}

#[test]
fn quotient_beyond_32_bits_faults() {
    for (width, dr, divisor) in [
        (Width::Word, 0x8000_0000, -1),
        (Width::DWord, 0x8000_0000, 1),
        (Width::DWord, -0x8000_0001, 1),
        (Width::DWord, i64::MIN, -1),
        (Width::DWord, i64::MIN, i64::from(i32::MIN)),
    ] {
        let op = arith(Arith::Div, Source::Int(divisor), width);
        check_fault(&[op], with_dr(dr), &[], 0, FaultKind::QuotientOverflow);
    }
}

#[test]
fn real_arithmetic_writes_both_registers() {
    let real = |dr_real: f64, dr: i64| Registers { dr, dr_real, ..registers() };
    let rows = [
        (Arith::Add, 1.25, 1.25, 2.5, 2),
        (Arith::Sub, 1.25, 2.75, -1.5, -2),
        (Arith::Mul, -3.0, 0.5, -1.5, -2),
        (Arith::Div, 1.0, 8.0, 0.125, 0),
        (Arith::Mul, 1e200, 1e200, f64::INFINITY, i64::MAX),
        (Arith::Sub, f64::INFINITY, f64::INFINITY, f64::NAN, 0),
    ];
    for (op, a, b, result, integer) in rows {
        let after = real(result, integer);
        check(&[arith(op, Source::Real(b), Width::Real)], real(a, 77), &[], after, &[]);
        let memory = b.to_le_bytes();
        check(&[arith(op, mem(A), Width::Real)], real(a, 77), &[(A, &memory)], after, &[]);
    }
}

#[test]
fn integer_arithmetic_never_touches_dr_real() {
    for op in [Arith::Add, Arith::Sub, Arith::Mul, Arith::Div, Arith::Or, Arith::And, Arith::Xor] {
        let ops =
            [arith(op, Source::Int(1), Width::Word), Op::Unary { op: Unary::Negate, width: Width::QWord }];
        let before = Registers { dr: 0, dr_real: 3.5, ..registers() };
        let result = match op {
            Arith::Add | Arith::Or | Arith::Xor => -1,
            Arith::Sub => -0xFFFF,
            Arith::Mul | Arith::Div | Arith::And => 0,
        };
        check(&ops, before, &[], Registers { dr: result, ..before }, &[]);
    }
}

#[test]
fn comparison_is_signed_at_its_width() {
    // DR and operand at the width, and their order.
    let rows = [(-1, 1, -1), (1, -1, 1), (5, 5, 0), (-3, -3, 0), (-128, 127, -1), (127, -128, 1)];
    for width in WIDTHS {
        for (a, b, order) in rows {
            let high_bits = if width == Width::QWord { 0 } else { 0x55 << 56 };
            let low = if width == Width::QWord { -1 } else { (1_i64 << width.bits()) - 1 };
            let dr = high_bits | a & low;
            for (op, holds) in [
                (Compare::Eq, order == 0),
                (Compare::Lt, order < 0),
                (Compare::Gt, order > 0),
                (Compare::Le, order <= 0),
                (Compare::Ge, order >= 0),
            ] {
                let before = Registers { rlo: !holds, dr, ..registers() };
                let after = Registers { rlo: holds, ..before };
                let compare = |src| Op::Compare { op, src, width, if_rlo: false };
                check(&[compare(Source::Int(b))], before, &[], after, &[]);
                let bytes = b.to_le_bytes();
                check(&[compare(mem(A))], before, &[(A, &bytes[..width.bytes() as usize])], after, &[]);
            }
        }
    }
}

#[test]
fn negative_byte_is_not_equal_to_255_as_a_constant() {
    let ops = [
        Op::Load { src: mem(A), width: Width::Byte, neg: false },
        Op::Compare { op: Compare::Eq, src: Source::Int(255), width: Width::DWord, if_rlo: false },
    ];
    let after = Registers { rlo: false, dr: -1, ..registers() };
    check(&ops, with_rlo(true), &[(A, &[0xFF])], after, &[]);
}

#[test]
fn real_comparison_uses_dr_real_and_nan_compares_with_nothing() {
    for (a, b, holds) in [
        (1.0, 2.0, [false, true, false, true, false]),
        (2.0, 1.0, [false, false, true, false, true]),
        (2.0, 2.0, [true, false, false, true, true]),
        (0.0, -0.0, [true, false, false, true, true]),
        (f64::NAN, 1.0, [false; 5]),
        (1.0, f64::NAN, [false; 5]),
    ] {
        let ops = [Compare::Eq, Compare::Lt, Compare::Gt, Compare::Le, Compare::Ge];
        for (op, holds) in ops.into_iter().zip(holds) {
            let before = Registers { rlo: !holds, dr_real: a, ..registers() };
            let compare = Op::Compare { op, src: Source::Real(b), width: Width::Real, if_rlo: false };
            check(&[compare], before, &[], Registers { rlo: holds, ..before }, &[]);
        }
    }
}

#[test]
fn eq1_compares_only_while_rlo_is_1() {
    let eq1 =
        |operand, width| Op::Compare { op: Compare::Eq, src: Source::Int(operand), width, if_rlo: true };
    for width in WIDTHS {
        let before = |rlo| Registers { rlo, dr: 7, ..registers() };
        check(&[eq1(7, width)], before(true), &[], before(true), &[]);
        check(&[eq1(8, width)], before(true), &[], before(false), &[]);
        check(&[eq1(7, width)], before(false), &[], before(false), &[]);
        check(&[eq1(8, width), eq1(7, width)], before(true), &[], before(false), &[]);
    }
}

#[test]
fn one_operand_arithmetic_stays_in_its_width() {
    let upper = |width: Width, low: i64| match width {
        Width::Byte => 0x5A5A_5A5A_5A5A_5A00 | low & 0xFF,
        Width::Word => 0x5A5A_5A5A_5A5A_0000 | low & 0xFFFF,
        Width::DWord => 0x5A5A_5A5A_0000_0000 | low & 0xFFFF_FFFF,
        _ => low,
    };
    for width in WIDTHS {
        let min = i64::MIN >> (64 - width.bits());
        let max = !min;
        let rows = [
            (Unary::Increment, 41, 42),
            (Unary::Increment, -1, 0),
            (Unary::Increment, max, min),
            (Unary::Decrement, 0, -1),
            (Unary::Decrement, min, max),
            (Unary::Negate, 5, -5),
            (Unary::Negate, 0, 0),
            (Unary::Negate, min, min),
            (Unary::Absolute, -5, 5),
            (Unary::Absolute, 5, 5),
            (Unary::Absolute, min, min),
        ];
        for (op, before, after) in rows {
            let (before, after) = (with_dr(upper(width, before)), with_dr(upper(width, after)));
            check(&[Op::Unary { op, width }], before, &[], after, &[]);
        }
    }
}

#[test]
fn one_operand_real_arithmetic_writes_both_registers() {
    let real = |dr_real: f64, dr: i64| Registers { dr, dr_real, ..registers() };
    for (op, value, result, integer) in [
        (Unary::Increment, 0.5, 1.5, 2),
        (Unary::Decrement, 0.5, -0.5, 0),
        (Unary::Negate, 2.5, -2.5, -2),
        (Unary::Absolute, -2.5, 2.5, 2),
        (Unary::Negate, 0.0, -0.0, 0),
    ] {
        let op = Op::Unary { op, width: Width::Real };
        check(&[op], real(value, 99), &[], real(result, integer), &[]);
    }
}

#[test]
fn bcd_increment_wraps_after_9999() {
    let upper = 0x7FFF_0000_0000_0000;
    for (before, after) in [(0x0000, 0x0001), (0x0009, 0x0010), (0x0999, 0x1000), (0x9999, 0x0000)] {
        check(&[Op::IncrementBcd], with_dr(upper | before), &[], with_dr(upper | after), &[]);
    }
    for bad in [0x000A, 0x00A0, 0x0F00, 0xB000] {
        check_fault(&[Op::IncrementBcd], with_dr(bad), &[], 0, FaultKind::BcdRange);
    }
}

#[test]
fn bcd_to_binary_keeps_the_upper_bits() {
    let upper = 0x7FFF_0000_0000_0000;
    for (bcd, value) in [(0x0000, 0), (0x1234, 1234), (0x9999, 9999)] {
        let op = Op::BcdToBin(Width::Word);
        check(&[op], with_dr(upper | 0xAAAA_0000 | bcd), &[], with_dr(upper | 0xAAAA_0000 | value), &[]);
    }
    for (bcd, value) in [
        (0x1234_5678, 12_345_678),
        (0x7999_9999, 79_999_999),
        (0x8000_0001, 0xFFFF_FFFF), // -1
        (0x8000_0000, 0),
        (0xF999_9999, 0xFFFF_FFFF - 79_999_998),
    ] {
        check(&[Op::BcdToBin(Width::DWord)], with_dr(upper | bcd), &[], with_dr(upper | value), &[]);
    }
    check_fault(&[Op::BcdToBin(Width::Word)], with_dr(0x12A4), &[], 0, FaultKind::BcdRange);
    check_fault(&[Op::BcdToBin(Width::DWord)], with_dr(0x0A00_0000), &[], 0, FaultKind::BcdRange);
}

#[test]
fn binary_to_bcd_rejects_negative_and_long_numbers() {
    let upper = 0x7FFF_0000_0000_0000;
    for (value, bcd) in [(0, 0), (1234, 0x1234), (9999, 0x9999)] {
        check(&[Op::BinToBcd(Width::Word)], with_dr(upper | value), &[], with_dr(upper | bcd), &[]);
    }
    for (value, bcd) in [(12_345_678, 0x1234_5678), (99_999_999, 0x9999_9999)] {
        check(&[Op::BinToBcd(Width::DWord)], with_dr(upper | value), &[], with_dr(upper | bcd), &[]);
    }
    for (width, bad) in [
        (Width::Word, 10_000),
        (Width::Word, 0xFFFF),
        (Width::DWord, 100_000_000),
        (Width::DWord, 0xFFFF_FFFF),
    ] {
        check_fault(&[Op::BinToBcd(width)], with_dr(bad), &[], 0, FaultKind::BcdRange);
    }
}

#[test]
fn shift_fills_with_zeros_and_keeps_the_upper_bits() {
    let dr = 0x8182_8384_8586_8788_u64 as i64;
    let rows = [
        (Width::Byte, true, 1, 0x8182_8384_8586_8710_u64),
        (Width::Byte, false, 1, 0x8182_8384_8586_8744),
        (Width::Byte, false, 8, 0x8182_8384_8586_8700),
        (Width::Word, true, 4, 0x8182_8384_8586_7880),
        (Width::Word, false, 4, 0x8182_8384_8586_0878),
        (Width::Word, true, 16, 0x8182_8384_8586_0000),
        (Width::DWord, true, 8, 0x8182_8384_8687_8800),
        (Width::DWord, false, 31, 0x8182_8384_0000_0001),
        (Width::DWord, false, 32, 0x8182_8384_0000_0000),
        (Width::QWord, true, 8, 0x8283_8485_8687_8800),
        (Width::QWord, false, 63, 1),
        (Width::QWord, true, 64, 0),
        (Width::QWord, true, 0, 0x8182_8384_8586_8788),
        (Width::Word, false, 255, 0x8182_8384_8586_0000),
    ];
    for (width, left, count, result) in rows {
        let shift = |count| Op::Shift { left, count, width };
        let after = with_dr(result as i64);
        check(&[shift(Source::Int(count))], with_dr(dr), &[], after, &[]);
        check(&[shift(mem(A))], with_dr(dr), &[(A, &[count as u8])], after, &[]);
    }
    // Constants are not cut to a byte.
    let far = Op::Shift { left: true, count: Source::Int(256), width: Width::QWord };
    check(&[far], with_dr(dr), &[], with_dr(0), &[]);
}

#[test]
fn dr_test_looks_at_its_width_or_bit() {
    for width in WIDTHS {
        let bits = width.bits();
        let top = 1_i64 << (bits - 1);
        let test = Op::DrToRlo(DrTest::NonZero(width));
        let before = |rlo, dr| Registers { rlo, dr, ..registers() };
        check(&[test], before(false, top), &[], before(true, top), &[]);
        check(&[test], before(true, 0), &[], before(false, 0), &[]);
        if bits < 64 {
            let above = 1_i64 << bits;
            check(&[test], before(true, above), &[], before(false, above), &[]);
        }
    }
    for bit in 0..32 {
        let test = Op::DrToRlo(DrTest::Bit(bit));
        let dr = 1_i64 << bit;
        let before = |rlo, dr| Registers { rlo, dr, ..registers() };
        check(&[test], before(false, dr), &[], before(true, dr), &[]);
        check(&[test], before(true, !dr), &[], before(false, !dr), &[]);
    }
}

#[test]
fn rlo_fills_its_width_of_dr() {
    for (width, ones, zeros) in [
        (Width::Byte, 0x0123_4567_89AB_CDFF, 0x0123_4567_89AB_CD00),
        (Width::Word, 0x0123_4567_89AB_FFFF, 0x0123_4567_89AB_0000),
        (Width::DWord, 0x0123_4567_FFFF_FFFF, 0x0123_4567_0000_0000),
        (Width::QWord, -1, 0),
    ] {
        let op = Op::RloToDr(width);
        check(&[op], with_rlo(true), &[], Registers { rlo: true, dr: ones, ..registers() }, &[]);
        check(&[op], with_rlo(false), &[], with_dr(zeros), &[]);
    }
}

#[test]
fn conversion_to_real_sign_extends_from_its_width() {
    for (width, dr, value) in [
        (Width::Byte, 0x1280, -128),
        (Width::Word, 0x7_FFFE, -2),
        (Width::Word, 0x7_0123, 0x123),
        (Width::DWord, 0x1_8000_0000, i64::from(i32::MIN)),
        (Width::QWord, -5, -5),
    ] {
        let after = Registers { dr: value, dr_real: value as f64, ..registers() };
        check(&[Op::IntToReal(width)], with_dr(dr), &[], after, &[]);
    }
    // 2^53 + 1 has no double; the integer stays exact.
    let odd = (1 << 53) + 1;
    let after = Registers { dr: odd, dr_real: 9_007_199_254_740_992.0, ..registers() };
    check(&[Op::IntToReal(Width::QWord)], with_dr(odd), &[], after, &[]);
}
