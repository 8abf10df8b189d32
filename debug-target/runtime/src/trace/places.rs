//! Which operations the terms of traced stretches stand for.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use technol_image::op::Pc;

use super::NONE;
use crate::code::{Code, Fast};
use crate::fused::Term;

/// The operations that a term stands for.
#[derive(Clone, Copy, Debug)]
pub(super) struct TermPlace {
    pub(super) pc: Pc,
    pub(super) operations: u8,
    /// The push of its first operation was done before it.
    pub(super) opens: bool,
}

/// Terms of all stretches with a traced operation, and for those that begin one their places among them.
pub(super) fn traced_terms(code: &Code, operation_at: &[u32]) -> (Vec<u32>, Vec<TermPlace>) {
    let traced = |pcs: Range<usize>| operation_at.get(pcs).is_some_and(|at| at.iter().any(|at| *at != NONE));
    let mut found: Vec<Option<TermPlace>> = vec![None; code.terms.len()];
    let mut heads = Vec::new();
    for (pc, fast) in code.without_break_points().into_iter().enumerate() {
        let Fast::Stretch { first, terms, ops, .. } = fast else { continue };
        if !traced(pc..pc + usize::from(ops)) {
            continue;
        }
        heads.push(first);
        let (mut pc, mut opens) = (pc as Pc, false);
        let terms = code.terms.iter().zip(&mut found).skip(first as usize).take(usize::from(terms));
        for (Term { operations, .. }, place) in terms {
            *place = Some(TermPlace { pc, operations: *operations, opens });
            pc += Pc::from(*operations);
            opens = *operations == 0;
        }
    }
    let mut term_at = vec![NONE; code.terms.len()];
    let (mut places, mut heads) = (Vec::new(), heads.into_iter().peekable());
    for (at, place) in found.into_iter().enumerate() {
        if heads.next_if_eq(&(at as u32)).is_some() {
            term_at[at] = places.len() as u32;
        }
        places.extend(place);
    }
    (term_at, places)
}
