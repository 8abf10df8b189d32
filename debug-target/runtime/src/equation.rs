//! Equations as tables: `LDR LA LO LX CA`, brackets too, followed by `WR FL FL1`, evaluated without branches.
//!
//! What up to six bits become is a table of 64 results, made when the program is loaded by trying all of them. At run
//! time the bits are gathered into an index. A longer equation is several of those, of which each begins with what the
//! one before it left in RLO.
//!
use alloc::vec::Vec;

use technol_image::op::{BitRef, Cond, Logic, Op};

use crate::memory::Window;

/// Bits that a table is indexed by.
pub(crate) const INPUTS: usize = 6;
/// In each byte all bits but the highest.
const LOW: u64 = u64::from_le_bytes([0x7F; 8]);
/// In each byte the highest bit.
const HIGH: u64 = !LOW;
/// Puts bit 8n + 7 at bit 56 + n.
const BESIDE: u64 = 0x0002_0408_1020_4081;
/// Brackets within a table.
pub(crate) const MAX_NESTING: u8 = 2;

/// Logic of up to [`INPUTS`] bits and RLO.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table {
    /// For either RLO before, bit w: RLO for the gathered bits w.
    results: [u64; 2],
    /// Bytes of the inputs.
    places: [u16; INPUTS],
    /// In byte n the bit of input n.
    mask: u64,
    /// Where RLO goes then.
    pub(crate) write: BitWrite,
}

impl Table {
    /// The bits of its inputs, the first one lowest.
    #[inline]
    pub(crate) fn gather(&self, memory: &Window) -> u8 {
        let byte = |n: usize| u64::from(memory[usize::from(self.places[n])]) << (8 * n);
        let bytes = byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5);
        // The highest bit of each byte that is not 0: nothing is carried into the next one.
        let set = ((bytes & self.mask) + LOW) & HIGH;
        // All of them side by side at the top, since no two products meet.
        (set.wrapping_mul(BESIDE) >> 56) as u8
    }

    /// RLO for these bits, which it also writes.
    #[inline]
    pub(crate) fn evaluate(&self, memory: &mut Window, bits: u8, rlo: bool) -> bool {
        let rlo = self.results[usize::from(rlo)] >> (bits & 63) & 1 != 0;
        self.write.execute(memory, rlo);
        rlo
    }

    /// The table for the first of these operations, and how many they are; `opens`: the first one's push is somebody
    /// else's. `None` when not even the first one fits, or is none of bit logic.
    pub(crate) fn of(ops: &[Op], opens: bool) -> Option<(Table, usize)> {
        let pushes = |n: usize, push: bool| push && !(n == 0 && opens);
        let mut inputs: Vec<BitRef> = Vec::new();
        let (mut steps, mut depth, mut complete) = (Vec::new(), 0, 0);
        for (n, op) in ops.iter().enumerate() {
            let mut slot = |bit: BitRef| {
                let known = inputs.iter().position(|input| *input == bit);
                known.unwrap_or_else(|| {
                    inputs.push(bit);
                    inputs.len() - 1
                })
            };
            let step = match *op {
                Op::Ldr { bit, neg, push } if fits(bit) => {
                    depth += u8::from(pushes(n, push));
                    Step::Load { slot: slot(bit), neg, push: pushes(n, push) }
                }
                Op::Logic { op, bit, neg } if fits(bit) => Step::Logic { op, slot: slot(bit), neg },
                Op::LogicPop(op) if depth > 0 => {
                    depth -= 1;
                    Step::Pop(op)
                }
                Op::Complement => Step::Complement,
                _ => break,
            };
            if inputs.len() > INPUTS || depth > MAX_NESTING {
                break;
            }
            steps.push(step);
            if depth == 0 {
                complete = steps.len();
            }
        }
        (complete > 0).then(|| (Table::new(&inputs, &steps[..complete]), complete))
    }

    fn new(inputs: &[BitRef], steps: &[Step]) -> Table {
        // What is not used looks at a byte that is looked at anyway; another one would make it wait for that.
        let spare = inputs.first().map_or(0, |bit| bit.addr as u16);
        let (mut places, mut mask) = ([spare; INPUTS], 0);
        for (n, bit) in inputs.iter().enumerate().take(INPUTS) {
            places[n] = bit.addr as u16;
            mask |= 1 << (8 * n + usize::from(bit.bit));
        }
        let results = [false, true].map(|rlo| {
            (0..64_u32).fold(0, |results, index| results | u64::from(result(steps, rlo, index)) << index)
        });
        Table { results, places, mask, write: BitWrite::none(spare) }
    }
}

