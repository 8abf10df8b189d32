//! Noting what is executed, while it is executed.

use technol_image::op::Pc;

use super::{SeenOperation, SeenTerm, Stamp, Trace};
use crate::code::Code;
use crate::fused::{self, Term, Unseen, Witness};
use crate::memory::Window;
use crate::registers::Registers;

/// Who notes what is executed.
pub(crate) trait Recorder {
    /// An operation was executed by itself and left these registers.
    fn operation(&mut self, pc: Pc, regs: &Registers);
    /// Executes the terms of a stretch, of which the first has this number. Gives the number of operations that it
    /// skipped.
    fn stretch(
        &mut self,
        first: usize,
        terms: &[Term],
        code: &Code,
        memory: &mut Window,
        regs: &mut Registers,
    ) -> u32;
}

/// Nobody does.
pub(crate) struct Untraced;

impl Recorder for Untraced {
    #[inline]
    fn operation(&mut self, _: Pc, _: &Registers) {}

    #[inline]
    fn stretch(
        &mut self,
        _: usize,
        terms: &[Term],
        code: &Code,
        memory: &mut Window,
        regs: &mut Registers,
    ) -> u32 {
        fused::execute(terms, code, memory, regs, Unseen)
    }
}

impl Recorder for Trace {
    #[inline]
    fn operation(&mut self, pc: Pc, regs: &Registers) {
        let real = regs.dr_real.to_bits();
        let before = core::mem::replace(&mut self.real, real);
        if let Some(seen) = self.operations.get_mut(self.operation_at[pc as usize] as usize) {
            self.last += 1;
            *seen = SeenOperation {
                stamp: self.last,
                dr: regs.dr,
                dr_real: regs.dr_real,
                real_changed: real != before,
                rlo: regs.rlo,
                stack: regs.stack,
                depth: regs.depth,
            };
        }
    }

    #[inline]
    fn stretch(
        &mut self,
        first: usize,
        terms: &[Term],
        code: &Code,
        memory: &mut Window,
        regs: &mut Registers,
    ) -> u32 {
        match self.terms.get_mut(self.term_at[first] as usize..) {
            Some(seen) => {
                self.last += 1;
                fused::execute(terms, code, memory, regs, Notes { seen: seen.iter_mut(), stamp: self.last })
            }
            None => fused::execute(terms, code, memory, regs, Unseen),
        }
    }
}

/// Notes one term after the other.
struct Notes<'a> {
    seen: core::slice::IterMut<'a, SeenTerm>,
    stamp: Stamp,
}

impl Witness for Notes<'_> {
    #[inline]
    fn term(&mut self, rlo: bool, bits: u8, dr: i64, operand: i64, regs: &Registers) {
        if let Some(seen) = self.seen.next() {
            let (stack, depth) = (regs.stack, regs.depth);
            *seen = SeenTerm { stamp: self.stamp, dr, operand, bits, rlo, stack, depth };
        }
    }

    #[inline]
    fn skip(&mut self, terms: usize) {
        if terms > 0 {
            self.seen.nth(terms - 1);
        }
    }
}
