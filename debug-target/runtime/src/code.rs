//! Tables derived from the code of a program when it is loaded.
//!
//! `Program::code` stays what it is and is the reference for stepping. Beside it lies one [`Fast`] entry per
//! operation, which the free-running loop looks at first: most of a program is fused there, and break-points are
//! patched there, so that code without one never asks for any.

use alloc::vec;
use alloc::vec::Vec;

use technol_image::Program;
use technol_image::op::{Cond, Op, Pc};
use technol_image::program::ModuleKind;

use crate::context::NO_SEQUENCE;
use crate::data::Data;
use crate::equation::Table;
use crate::fused::{self, Fused, Term};

/// How the free-running loop executes the operation of the same index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fast {
    /// As `Program::code` says.
    General,
    /// A break-point lies here.
    Break,
    /// JUM, JL0, JL1.
    Jump {
        /// Where to.
        target: Pc,
        /// When.
        cond: Cond,
    },
    /// A stretch of fused code, see [`fused`].
    Stretch {
        /// First term.
        first: u32,
        /// Number of terms.
        terms: u8,
        /// Operations they stand for.
        ops: u8,
        /// Values it takes from the equation stack that it has not pushed.
        pops: u8,
    },
}

/// Derived tables.
#[derive(Clone, Debug)]
pub(crate) struct Code {
    pub(crate) fast: Vec<Fast>,
    pub(crate) terms: Vec<Term>,
    pub(crate) tables: Vec<Table>,
    pub(crate) data: Vec<Data>,
    /// The operation starts a statement.
    pub(crate) statement: Vec<bool>,
    /// Sequence the operation belongs to, or [`NO_SEQUENCE`].
    pub(crate) sequence_at: Vec<u16>,
    /// Procedure `_ON_ESET`.
    pub(crate) on_eset: Option<u16>,
    /// Procedure `_ON_EVENT`.
    pub(crate) on_event: Option<u16>,
    /// Procedure `_ON_CMD`.
    pub(crate) on_cmd: Option<u16>,
    /// Entries of `fast` that break-points replaced, in the order of replacement.
    patches: Vec<(Pc, Fast)>,
}

impl Code {
    /// Tables of a validated program.
    pub(crate) fn new(program: &Program) -> Code {
        let len = program.code.len();
        let mut statement = vec![false; len];
        for pc in &program.statements {
            statement[*pc as usize] = true;
        }
        let Fused { fast, terms, tables, data } = fused::fuse(program);
        Code {
            fast,
            terms,
            tables,
            data,
            statement,
            sequence_at: sequence_table(program),
            on_eset: program.procedure("_ON_ESET"),
            on_event: program.procedure("_ON_EVENT"),
            on_cmd: program.procedure("_ON_CMD"),
            patches: Vec::new(),
        }
    }

    pub(crate) fn sequence_of(&self, pc: Pc) -> Option<u16> {
        self.sequence_at.get(pc as usize).copied().filter(|s| *s != NO_SEQUENCE)
    }

    /// Replaces all break-points.
    pub(crate) fn patch(&mut self, pcs: &[Pc]) {
        while let Some((pc, original)) = self.patches.pop() {
            self.fast[pc as usize] = original;
        }
        for pc in pcs {
            self.shorten_before(*pc as usize);
            self.replace(*pc as usize, Fast::Break);
        }
    }

    /// The entries as they would be without break-points.
    pub(crate) fn without_break_points(&self) -> Vec<Fast> {
        let mut fast = self.fast.clone();
        for (pc, original) in self.patches.iter().rev() {
            fast[*pc as usize] = *original;
        }
        fast
    }

    /// Stretches that would run across `pc` end there.
    fn shorten_before(&mut self, pc: usize) {
        for head in (pc.saturating_sub(fused::MAX_LEN)..pc).rev() {
            let entry = fused::shortened(self.fast[head], pc - head, &self.terms);
            if entry != self.fast[head] {
                self.replace(head, entry);
            }
        }
    }

    fn replace(&mut self, at: usize, entry: Fast) {
        self.patches.push((at as Pc, self.fast[at]));
        self.fast[at] = entry;
    }
}

/// For each operation the sequence it belongs to. Sequences must lie in the code and not overlap.
pub(crate) fn sequence_table(program: &Program) -> Vec<u16> {
    let mut table = vec![NO_SEQUENCE; program.code.len()];
    for (number, sequence) in program.sequences.iter().enumerate() {
        table[sequence.start as usize..=sequence.end as usize].fill(number as u16);
    }
    table
}

/// Index of the module whose code contains `pc`.
pub(crate) fn module_of(program: &Program, pc: Pc) -> Option<usize> {
    program.modules.iter().position(|m| (m.start..m.end).contains(&pc))
}

/// Procedure whose body contains `pc`.
pub(crate) fn procedure_of(program: &Program, pc: Pc) -> Option<u16> {
    program.procedures.iter().position(|p| (p.start..p.end).contains(&pc)).map(|n| n as u16)
}

/// The debugger may stop in modules of this kind.
pub(crate) const fn is_stoppable(kind: ModuleKind) -> bool {
    !kind.is_fast() && !matches!(kind, ModuleKind::Cont)
}

/// The operation never continues with the one after it.
pub(crate) fn ends_flow(op: &Op) -> bool {
    matches!(op, Op::ModuleEnd | Op::Return | Op::Jump { cond: Cond::Always, .. })
}