/// The bit can be reached.
fn fits(bit: BitRef) -> bool {
    !bit.indexed && u16::try_from(bit.addr).is_ok()
}

/// An operation whose bit is a place in the index.
#[derive(Clone, Copy, Debug)]
enum Step {
    Load { slot: usize, neg: bool, push: bool },
    Logic { op: Logic, slot: usize, neg: bool },
    Pop(Logic),
    Complement,
}

/// RLO when the gathered bits are `index`.
fn result(steps: &[Step], mut rlo: bool, index: u32) -> bool {
    let bit = |slot: usize| index >> slot & 1 != 0;
    let mut stack = 0_u8;
    for step in steps {
        match *step {
            Step::Load { slot, neg, push } => {
                if push {
                    stack = stack << 1 | u8::from(rlo);
                }
                rlo = bit(slot) ^ neg;
            }
            Step::Logic { op, slot, neg } => rlo = combine(op, rlo, bit(slot) ^ neg),
            Step::Pop(op) => {
                rlo = combine(op, rlo, stack & 1 != 0);
                stack >>= 1;
            }
            Step::Complement => rlo = !rlo,
        }
    }
    rlo
}

/// LA, LO, LX.
#[inline]
pub(crate) fn combine(op: Logic, a: bool, b: bool) -> bool {
    match op {
        Logic::And => a & b,
        Logic::Or => a | b,
        Logic::Xor => a ^ b,
    }
}

/// A bit that is written. For either RLO: what stays of its byte, and what is set in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BitWrite {
    place: u16,
    keep: [u8; 2],
    set: [u8; 2],
}

impl BitWrite {
    /// Writes a byte as it was.
    pub(crate) const fn none(place: u16) -> BitWrite {
        BitWrite { place, keep: [0xFF; 2], set: [0; 2] }
    }

    /// It is not [`none`](BitWrite::none).
    pub(crate) fn is_one(self) -> bool {
        self.keep != [0xFF; 2]
    }

    /// Of an operation that is one.
    pub(crate) fn of(op: &Op) -> Option<BitWrite> {
        // What becomes of the bit when RLO is 0 and when it is 1.
        let (bit, becomes) = match *op {
            Op::Write(bit) => (bit, [Some(false), Some(true)]),
            Op::Flag { value, bit, cond: Cond::Always } => (bit, [Some(value); 2]),
            Op::Flag { value, bit, cond: Cond::IfRlo } => (bit, [None, Some(value)]),
            Op::Flag { value, bit, cond: Cond::IfNotRlo } => (bit, [Some(value), None]),
            _ => return None,
        };
        let mask = 1 << bit.bit;
        let keep = becomes.map(|value| if value.is_some() { !mask } else { 0xFF });
        let set = becomes.map(|value| if value == Some(true) { mask } else { 0 });
        fits(bit).then_some(BitWrite { place: bit.addr as u16, keep, set })
    }

    #[inline]
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "one of two masks is taken from where they lie")]
    pub(crate) fn execute(&self, memory: &mut Window, rlo: bool) {
        let byte = &mut memory[usize::from(self.place)];
        *byte = *byte & self.keep[usize::from(rlo)] | self.set[usize::from(rlo)];
    }
}
