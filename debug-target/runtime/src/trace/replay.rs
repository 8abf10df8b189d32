//! The operations of a term once more, on what was noted of it.

use technol_image::op::{BitRef, Op, Source};

use super::SeenTerm;
use crate::arithmetic;
use crate::equation::{INPUTS, combine};
use crate::registers::Registers;

/// Registers behind the last of these operations, with which a term begins. `opened`: the push of the first one was
/// done before it. DR_REAL is not among them: no term uses it.
pub(super) fn registers_after(ops: &[Op], seen: &SeenTerm, opened: bool) -> Registers {
    let SeenTerm { rlo, stack, depth, dr, .. } = *seen;
    let mut regs = Registers { rlo, dr, stack, depth, ..Registers::default() };
    let mut inputs = Inputs { known: [None; INPUTS], bits: seen.bits };
    let operand = |source: &Source| match source {
        Source::Int(value) => *value,
        _ => seen.operand,
    };
    for (n, op) in ops.iter().enumerate() {
        match op {
            Op::Ldr { bit, neg, push } => {
                if *push && !(opened && n == 0) {
                    // A term begins only where its pushes fit.
                    let _ = regs.push();
                }
                regs.rlo = inputs.value(*bit) ^ neg;
            }
            Op::Logic { op, bit, neg } => regs.rlo = combine(*op, regs.rlo, inputs.value(*bit) ^ neg),
            // Nor does it begin where it takes what is not there.
            Op::LogicPop(op) => regs.rlo = combine(*op, regs.rlo, regs.pop().unwrap_or_default()),
            Op::Complement => regs.rlo = !regs.rlo,
            Op::Arith { op, src, width } => {
                // What can fault is in no term.
                let _ = arithmetic::integer(*op, &mut regs, operand(src), *width);
            }
            Op::Compare { if_rlo: true, .. } if !regs.rlo => {}
            Op::Compare { op, src, width, .. } => {
                regs.rlo = arithmetic::compare_integer(*op, &regs, operand(src), *width);
            }
            // DR was noted behind the LOD; the others change no register.
            _ => {}
        }
    }
    regs
}

/// Gathered bits, in the order in which the operations name them first.
struct Inputs {
    known: [Option<BitRef>; INPUTS],
    bits: u8,
}

impl Inputs {
    fn value(&mut self, bit: BitRef) -> bool {
        let place = self.known.iter().position(|known| known.is_none_or(|known| known == bit));
        place.is_some_and(|place| {
            self.known[place] = Some(bit);
            self.bits >> place & 1 != 0
        })
    }
}
