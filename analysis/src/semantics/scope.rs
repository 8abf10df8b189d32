//! Names of the project: what is visible where.
//!
//! A scope holds no positions, so that it stays equal while code moves; [`sites`](crate::database::sites) knows
//! where a name is declared. Code does not depend on the whole scope but on
//! [`lookup`](crate::database::lookup) of the names it uses.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use rustc_hash::FxHashMap;
use technol_image::op::Width;

use super::hir::SymbolKey;
use crate::syntax::section::SectionKind;

/// What a symbol stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum SymbolKind {
    /// A bit; its byte is where the symbol lies.
    Bit {
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A system name that only stands for a bit position and has no cell of its own.
    FormalBit {
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A cell with a declared type.
    Cell(Width),
    /// Cells of one type in a row (system arrays); `name[n]` is the n-th.
    Array {
        /// Type of an element.
        element: Width,
        /// Number of elements.
        len: u32,
    },
    /// An area without type.
    Area {
        /// Length in bytes.
        len: u32,
    },
    /// A text buffer.
    Text {
        /// Maximum number of characters; one byte more is reserved.
        len: u32,
    },
    /// A member of a structure (STRUC, or predefined): a typed offset from a base.
    Member {
        /// Byte offset in the structure.
        offset: u32,
        /// Type of an element.
        element: Width,
        /// Number of elements.
        len: u32,
    },
    /// A structure declared by STRUC.
    Structure {
        /// Length in bytes.
        len: u32,
    },
    /// A constant.
    Constant(i64),
    /// A mechanism; stands for its activation bit, whose number the layout gives.
    Mechanism,
    /// `mech_LINE` of a mechanism: a WORD.
    MechanismLine,
    /// A procedure.
    Procedure,
    /// A user instruction.
    Macro,
    /// Declared with a mistake: uses of it are not reported again.
    Unknown,
}

/// A name and what it stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Symbol {
    /// Who owns it, and its key.
    pub key: SymbolKey,
    /// What it is.
    pub kind: SymbolKind,
}

impl Symbol {
    /// Length of the declared memory in bytes; `None` for what has no memory of a known length.
    #[must_use]
    pub fn bytes(&self) -> Option<u32> {
        match self.kind {
            SymbolKind::Bit { .. } | SymbolKind::Mechanism => Some(1),
            SymbolKind::Cell(width) => Some(width.bytes()),
            SymbolKind::Area { len } => Some(len),
            SymbolKind::Array { element, len } => Some(element.bytes() * len),
            SymbolKind::Text { len } => Some(len + 1),
            SymbolKind::MechanismLine => Some(2),
            _ => None,
        }
    }
}

/// A mechanism or procedure in order of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Routine {
    /// Name.
    pub key: SymbolKey,
    /// 0-based file in execution order.
    pub file: u8,
    /// Module kind it stands in, as its enclosing sections, outermost first.
    pub outer: Vec<SectionKind>,
}

/// Names and memory of the project.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scope {
    /// DATA names of all files, constants, mechanisms with their `_LINE` cells, procedures, macros.
    pub globals: FxHashMap<Arc<str>, Symbol>,
    /// DATA_LOCAL names of each file, in execution order.
    pub locals: Vec<FxHashMap<Arc<str>, Symbol>>,
    /// Words that call macros.
    pub macros: FxHashMap<Arc<str>, Symbol>,
    /// Mechanisms in order of files and text; each needs an activation bit and a `name_LINE` WORD.
    pub mechanisms: Vec<Routine>,
    /// Procedures in order of files and text.
    pub procedures: Vec<Routine>,
    /// Constants at which a circle of EQUI values was found.
    pub circular: BTreeSet<Arc<str>>,
    /// Names declared more than once, ascending.
    pub clashes: BTreeMap<SymbolKey, Clash>,
}

/// Why a name clashes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clash {
    /// The same name twice.
    Twice,
    /// A mechanism and a cell or bit of one name.
    MechanismAndCell,
    /// Two EQUI with different values.
    Values,
    /// Local in a file and global.
    LocalAndGlobal,
}
