//! Which statements were executed, for those who test a program. Off, it costs a look at an option for each pass.

use alloc::vec;
use alloc::vec::Vec;

use technol_image::op::Pc;

use crate::runtime::Runtime;

/// How often the statement at each operation was executed.
#[derive(Clone, Debug)]
pub(crate) struct Coverage {
    hits: Vec<u32>,
}

impl Coverage {
    pub(crate) fn hit(&mut self, pc: Pc) {
        if let Some(count) = self.hits.get_mut(pc as usize) {
            *count = count.saturating_add(1);
        }
    }
}

impl Runtime {
    /// Counts from now on how often each statement is executed, from zero; or no longer. While it counts,
    /// statements are executed one by one; what they do is the same.
    pub fn count_statements(&mut self, on: bool) {
        self.coverage = on.then(|| Coverage { hits: vec![0; self.program.code.len()] });
    }

    /// For each operation how often a statement that starts there was executed, at most `u32::MAX`; `None` when
    /// nobody counts.
    pub fn statement_counts(&self) -> Option<&[u32]> {
        self.coverage.as_ref().map(|coverage| coverage.hits.as_slice())
    }
}
