//! What the lines of a section declare. Positions are own lines of the section, so that declarations stay equal
//! while other sections change.

use crate::syntax::ast::{Columns, Name};

/// Declarations of one section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Declarations {
    /// Memory in order of declaration.
    pub storage: Vec<Storage>,
    /// Names in order of declaration.
    pub names: Vec<Declared>,
}

/// A piece of memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Storage {
    /// Length in bytes.
    pub len: u32,
    /// Initial content (STR with a text); zero when absent.
    pub initial: Option<Vec<u8>>,
}

/// A declared name.
#[derive(Clone, Debug, PartialEq)]
pub struct Declared {
    /// As written, with its columns.
    pub name: Name,
    /// 0-based own line.
    pub line: u32,
    /// What it stands for.
    pub what: What,
}

/// What a declared name stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A bit of a DFM byte.
    Bit {
        /// Index into [`Declarations::storage`].
        storage: u32,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A cell of 1, 2 or 4 bytes (DFM label, DS 1/2/4).
    Cell {
        /// Index into [`Declarations::storage`].
        storage: u32,
    },
    /// An area without type (DS n).
    Area {
        /// Index into [`Declarations::storage`].
        storage: u32,
    },
    /// A text buffer (STR n).
    Text {
        /// Index into [`Declarations::storage`]; `None` when it lies over another symbol.
        storage: Option<u32>,
        /// Maximum number of characters.
        len: u32,
    },
    /// EQUI: the value, when it could be computed.
    Constant(Option<i64>),
    /// MECH_BEGIN: activation bit, and `name_LINE`.
    Mechanism,
    /// PROC_BEGIN.
    Procedure,
    /// `NAME:` in code; visible in its own section.
    Label,
}

/// Columns of the declared name.
impl Declared {
    /// Where the name stands in its line.
    #[must_use]
    pub fn columns(&self) -> Columns {
        self.name.columns.clone()
    }
}
