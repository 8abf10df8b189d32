//! What is done with the memory of a data section: a piece may be reached by its name, by the name of its byte, and by
//! offsets and indexes from a neighbour.

use super::uses::Use;
use crate::semantics::declarations::{Declarations, Declared, What};

/// The uses of each declared name that stands for memory.
pub(super) struct Memory {
    uses: Vec<Option<Use>>,
}

impl Memory {
    /// `uses_of` gives what is done with a name by itself.
    pub(super) fn of(declarations: &Declarations, uses_of: impl Fn(&str) -> Use) -> Memory {
        let starts = starts(declarations);
        let mut shared = vec![Use::default(); starts.len()];
        let mut anywhere = Use::default();
        let mut own = Vec::with_capacity(declarations.names.len());
        let mut holds_bits = vec![false; starts.len()];
        for name in &declarations.names {
            let Some(storage) = storage(name) else {
                own.push(Use::default());
                continue;
            };
            let what = uses_of(&name.name.key());
            own.push(what);
            let Some(start) = starts.get(storage).copied() else { continue };
            if matches!(name.what, What::Bit { .. }) {
                holds_bits[storage] = true;
            } else {
                shared[storage] = shared[storage].and(what);
            }
            if what.any(Use::ANYWHERE) {
                anywhere = anywhere.and(what);
            } else if what.any(Use::WIDE) {
                let after = starts.partition_point(|other| *other < start + 16);
                let before = starts.partition_point(|other| *other < start - 8).saturating_sub(1);
                for piece in &mut shared[before..after] {
                    *piece = piece.and(what);
                }
            }
        }
        let uses = declarations.names.iter().zip(own).map(|(name, own)| {
            let at = storage(name)?;
            // The name of a DFM byte says what its bits are; an initial text is written by the declaration.
            let names_bits = !matches!(name.what, What::Bit { .. }) && holds_bits.get(at).copied()?;
            let what = own.and(shared.get(at).copied()?).and(anywhere);
            let initial = declarations.storage.get(at)?.initial.is_some();
            (!names_bits).then_some(if initial { what.and(Use::WRITE) } else { what })
        });
        Memory { uses: uses.collect() }
    }

    /// What is done with the n-th name; `None` when it stands for no memory that is judged.
    pub(super) fn uses(&self, name: usize) -> Option<Use> {
        self.uses.get(name).copied().flatten()
    }
}

fn storage(name: &Declared) -> Option<usize> {
    match name.what {
        What::Bit { storage, .. } | What::Cell { storage } | What::Area { storage } => Some(storage as usize),
        What::Text { storage, .. } => storage.map(|storage| storage as usize),
        _ => None,
    }
}

/// First byte of each piece, counted from the first one of the section.
fn starts(declarations: &Declarations) -> Vec<i64> {
    let mut at = 0;
    let next = |piece: &crate::semantics::declarations::Storage| {
        let start = at;
        at += i64::from(piece.len);
        start
    };
    declarations.storage.iter().map(next).collect()
}
