//! Fused equations: a run of `LDR LA LO LX CA` followed by `WR`, evaluated without branches.
//!
//! A term reads a bit `b` and turns RLO into `(RLO and keep[b]) xor flip[b]`; the two tables have two bits
//! each, indexed by `b`. That covers every function and negation:
//!
//! | term | keep | flip |        | term | keep | flip |
//! |------|------|------|--------|------|------|------|
//! | LDR  | 00   | 10   |        | LX   | 11   | 10   |
//! | LA   | 10   | 00   |        | CA   | 11   | 11   |
//! | LO   | 01   | 10   |        |      |      |      |

use alloc::vec;
use alloc::vec::Vec;

use technol_image::op::{BitRef, Logic, Op};

use crate::code::Fast;

/// Longest fused run in operations.
pub(crate) const MAX_LEN: usize = 64;

/// One operation of a fused equation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    addr: u32,
    bit: u8,
    keep: u8,
    flip: u8,
}

impl Term {
    const fn write(bit: BitRef) -> Term {
        Term { addr: bit.addr, bit: bit.bit, keep: 0, flip: 0 }
    }

    /// `keep` and `flip` for a plain operand; a negated one exchanges their two bits.
    const fn read(bit: BitRef, neg: bool, keep: u8, flip: u8) -> Term {
        const fn exchanged(table: u8) -> u8 {
            (table & 1) << 1 | table >> 1
        }
        if neg {
            Term { addr: bit.addr, bit: bit.bit, keep: exchanged(keep), flip: exchanged(flip) }
        } else {
            Term { addr: bit.addr, bit: bit.bit, keep, flip }
        }
    }
}

/// RLO after the `logic` terms.
#[inline]
pub(crate) fn evaluate(terms: &[Term], memory: &[u8], rlo: bool) -> bool {
    let mut rlo = u8::from(rlo);
    for term in terms {
        let b = memory[term.addr as usize] >> term.bit & 1;
        rlo = (rlo & term.keep >> b) ^ term.flip >> b;
    }
    rlo & 1 != 0
}

/// Stores RLO in the bits of the `writes` terms.
#[inline]
pub(crate) fn store(terms: &[Term], memory: &mut [u8], rlo: bool) {
    for term in terms {
        let byte = &mut memory[term.addr as usize];
        *byte = *byte & !(1 << term.bit) | u8::from(rlo) << term.bit;
    }
}

fn logic_term(op: &Op) -> Option<Term> {
    match *op {
        Op::Ldr { bit, neg, push: false } if !bit.indexed => Some(Term::read(bit, neg, 0b00, 0b10)),
        Op::Logic { op, bit, neg } if !bit.indexed => Some(match op {
            Logic::And => Term::read(bit, neg, 0b10, 0b00),
            Logic::Or => Term::read(bit, neg, 0b01, 0b10),
            Logic::Xor => Term::read(bit, neg, 0b11, 0b10),
        }),
        // Reads byte 0 of memory and ignores it.
        Op::Complement => Some(Term { addr: 0, bit: 0, keep: 0b11, flip: 0b11 }),
        _ => None,
    }
}

fn write_term(op: &Op) -> Option<Term> {
    match *op {
        Op::Write(bit) if !bit.indexed => Some(Term::write(bit)),
        _ => None,
    }
}

/// The table of fast entries and the terms they use. Every operation of a run gets an entry for the rest of
/// the run, so that a jump or a resume into its middle is fast too.
pub(crate) fn fuse(code: &[Op]) -> (Vec<Fast>, Vec<Term>) {
    let mut fast = vec![Fast::General; code.len()];
    let mut terms = Vec::new();
    let mut pc = 0;
    while pc < code.len() {
        let rest = &code[pc..code.len().min(pc + MAX_LEN)];
        let first = terms.len();
        terms.extend(rest.iter().map_while(logic_term));
        let logic = terms.len() - first;
        terms.extend(rest[logic..].iter().map_while(write_term));
        let len = terms.len() - first;
        if len < 2 {
            terms.truncate(first);
            pc += 1;
            continue;
        }
        for i in 0..len {
            fast[pc + i] = Fast::Equation {
                first: (first + i) as u32,
                logic: logic.saturating_sub(i) as u8,
                writes: (len - i.max(logic)) as u8,
            };
        }
        pc += len;
    }
    (fast, terms)
}
