//! Arithmetic, comparison and conversion on DR and DR_REAL (manual 3.9 to 3.15).

use core::cmp::Ordering;

use technol_image::op::{Arith, Compare, DrTest, Unary, Width};

use crate::decimal::{from_bcd, to_bcd};
use crate::fault::FaultKind;
use crate::registers::{Registers, mask, sign_extend};

/// AD, SU, MULB, DIVB, ORB, ANDB, XORB with an integer operand, sign-extended from `width`.
#[inline]
pub(crate) fn integer(op: Arith, regs: &mut Registers, operand: i64, width: Width) -> Result<(), FaultKind> {
    let dr = regs.dr;
    match op {
        Arith::Add => regs.set_low(width, dr.wrapping_add(operand)),
        Arith::Sub => regs.set_low(width, dr.wrapping_sub(operand)),
        Arith::Or => regs.set_low(width, dr | operand),
        Arith::And => regs.set_low(width, dr & operand),
        Arith::Xor => regs.set_low(width, dr ^ operand),
        // Operands of at most 32 bits, so the product always fits.
        Arith::Mul => regs.dr = regs.low(width).wrapping_mul(sign_extend(width, operand)),
        Arith::Div => regs.dr = quotient(dividend(regs, width), sign_extend(width, operand))?,
    }
    Ok(())
}

/// DIVB takes a dividend of twice the operand's width.
fn dividend(regs: &Registers, width: Width) -> i64 {
    match width {
        Width::Byte => regs.low(Width::Word),
        Width::Word => regs.low(Width::DWord),
        Width::DWord | Width::QWord | Width::Real => regs.dr,
    }
}

/// Truncated towards zero; the original processor divides into 32 bits and traps beyond.
fn quotient(dividend: i64, divisor: i64) -> Result<i64, FaultKind> {
    if divisor == 0 {
        return Err(FaultKind::DivisionByZero);
    }
    let quotient = dividend.checked_div(divisor).ok_or(FaultKind::QuotientOverflow)?;
    if i32::try_from(quotient).is_err() {
        return Err(FaultKind::QuotientOverflow);
    }
    Ok(quotient)
}

/// AD, SU, MULB, DIVB with a real operand. ORB, ANDB, XORB take none (rejected at load).
pub(crate) fn real(op: Arith, regs: &mut Registers, operand: f64) -> Result<(), FaultKind> {
    let a = regs.dr_real;
    let result = match op {
        Arith::Add => a + operand,
        Arith::Sub => a - operand,
        Arith::Mul => a * operand,
        Arith::Div if operand == 0.0 => return Err(FaultKind::DivisionByZero),
        Arith::Div => a / operand,
        Arith::Or | Arith::And | Arith::Xor => a,
    };
    // One bit pattern for every NaN: processors differ in the sign and payload they produce.
    regs.set_real(if result.is_nan() { f64::NAN } else { result });
    Ok(())
}

/// EQ…GE on the low `width` bits of DR, signed.
#[inline]
pub(crate) fn compare_integer(op: Compare, regs: &Registers, operand: i64, width: Width) -> bool {
    let (a, b) = (regs.low(width), operand);
    match op {
        Compare::Eq => a == b,
        Compare::Lt => a < b,
        Compare::Gt => a > b,
        Compare::Le => a <= b,
        Compare::Ge => a >= b,
    }
}

/// EQ…GE on DR_REAL; nothing compares with NaN.
pub(crate) fn compare_real(op: Compare, regs: &Registers, operand: f64) -> bool {
    match (op, regs.dr_real.partial_cmp(&operand)) {
        (_, None) => false,
        (Compare::Eq, Some(order)) => order == Ordering::Equal,
        (Compare::Lt, Some(order)) => order == Ordering::Less,
        (Compare::Gt, Some(order)) => order == Ordering::Greater,
        (Compare::Le, Some(order)) => order != Ordering::Greater,
        (Compare::Ge, Some(order)) => order != Ordering::Less,
    }
}

/// INR, DCR, INV, ABS.
#[inline]
pub(crate) fn unary(op: Unary, regs: &mut Registers, width: Width) {
    if width == Width::Real {
        let value = regs.dr_real;
        let result = match op {
            Unary::Increment => value + 1.0,
            Unary::Decrement => value - 1.0,
            Unary::Negate => -value,
            Unary::Absolute => value.abs(),
        };
        regs.set_real(if result.is_nan() { f64::NAN } else { result });
        return;
    }
    let value = regs.low(width);
    let result = match op {
        Unary::Increment => value.wrapping_add(1),
        Unary::Decrement => value.wrapping_sub(1),
        Unary::Negate => value.wrapping_neg(),
        Unary::Absolute => value.wrapping_abs(),
    };
    regs.set_low(width, result);
}

/// INRBCD: 0..9999, 9999 becomes 0.
pub(crate) fn increment_bcd(regs: &mut Registers) -> Result<(), FaultKind> {
    let value = from_bcd(u32::from(regs.dr as u16)).ok_or(FaultKind::BcdRange)?;
    regs.set_low(Width::Word, i64::from(to_bcd((value + 1) % 10_000)));
    Ok(())
}

/// BIN; at DWord bit 31 means negative and the other bits are the magnitude.
pub(crate) fn bcd_to_binary(regs: &mut Registers, width: Width) -> Result<(), FaultKind> {
    let value = if width == Width::DWord {
        let bcd = regs.dr as u32;
        let magnitude = i64::from(from_bcd(bcd & 0x7FFF_FFFF).ok_or(FaultKind::BcdRange)?);
        if bcd >> 31 == 1 { -magnitude } else { magnitude }
    } else {
        i64::from(from_bcd(u32::from(regs.dr as u16)).ok_or(FaultKind::BcdRange)?)
    };
    regs.set_low(width, value);
    Ok(())
}

/// BCD: at most 9999, at DWord 99999999.
pub(crate) fn binary_to_bcd(regs: &mut Registers, width: Width) -> Result<(), FaultKind> {
    let limit = if width == Width::DWord { 99_999_999 } else { 9_999 };
    match u32::try_from(regs.low(width)) {
        Ok(value) if value <= limit => {
            regs.set_low(width, i64::from(to_bcd(value)));
            Ok(())
        }
        _ => Err(FaultKind::BcdRange),
    }
}

/// RL, RR: logical; a count at or above the width gives 0.
#[inline]
pub(crate) fn shift(regs: &mut Registers, left: bool, count: u64, width: Width) {
    let value = (regs.dr & mask(width)) as u64;
    let result = if count >= u64::from(width.bits()) {
        0
    } else if left {
        value << count
    } else {
        value >> count
    };
    regs.set_low(width, result as i64);
}

/// CONDR.
#[inline]
pub(crate) fn test(regs: &Registers, test: DrTest) -> bool {
    match test {
        DrTest::NonZero(width) => regs.dr & mask(width) != 0,
        DrTest::Bit(bit) => regs.dr >> bit & 1 != 0,
    }
}
