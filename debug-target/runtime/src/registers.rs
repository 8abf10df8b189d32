//! The registers a program works with (manual 3.2).

use technol_image::op::{STACK_DEPTH, Width};

use crate::assembler::RLO;
use crate::fault::FaultKind;

/// Register set of one activation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Registers {
    /// Result of logic operation.
    pub rlo: bool,
    /// Data register, 64 bits; narrower operations work on its low part.
    pub dr: i64,
    /// Real data register.
    pub dr_real: f64,
    /// Index register, added as a signed number to indexed addresses.
    pub bx: u32,
    /// Equation stack: bit 0 is the value pushed last.
    pub stack: u8,
    /// Number of values on the equation stack, 0..=8.
    pub depth: u8,
    /// EAX of the 80386 instructions. Bit 4000h is always 0 here, because that bit of the register is RLO.
    pub eax: u32,
    /// Flags of the 80386 instructions, at their places in EFLAGS: carry 1, parity 4, zero 40h, sign 80h,
    /// overflow 800h.
    pub flags: u16,
}

impl Registers {
    /// EAX as 80386 instructions see it: with RLO as bit 4000h.
    #[must_use]
    pub fn whole_eax(&self) -> u32 {
        self.eax & !RLO | if self.rlo { RLO } else { 0 }
    }

    /// Puts RLO on the equation stack.
    #[inline]
    pub(crate) fn push(&mut self) -> Result<(), FaultKind> {
        if usize::from(self.depth) >= STACK_DEPTH {
            return Err(FaultKind::EquationOverflow);
        }
        self.stack = self.stack << 1 | u8::from(self.rlo);
        self.depth += 1;
        Ok(())
    }

    /// Takes the value pushed last.
    #[inline]
    pub(crate) fn pop(&mut self) -> Result<bool, FaultKind> {
        if self.depth == 0 {
            return Err(FaultKind::EquationUnderflow);
        }
        let top = self.stack & 1 != 0;
        self.stack >>= 1;
        self.depth -= 1;
        Ok(top)
    }

    /// Empties the equation stack.
    #[inline]
    pub(crate) fn close_equation(&mut self) {
        self.stack = 0;
        self.depth = 0;
    }

    /// Writes the low `width` bits of DR; the upper ones stay.
    #[inline]
    pub(crate) fn set_low(&mut self, width: Width, value: i64) {
        let mask = mask(width);
        self.dr = (self.dr & !mask) | (value & mask);
    }

    /// The low `width` bits of DR as a signed number.
    #[inline]
    pub(crate) fn low(&self, width: Width) -> i64 {
        sign_extend(width, self.dr)
    }

    /// Writes a real result and its integer copy (nearest, ties to even, saturated; NaN gives 0).
    #[inline]
    pub(crate) fn set_real(&mut self, value: f64) {
        self.dr_real = value;
        self.dr = nearest_integer(value);
    }
}

/// Ones in the low `width` bits.
#[inline]
pub(crate) const fn mask(width: Width) -> i64 {
    match width {
        Width::Byte => 0xFF,
        Width::Word => 0xFFFF,
        Width::DWord => 0xFFFF_FFFF,
        Width::QWord | Width::Real => -1,
    }
}

/// The low `width` bits of `value` as a signed number.
#[inline]
pub(crate) const fn sign_extend(width: Width, value: i64) -> i64 {
    match width {
        Width::Byte => value as i8 as i64,
        Width::Word => value as i16 as i64,
        Width::DWord => value as i32 as i64,
        Width::QWord | Width::Real => value,
    }
}

/// Nearest integer, ties to even, saturated; NaN gives 0.
pub(crate) fn nearest_integer(value: f64) -> i64 {
    // At and above 2^52 a double has no fraction; below, adding and subtracting 2^52 leaves the rounding to
    // the processor's default mode, which is the one wanted. `as` saturates and turns NaN into 0.
    const NO_FRACTION: f64 = 4_503_599_627_370_496.0;
    let magnitude = value.abs();
    if magnitude < NO_FRACTION {
        ((magnitude + NO_FRACTION) - NO_FRACTION).copysign(value) as i64
    } else {
        value as i64
    }
}
